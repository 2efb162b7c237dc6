// SPDX-License-Identifier: GPL-3.0-or-later
// The same surface in other units: all lengths times a power of two.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <exception>
#include <vector>

#include "mesh/bodies.hpp"
#include "sphere/uniform_directions.hpp"
#include "stress/family.hpp"
#include "stress/methods.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kExponents{-500, -200, -90, -45, -10, 10, 45, 90, 200, 500};
constexpr std::size_t kFaces = 200;

TriangleMesh in_units(TriangleMesh mesh, int exponent) {
  for (Vec3& v : mesh.vertices) v *= std::ldexp(1.0, exponent);
  return mesh;
}

// An ellipsoid, off every axis, so that no coordinate is a small whole number and no two radii are the same.
StabilityScene scene_in_units(int exponent, std::size_t directions) {
  const Vec3 middle(3.1, -2.3, 1.7);
  TriangleMesh mesh = sphere(22.0, kFaces, middle);
  for (Vec3& v : mesh.vertices) v = v.cwiseProduct(Vec3(1.0, 0.9, 1.15));
  StabilityScene scene;
  scene.mesh = in_units(std::move(mesh), exponent);
  scene.directions = uniform_directions(directions, 11);
  return scene;
}

// Look-ups or rays, then what a table keeps.
std::vector<double> answers_of(const StabilityMethod& method, const StabilityScene& scene) {
  const PointQuery answering = method.maker.make();
  std::vector<double> answers(scene.directions.size());
  answering.answer(scene.directions, answers);
  if (answering.stored) {
    const StoredRadii stored = answering.stored();
    answers.insert(answers.end(), stored.radii.begin(), stored.radii.end());
  }
  return answers;
}

// Are all answers those of millimetres times the power of two, bit for bit?
void compare(const std::vector<double>& expected, const std::vector<double>& answers, StabilityCase& row) {
  row.questions = answers.size();
  row.condition = 1.0;
  row.relative_error = 0.0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const double truth = expected[i];
    const double answer = std::ldexp(answers[i], -std::ilogb(row.magnitude));
    if (std::bit_cast<std::uint64_t>(answer) == std::bit_cast<std::uint64_t>(truth)) continue;
    if (std::isnan(truth)) {
      ++row.false_hits;
    } else if (std::isnan(answer)) {
      ++row.missed_hits;
    } else if (!(std::isfinite(answer) && answer > 0.0)) {
      ++row.nan;
    } else {
      ++row.wrong;
      row.relative_error = std::fmax(row.relative_error, std::abs(answer - truth) / truth);
    }
  }
  row.error_over_condition_u = row.relative_error / unit_roundoff(row.scalar);
}

std::vector<StabilityCase> run_units(const StabilityRun& options) {
  const std::size_t directions = options.quick ? 100 : 1000;
  const StabilityScene millimetres = scene_in_units(0, directions);
  std::vector<std::vector<double>> expected;
  for (const StabilityMethod& method : stability_methods(millimetres, {}))
    expected.push_back(answers_of(method, millimetres));
  std::vector<StabilityCase> rows;
  for (const int exponent : kExponents) {
    const StabilityScene scene = scene_in_units(exponent, directions);
    const std::vector<StabilityMethod> methods = stability_methods(scene, {});
    for (std::size_t k = 0; k < methods.size(); ++k) {
      StabilityCase row;
      row.magnitude = std::ldexp(1.0, exponent);
      row.method = methods[k].maker.name;
      row.kind = methods[k].maker.kind;
      row.scalar = methods[k].scalar;
      row.threshold = 0.0;
      try {
        compare(expected[k], answers_of(methods[k], scene), row);
      } catch (const std::exception& error) {
        row.refused = error.what();
      }
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace

StabilityFamily units_family() {
  StabilityFamily family;
  family.name = "units";
  family.parameter = "unit of length over a millimetre, a power of two";
  family.unit = "mm";
  family.expected =
      "from 2^-100 to 2^100 mm every radius is that in millimetres times the power of two, bit for bit; "
      "beyond, the "
      "mesh is refused in one line";
  family.threshold = 0.0;
  family.derivation =
      "a power of two commutes with every rounding as long as no product leaves the range of a double; the "
      "longest "
      "are of six lengths, see mesh/lengths.hpp";
  family.run = run_units;
  return family;
}

}  // namespace impinge::lab
