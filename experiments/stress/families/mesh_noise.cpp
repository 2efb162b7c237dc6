// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh as scanners and segmentations leave it: with holes, faces turned over, and faces that occur twice.
#include <algorithm>
#include <array>
#include <random>
#include <utility>

#include "mesh/bodies.hpp"
#include "sphere/uniform_directions.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kShares{0.0, 0.003, 0.01, 0.03, 0.1, 0.3};

std::vector<StabilityCase> run_mesh_noise(const StabilityRun& run) {
  const auto scenes_at = [&](double share) {
    StabilityScene scene;
    scene.mesh = noisy(sphere(22.0, run.quick ? 400 : 2000, {2.0, -3.0, 1.0}), share, run.seed + 1);
    scene.directions = uniform_directions(run.quick ? 300 : 3000, run.seed);
    return std::vector{scene};
  };
  return sweep(kShares, scenes_at, run, Flaw::one_sided);
}

}  // namespace

TriangleMesh noisy(const TriangleMesh& mesh, double share, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  TriangleMesh result{mesh.vertices, {}};
  for (Face face : mesh.faces) {
    if (uniform(random) < share) continue;
    if (uniform(random) < share) std::swap(face[1], face[2]);
    result.faces.push_back(face);
    if (uniform(random) < share) result.faces.push_back({face[1], face[2], face[0]});
  }
  return result;
}

StabilityFamily mesh_noise_family() {
  return {"mesh_noise",
          "share of the faces that is missing, as many turned over, as many there twice",
          "1",
          "What is there is met, whichever way it is turned and however often; a hole answers nothing, nor "
          "does a look-up beside it.",
          kRadiusThreshold,
          kRadiusDerivation,
          {4.9, 0.88},
          describe(Flaw::one_sided),
          run_mesh_noise};
}

}  // namespace impinge::lab
