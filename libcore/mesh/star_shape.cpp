// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/star_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "files/formatted.hpp"
#include "mesh/lengths.hpp"
#include "sphere/lists.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/triangle_cone.hpp"
#include "sphere/walker.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMostInBucket = 1000;
constexpr double kMeasuringPrecision = 0.5;  // degrees

// As orientation(), which takes long to find that the ends of an edge are in its plane.
int side_of(const Vec3& a, const Vec3& b, const Vec3& v) {
  return v == a || v == b ? 0 : orientation(a, b, v);
}

// Does the plane through the origin, a and b separate the corners of `first` from the corners of `second`?
// Corners may be on the plane.
bool separates(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& first,
               const std::array<Vec3, 3>& second) {
  bool above = true;  // `first` is
  bool below = true;
  for (const auto& [corners, sign] : {std::pair(&first, 1), std::pair(&second, -1)}) {
    for (const Vec3& v : *corners) {
      const int side = sign * side_of(a, b, v);
      above = above && side >= 0;
      below = below && side <= 0;
      if (!above && !below) return false;
    }
  }
  return true;
}

// A cap that holds the directions of a face.
struct Cap {
  Vec3 axis;
  double cos_radius;
  double sin_radius;
};

Cap cap_of(const std::array<Vec3, 3>& corners) {
  Cap cap{Vec3::Zero(), 1.0, 0.0};
  for (const Vec3& v : corners) cap.axis += v.normalized();
  cap.axis.normalize();
  for (const Vec3& v : corners) cap.cos_radius = std::min(cap.cos_radius, cap.axis.dot(v.normalized()));
  cap.sin_radius = std::sqrt(std::max(0.0, 1.0 - cap.cos_radius * cap.cos_radius));
  return cap;
}

// May the caps share a direction? As radii are at most a quarter turn, cosines of their sum can be compared.
bool caps_meet(const Cap& a, const Cap& b) {
  constexpr double slack = 1e-9;
  if (a.cos_radius < 0.0 || b.cos_radius < 0.0) return true;
  return a.axis.dot(b.axis) >= a.cos_radius * b.cos_radius - a.sin_radius * b.sin_radius - slack;
}

// Lists the faces near each entry of a grid whose cells are about as large as a face. Two faces with a common
// direction are both near the entry that is nearest to this direction.
Lists bucket_faces(const std::vector<TriangleCone>& cones) {
  const double size_deg = std::sqrt(4.0 * kPi / static_cast<double>(cones.size() + 1)) / kDegree;
  const Rsid grid = Rsid::with_precision(180.0 / std::round(180.0 / std::clamp(size_deg, 0.5, 30.0)));
  const Rsid::Walker walker = grid.walker();
  std::vector<Lists::Pair> near;
  for (std::uint32_t f = 0; f < cones.size(); ++f) {
    for_each_entry_near(walker, cones[f], grid.covering_radius(), [&](std::size_t entry, const Vec3&) {
      near.push_back({static_cast<std::uint32_t>(entry), f});
    });
  }
  return Lists(grid.size(), near);
}

// The number of pairs that overlap; std::nullopt if some bucket holds too many faces to try all pairs, as
// when the whole mesh fills a small part of the view.
std::optional<std::size_t> count_overlapping_pairs(const std::vector<TriangleCone>& cones) {
  std::vector<Cap> caps;
  caps.reserve(cones.size());
  for (const TriangleCone& cone : cones) caps.push_back(cap_of(cone.corners()));
  const Lists buckets = bucket_faces(cones);
  std::vector<Lists::Pair> listed;
  for (std::uint32_t entry = 0; entry < buckets.size(); ++entry) {
    if (buckets[entry].size() > kMostInBucket) return std::nullopt;
    for (const std::uint32_t f : buckets[entry]) listed.push_back({f, entry});
  }
  const Lists entries(cones.size(), listed);
  std::vector<std::uint32_t> last(cones.size(), 0);  // the face that each was last compared with
  std::size_t found = 0;
  for (std::uint32_t f = 1; f < cones.size(); ++f) {
    for (const std::uint32_t entry : entries[f]) {
      for (const std::uint32_t g : buckets[entry]) {  // in rising order
        if (g >= f) break;
        if (std::exchange(last[g], f) == f || !caps_meet(caps[f], caps[g])) continue;
        found += cones_overlap(cones[g].corners(), cones[f].corners()) ? 1U : 0U;
      }
    }
  }
  return found;
}

void measure_shares(const std::vector<TriangleCone>& cones, StarShapeReport& report) {
  const Rsid grid = Rsid::with_precision(kMeasuringPrecision);
  const Rsid::Walker walker = grid.walker();
  std::vector<std::uint16_t> inside(grid.size(), 0);
  std::vector<bool> met(grid.size(), false);
  for (const TriangleCone& cone : cones) {
    for_each_entry_inside(walker, cone, [&](std::size_t entry, const Vec3& u) {
      met[entry] = true;
      // The boundary does not count, so that a ray through an edge counts once at most.
      if (inside[entry] < UINT16_MAX && place_in_cone(cone.corners(), cone.side(), u) > 0) ++inside[entry];
    });
  }
  double total = 0.0;
  for (std::size_t row = 0; row < grid.size(); row += grid.columns()) {
    const double weight = grid.direction(row).x();  // sin(phi), at theta = 0: area of the patch of each entry
    total += weight * static_cast<double>(grid.columns());
    for (std::size_t i = row; i < row + grid.columns(); ++i) {
      if (met[i]) report.covered += weight;
      if (inside[i] > 1) report.violating += weight;
    }
  }
  report.covered /= total;
  report.violating /= total;
  report.directions = grid.size();
}

}  // namespace

double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double numerator = a.dot(b.cross(c));
  return 2.0 * std::atan2(numerator, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

// The interiors of two convex cones are disjoint exactly if a plane through the apex separates them. The
// normals of such planes form a cone, whose extreme rays are normals of an edge plane of a triangle or of a
// plane through one corner of each. So if any plane separates them, one of these fifteen does.
bool cones_overlap(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (separates(a[k], a[(k + 1) % 3], a, b) || separates(b[k], b[(k + 1) % 3], a, b)) return false;
  }
  for (const Vec3& p : a) {
    for (const Vec3& q : b) {
      if (p.cross(q).squaredNorm() > 0.0 && separates(p, q, a, b)) return false;
    }
  }
  return true;
}

StarShapeReport star_shape(const TriangleMesh& mesh) {
  require_lengths(mesh);
  StarShapeReport report;
  std::vector<TriangleCone> cones;
  for (const Face& face : mesh.faces) {
    const Vec3& a = corner(mesh, face, 0);
    const Vec3& b = corner(mesh, face, 1);
    const Vec3& c = corner(mesh, face, 2);
    const int facing = orientation(a, b, c);
    ++(facing > 0 ? report.front_facing : facing < 0 ? report.back_facing : report.edge_on);
    if (facing == 0) continue;
    report.solid_angle += solid_angle(a, b, c);
    cones.emplace_back(a, b, c);
  }
  measure_shares(cones, report);
  const bool one_side = report.edge_on == 0 && (report.front_facing == 0) != (report.back_facing == 0);
  const auto overlapping = one_side ? count_overlapping_pairs(cones) : std::nullopt;
  report.overlapping_pairs = overlapping.value_or(0);
  report.star_shaped = one_side && overlapping == 0U;
  return report;
}

std::string describe(const StarShapeReport& report) {
  if (report.star_shaped)
    return formatted("star-shaped about the centre (proven), meets %.1f %% of the directions",
                     100.0 * report.covered);
  if (report.violating == 0.0) return "some ray from the centre meets it in more than one point";
  return formatted("rays from the centre meet it more than once in %.3g %% of the directions",
                   100.0 * report.violating);
}

}  // namespace impinge
