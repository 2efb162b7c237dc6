// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/mutated_rays.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sphere/radial_table.hpp"
#include "sphere/schemes/usid.hpp"
#include "stress/methods.hpp"

namespace impinge::lab {
namespace {

Vec3 asked(const Vec3& x, Flaw flaw) {
  const Vec3 u = x.stableNormalized();
  if (flaw == Flaw::arccosine) return to_direction({std::acos(u.z()), std::atan2(u.y(), u.x())});
  if (flaw != Flaw::float_azimuth) return x;
  const auto azimuth = static_cast<float>(std::atan2(u.y(), u.x()));
  return to_direction({std::atan2(std::hypot(u.x(), u.y()), u.z()), static_cast<double>(azimuth)});
}

bool hits(const TriangleCone& cone, const Vec3& x, const Vec3& u, Flaw flaw) {
  if (flaw == Flaw::one_sided && cone.side() < 0) return false;
  if (flaw == Flaw::strict_edges)
    return is_met(cone, x, u) && place_in_cone(cone.corners(), cone.side(), x) > 0;
  if (flaw == Flaw::loose_edges) return cone.least_edge_distance(u.x(), u.y(), u.z()) >= -1e-9;
  if (flaw == Flaw::behind && is_met(cone, -x, -u)) return true;
  const auto& [a, b, c] = cone.corners();
  const Vec3 normal = (b - a).cross(c - a);
  if (flaw == Flaw::thin_left_out && 0.5 * normal.norm() < 1e-6) return false;
  if (flaw == Flaw::steep_left_out && std::abs(normal.dot(u)) < 1e-6 * normal.norm()) return false;
  return is_met(cone, x, u);
}

PointQuery mutated_rays(const TriangleMesh& mesh, Flaw flaw) {
  std::vector<TriangleCone> cones;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (!cone.edge_on()) cones.push_back(cone);
  }
  const Layer layer = flaw == Flaw::farthest ? Layer::farthest : BenchmarkScene::kLayer;
  return one_by_one(
      [cones = std::move(cones), layer, flaw](const Vec3& direction) {
        const Vec3 x = asked(direction, flaw);
        const Vec3 u = x.stableNormalized();
        double radius = kNoSurface;
        for (const TriangleCone& cone : cones) {
          if (hits(cone, x, u, flaw)) keep(radius, cone.radius(u), layer);
        }
        return radius;
      },
      0.0);
}

PointQuery mirrored(PointQuery table) {
  table.answer = [answer = table.answer](std::span<const Vec3> points, std::span<double> out) {
    std::vector<Vec3> other(points.begin(), points.end());
    for (Vec3& x : other) x.x() = -x.x();
    answer(other, out);
  };
  return table;
}

}  // namespace

std::string describe(Flaw flaw) {
  switch (flaw) {
    case Flaw::farthest:
      return "the farther of two hits is kept (a sign)";
    case Flaw::one_sided:
      return "faces seen from behind are left out (a sign)";
    case Flaw::behind:
      return "hits behind the centre count (a sign)";
    case Flaw::strict_edges:
      return "> in place of >= at edges (a sign)";
    case Flaw::loose_edges:
      return "1e-9 beside an edge is a hit (a tolerance)";
    case Flaw::steep_left_out:
      return "faces with |n . u| < 1e-6 |n| are left out (a tolerance)";
    case Flaw::thin_left_out:
      return "faces below 1e-6 mm^2 are left out (a tolerance)";
    case Flaw::arccosine:
      return "the polar angle by an arccosine (a tolerance of 1e-8)";
    case Flaw::float_azimuth:
      return "the azimuth in float (a tolerance)";
    case Flaw::mirrored:
      return "x of a direction with the other sign (a sign)";
  }
  return {};
}

std::optional<StabilityMethod> wrong_on_purpose(const TriangleMesh& mesh, Flaw flaw,
                                                std::span<const StabilityMethod> methods) {
  StabilityMethod wrong;
  if (flaw == Flaw::mirrored) {
    const auto table = std::ranges::find_if(methods, [](const StabilityMethod& method) {
      return method.maker.scheme == Usid::name && method.scalar == Scalar::float64;
    });
    if (table == methods.end()) return std::nullopt;
    wrong = *table;
    wrong.maker.make = [make = table->maker.make] { return mirrored(make()); };
  } else {
    wrong.maker.make = [&mesh, flaw] { return mutated_rays(mesh, flaw); };
  }
  wrong.maker.name = "mutated";
  wrong.maker.kind = "mutated";
  return wrong;
}

}  // namespace impinge::lab
