// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that a ray meets many times: not star-shaped, with ever more pleats. The nearest layer is asked
// for.
#include <array>

#include <Eigen/Geometry>

#include "sphere/uniform_directions.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {
namespace {

constexpr std::array<double, 6> kLayers{2.0, 3.0, 5.0, 8.0, 13.0, 20.0};
constexpr long kAround = 12;    // half the number of faces about the axis
constexpr double kFrom = 25.0;  // degrees from the axis
constexpr double kTo = 65.0;
constexpr std::size_t kFoldSteps = 3;  // of a layer, from one end to the other
const Vec3 kAxis(1.0, 2.0, 2.0);

// Point k of the pleated line in the half-plane of an axis: degrees from the axis, distance from the centre.
std::array<double, 2> profile(std::size_t k) {
  const std::size_t layer = k / kFoldSteps;
  const double share = static_cast<double>(k % kFoldSteps) / kFoldSteps;
  const double forth = layer % 2 == 0 ? share : 1.0 - share;
  // The way up to the next layer is the last step of this one.
  return {kFrom + (kTo - kFrom) * forth, 20.0 + static_cast<double>(layer)};
}

std::vector<StabilityCase> run_fold(const StabilityRun& run) {
  const auto scenes_at = [&](double layers) {
    StabilityScene scene;
    scene.mesh = pleated(static_cast<std::size_t>(layers));
    scene.directions = uniform_directions(run.quick ? 300 : 3000, run.seed);
    return std::vector{scene};
  };
  return sweep(kLayers, scenes_at, run, Flaw::farthest);
}

}  // namespace

TriangleMesh pleated(std::size_t layers) {
  TriangleMesh mesh;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), kAxis);
  const std::size_t rows = layers * kFoldSteps;
  for (std::size_t k = 0; k <= rows; ++k) {
    const auto [degrees, radius] = profile(k);
    for (long i = 0; i < kAround; ++i) {
      const CosSin c = half_turn_fraction(2 * i, kAround);
      const double across = std::sin(degrees * kDegree);
      mesh.vertices.emplace_back(
          turn * (radius * Vec3(across * c.cos, across * c.sin, std::cos(degrees * kDegree))));
    }
  }
  const auto vertex = [](std::size_t row, long i) {
    return static_cast<VertexIndex>(row * kAround + static_cast<std::size_t>(i % kAround));
  };
  for (std::size_t k = 0; k < rows; ++k) {
    for (long i = 0; i < kAround; ++i) {
      mesh.faces.push_back({vertex(k, i), vertex(k + 1, i), vertex(k + 1, i + 1)});
      mesh.faces.push_back({vertex(k, i), vertex(k + 1, i + 1), vertex(k, i + 1)});
    }
  }
  return mesh;
}

StabilityFamily fold_family() {
  return {"fold",
          "layers that a ray meets",
          "1",
          "The nearest layer everywhere; where it changes, a look-up answers nothing.",
          kRadiusThreshold,
          kRadiusDerivation,
          {3.8, 0.86},
          describe(Flaw::farthest),
          run_fold};
}

}  // namespace impinge::lab
