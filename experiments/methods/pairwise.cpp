// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points touch
// @links   gap heap_use CGAL::CGAL
//
// Method pairwise: everything against every triangle, the O(n^2) baseline of the thesis (Tables 4 and 9).
// Nothing is culled. For a pose it is CGAL's triangle test (Guigue and Devillers 2003) on exact predicates.
// Placing the ball counts, and in a free pose all pairs; a pose that touches stops at the first pair that
// meets. For a point it is its ray against every triangle (table/pairwise.hpp).

#include "table/pairwise.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <CGAL/intersections.h>

#include "methods/exact_triangles.hpp"
#include "methods/heap_use.hpp"
#include "methods/points.hpp"

namespace impinge::lab {
namespace {

constexpr double kUnitRounding = 8.0 * 0x1p-53;

// The surface of the scene.
PointQuery rays(const TriangleMesh& mesh) {
  const double before = heap_bytes();
  const auto caster = std::make_shared<const RayCaster>(mesh);
  return one_by_one(
      [caster](const Vec3& x) {
        // Normalising a unit vector once more may move it by an ulp, across the edge that it goes through.
        const bool is_unit = std::abs(x.squaredNorm() - 1.0) < kUnitRounding;
        return caster->cast(is_unit ? x : x.normalized(), BenchmarkScene::kLayer);
      },
      heap_bytes() - before);
}

Touch pairs(const TriangleMesh& ball, const TriangleMesh& socket) {
  return [ball, fixed = exact_triangles(socket)](const Pose& pose) {
    return std::ranges::any_of(exact_triangles(ball, pose), [&](const auto& moved) {
      return std::ranges::any_of(fixed, [&](const auto& other) { return CGAL::do_intersect(moved, other); });
    });
  };
}

}  // namespace

Method pairwise_method() {
  Method method{.name = "pairwise", .label = "pairwise"};
  method.points = [](const BenchmarkScene& scene, const PointSizes&) {
    PointCase one;
    one.kind = "brute";
    one.place = 14;
    one.stability = "pairwise";
    one.make = [&mesh = scene.surface()] { return rays(mesh); };
    return std::vector{one};
  };
  method.touch = [](const BallSocketPair& pair, double /*precision_deg*/) {
    TouchCase one;
    one.place = 0;
    one.touches = pairs(pair.ball, pair.socket);
    return std::vector{one};
  };
  return method;
}

}  // namespace impinge::lab
