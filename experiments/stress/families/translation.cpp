// SPDX-License-Identifier: GPL-3.0-or-later
// A joint whose mesh lies far from the origin of its file.
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh/bodies.hpp"
#include "sphere/uniform_directions.hpp"
#include "stress/family.hpp"
#include "stress/measure.hpp"

namespace impinge::lab {
namespace {

constexpr double kTranslationRadius = 22.0;  // mm
constexpr std::array kDistances{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};

// Factor on the threshold for a joint that is D R away, R its farthest vertex. A coordinate of the file is
// off by u (1 + D) R; the difference from the centre is then exact or rounds once more. A plane inside the
// face moves no more than its corners, sqrt(3) times that each, and the radius moves by 1 + tan psi times
// this, R over r times. That is 2 more than the allowed error of a radius, times 1 + D. In a float the share
// of D that counts is the double's.
double amplification(double distance, Scalar scalar) {
  return 1.0 + distance * unit_roundoff(Scalar::float64) / unit_roundoff(scalar);
}
constexpr double kMoved = 2.0;

TriangleMesh joint() { return sphere(kTranslationRadius, 320, Vec3(2.1, -1.3, 0.7)); }

// The true radii of the joint itself, worked out once for each set of directions.
class Truths {
 public:
  explicit Truths(const TriangleMesh& mesh) : mesh_(mesh) {}

  const RadiusQuestions& of(const std::string& name, const std::vector<Vec3>& directions) {
    auto& [kept, questions] = known_[name];
    if (kept.empty()) {
      kept = directions;
      questions = ask(mesh_, kept);
    }
    return questions;
  }

 private:
  const TriangleMesh& mesh_;
  std::map<std::string, std::pair<std::vector<Vec3>, RadiusQuestions>> known_;
};

// The errors relative to the joint before it was moved.
StabilityCase against_the_joint(const StabilityMethod& method, const StabilityScene& moved, double distance,
                                Truths& truths) {
  StabilityCase row;
  row.magnitude = distance;
  row.method = method.maker.name;
  row.kind = method.maker.kind;
  row.scalar = method.scalar;
  row.refused = method.refused;
  if (method.maker.precision_deg > 0.0) row.precision_deg = method.maker.precision_deg;
  if (!row.refused.empty()) return row;
  const double factor = amplification(distance, row.scalar);
  const bool stored_in_float = row.kind == "ours" && row.scalar == Scalar::float32;
  const double alone = (stored_in_float ? kStoredThreshold : kRadiusThreshold) + kMoved;
  row.threshold = alone * factor;  // while it is judged
  const PointQuery answering = method.maker.make();
  if (answering.stored) {
    const StoredRadii stored = answering.stored();
    judge(row, truths.of(method.maker.scheme, stored.directions), stored.radii);
  } else {
    std::vector<double> answers(moved.directions.size());
    answering.answer(moved.directions, answers);
    judge(row, truths.of("rays", moved.directions), answers);
  }
  row.threshold = alone;
  row.condition *= factor;
  row.error_over_condition_u /= factor;
  row.backward_error_over_u /= factor;
  return row;
}

TriangleMesh moved_to(TriangleMesh mesh, const Vec3& place) {
  for (Vec3& v : mesh.vertices) v += place;
  return mesh;
}

// A program that reads coordinates as floats before it subtracts the centre.
TriangleMesh float_first(const TriangleMesh& file, const Vec3& centre) {
  TriangleMesh mesh = file;
  const Eigen::Vector3f origin = centre.cast<float>();
  for (Vec3& v : mesh.vertices) v = (v.cast<float>() - origin).cast<double>();
  return mesh;
}

std::vector<StabilityCase> run_translation(const StabilityRun& options) {
  const TriangleMesh mesh = joint();
  Truths truths(mesh);
  std::vector<StabilityCase> rows;
  for (const double distance : kDistances) {
    const Vec3 centre = distance * kTranslationRadius * Vec3(0.48, -0.6, 0.64);
    const TriangleMesh file = moved_to(mesh, centre);
    StabilityScene scene;
    scene.mesh = relative_to(file, centre);
    scene.directions = uniform_directions(options.quick ? 100 : 1000, 31);
    for (const StabilityMethod& method : stability_methods(scene, {}))
      rows.push_back(against_the_joint(method, scene, distance, truths));
    StabilityScene rounded = scene;
    rounded.mesh = float_first(file, centre);
    for (StabilityMethod& naive : stability_methods(rounded, {})) {
      if (naive.maker.kind != "brute") continue;
      naive.maker.name = "float_before_centre";
      naive.scalar = Scalar::float32;
      rows.push_back(against_the_joint(naive, rounded, distance, truths));
      rows.push_back(rows.back());
      rows.back().method = rows.back().kind = "mutated";
    }
  }
  return rows;
}

}  // namespace

StabilityFamily translation_family() {
  StabilityFamily family;
  family.name = "translation";
  family.parameter = "distance of the joint from the origin of its file, in radii of the joint";
  family.unit = "R";
  family.expected =
      "what the coordinates of the file have lost by their own rounding, u times the distance, and nothing "
      "more: the "
      "centre is subtracted in double before anything is a float";
  family.threshold = kRadiusThreshold + kMoved;
  family.derivation = std::string(kRadiusDerivation) +
                      "; 2 for the rounding of the file's coordinates, whose condition is "
                      "1 + the distance";
  family.mutation = "coordinates in float before the centre is subtracted (a tolerance)";
  family.seen = {2.9, 0.94};
  family.run = run_translation;
  return family;
}

}  // namespace impinge::lab
