// SPDX-License-Identifier: GPL-3.0-or-later
// Rays that meet a vertex or an edge exactly, or pass a few units in the last place beside it. The
// coordinates of the body are multiples of 1/64 mm: a vertex is a direction through itself, and the sum of
// two is a direction through their edge, without rounding.
#include <array>
#include <cmath>
#include <limits>

#include "mesh/bodies.hpp"
#include "mesh/edges.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {
namespace {

constexpr double kGrid = 64.0;  // coordinate steps per millimetre

double shifted(double x, int ulps) {
  const double towards =
      ulps > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  for (int k = 0; k < std::abs(ulps); ++k) x = std::nextafter(x, towards);
  return x;
}

constexpr std::array<double, 7> kUlps{256.0, 64.0, 16.0, 4.0, 2.0, 1.0, 0.0};

std::vector<StabilityCase> run_ray_through_edge_or_vertex(const StabilityRun& run) {
  const TriangleMesh body = dyadic_body();
  const EdgeList list = edges(body);
  const std::size_t stride = run.quick ? 5 : 1;
  const auto scenes_at = [&](double ulps) {
    StabilityScene scene;
    scene.mesh = body;
    const auto beside = [&](const Vec3& x) {
      const auto more = ulps_beside(x, static_cast<int>(ulps));
      scene.directions.insert(scene.directions.end(), more.begin(), more.end());
    };
    for (std::size_t v = 0; v < body.vertices.size(); v += stride) beside(body.vertices[v]);
    for (std::size_t e = 0; e < list.size(); e += stride) {
      const auto [from, to] = ends(body, list[e].front());
      beside(body.vertices[from] + body.vertices[to]);
    }
    return std::vector{scene};
  };
  return sweep(kUlps, scenes_at, run, Flaw::strict_edges);
}

}  // namespace

TriangleMesh dyadic_body() {
  TriangleMesh mesh = sphere(21.0, 300, {3.0, -2.0, 4.0});
  for (Vec3& v : mesh.vertices) v = (kGrid * v).array().round() / kGrid;
  return mesh;
}

std::vector<Vec3> ulps_beside(const Vec3& x, int ulps) {
  if (ulps == 0) return {x};
  std::vector<Vec3> beside;
  for (Eigen::Index k = 0; k < 3; ++k) {
    for (const int sign : {-1, 1}) {
      beside.push_back(x);
      beside.back()[k] = shifted(x[k], sign * ulps);
    }
  }
  return beside;
}

StabilityFamily ray_through_edge_or_vertex_family() {
  return {
      "ray_through_edge_or_vertex",
      "units in the last place by which a ray passes a vertex or an edge; 0: exactly through it",
      "ulp",
      "No ray slips through a closed body, whichever face it is given to; the radius is that of every face "
      "at the edge.",
      kRadiusThreshold,
      kRadiusDerivation,
      {4.0, 0.9},
      describe(Flaw::strict_edges),
      run_ray_through_edge_or_vertex};
}

}  // namespace impinge::lab
