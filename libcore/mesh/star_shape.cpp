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

// A grid whose cells are about as large as one of so many faces.
Rsid grid_of(std::size_t faces) {
  const double size_deg = std::sqrt(4.0 * kPi / static_cast<double>(faces + 1)) / kDegree;
  return Rsid::with_precision(180.0 / std::round(180.0 / std::clamp(size_deg, 0.5, 30.0)));
}

// The number of pairs of faces that overlap; std::nullopt if some bucket holds too many faces to try all
// pairs, as when the whole mesh fills a small part of the view. A bucket holds the faces near an entry of a
// grid, as `near` says: two faces with a common direction are both near the entry nearest to it.
std::optional<std::size_t> count_overlapping_pairs(const TriangleMesh& mesh, std::size_t entries_of_grid,
                                                   std::vector<Lists::Pair>&& near) {
  const Lists buckets(entries_of_grid, near);
  std::vector<Lists::Pair> listed = std::move(near);  // as many
  listed.clear();
  for (std::uint32_t entry = 0; entry < buckets.size(); ++entry) {
    if (buckets[entry].size() > kMostInBucket) return std::nullopt;
    for (const std::uint32_t f : buckets[entry]) listed.push_back({f, entry});
  }
  const Lists entries(mesh.faces.size(), listed);
  std::vector<Cap> caps;
  caps.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) caps.push_back(cap_of(corners_of(mesh, face)));
  std::vector<std::uint32_t> last(mesh.faces.size(), 0);  // the face that each was last compared with
  std::size_t found = 0;
  for (std::uint32_t f = 1; f < mesh.faces.size(); ++f) {
    for (const std::uint32_t entry : entries[f]) {
      for (const std::uint32_t g : buckets[entry]) {  // in rising order
        if (g >= f) break;
        if (std::exchange(last[g], f) == f || !caps_meet(caps[f], caps[g])) continue;
        found += cones_overlap(corners_of(mesh, mesh.faces[g]), corners_of(mesh, mesh.faces[f])) ? 1U : 0U;
      }
    }
  }
  return found;
}

// Shares of the directions of a grid, as faces are added.
class Shares {
 public:
  void add(const TriangleCone& cone) {
    for_each_entry_inside(walker_, cone, [&](std::size_t entry, const Vec3& u) {
      met_[entry] = true;
      // The boundary does not count, so that a ray through an edge counts once at most.
      if (inside_[entry] < UINT16_MAX && place_in_cone(cone.corners(), cone.side(), u) > 0) ++inside_[entry];
    });
  }
  void write(StarShapeReport& report) const {
    double total = 0.0;
    for (std::size_t row = 0; row < grid_.size(); row += grid_.columns()) {
      const double weight = grid_.direction(row).x();  // sin(phi), at theta = 0: area of each entry's patch
      total += weight * static_cast<double>(grid_.columns());
      for (std::size_t i = row; i < row + grid_.columns(); ++i) {
        if (met_[i]) report.covered += weight;
        if (inside_[i] > 1) report.violating += weight;
      }
    }
    report.covered /= total;
    report.violating /= total;
    report.directions = grid_.size();
  }

 private:
  Rsid grid_ = Rsid::with_precision(kMeasuringPrecision);
  Rsid::Walker walker_ = grid_.walker();
  std::vector<std::uint16_t> inside_ = std::vector<std::uint16_t>(grid_.size(), 0);
  std::vector<bool> met_ = std::vector<bool>(grid_.size(), false);
};

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
  for (const Face& face : mesh.faces) {
    const auto& [a, b, c] = corners_of(mesh, face);
    const int facing = orientation(a, b, c);
    ++(facing > 0 ? report.front_facing : facing < 0 ? report.back_facing : report.edge_on);
    if (facing != 0) report.solid_angle += solid_angle(a, b, c);
  }
  const bool one_side = report.edge_on == 0 && (report.front_facing == 0) != (report.back_facing == 0);
  Shares shares;
  const Rsid grid = grid_of(mesh.faces.size());
  const Rsid::Walker walker = grid.walker();
  std::vector<Lists::Pair> near;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const TriangleCone cone = cone_of(mesh, mesh.faces[f]);
    if (cone.edge_on()) continue;
    shares.add(cone);
    if (!one_side) continue;
    for_each_entry_near(walker, cone, grid.covering_radius(), [&](std::size_t entry, const Vec3&) {
      near.push_back({static_cast<std::uint32_t>(entry), f});
    });
  }
  shares.write(report);
  const auto overlapping =
      one_side ? count_overlapping_pairs(mesh, grid.size(), std::move(near)) : std::nullopt;
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
