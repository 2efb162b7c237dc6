// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_euclidean/gap_bracket.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mesh/jump_edges.hpp"
#include "mesh/triangle_distance.hpp"
#include "sphere/infinity.hpp"
#include "table/face_cap.hpp"

namespace impinge::lab {
namespace {

constexpr double kGridPrecision = 1.0;     // degrees
constexpr double kFarthest = 0.45;         // of |x|: no lower end for a distance beyond it
constexpr double kAngleSlack = 1e-9;       // radians, for rounding
constexpr double kRestRounding = 0x1p-49;  // of 1 - q^2 tan^2 psi: 5 roundings of at most 1, and to spare
constexpr std::size_t kClump = 16;         // jump edges
constexpr double kFirstShare = 0.125;      // of the largest D that may count
constexpr int kHalvings = 8;               // of the range of D

// Largest tan psi of a face, off by less than 512 u (1 + tan psi) of itself (table/error_bound.hpp), from
// outside.
double steepest(const TriangleCone& cone) {
  const double slope = cone.largest_slope();
  const double off = 0x1p-44 * (1.0 + slope);
  return off < 1.0 ? slope / (1.0 - off) : kInfinity;
}

// tan psi where the ray along u ends.
double slope_along(const TriangleCone& cone, const Vec3& u) {
  const Vec3& normal = cone.plane().normal;
  return normal.cross(u).norm() / std::abs(normal.dot(u));
}

// L for the faces that count at this D, seen from a point of that length.
double stretch(const auto& slopes, double length, double D) {
  double slope = 0.0;
  double radius = 0.0;
  for (const auto& near : slopes) {
    if (near.from > D) continue;
    slope = std::max(slope, near.slope);
    radius = std::max(radius, near.radius);
  }
  if (std::isinf(slope)) return kInfinity;
  const double q = D / (length - D);
  const double rest = 1.0 - q * q * slope * slope - kRestRounding;
  double ratio = radius / (length - D);
  if (rest > 0.0) ratio = std::min(ratio, (1.0 + std::sqrt(1.0 - rest * (1.0 - q * q))) / rest);
  return std::hypot(1.0, ratio * slope);
}

}  // namespace

GapBracket::GapBracket(TriangleMesh mesh)
    : mesh_(std::move(mesh)),
      index_(CubeGnomonic::with_precision(kGridPrecision)),
      listed_within_(index_.grid().covering_radius() + kAngleSlack),
      near_(index_.grid().size()) {
  if (mesh_.faces.empty()) {
    throw std::invalid_argument("mesh: it has no faces, so there is no distance to it; read another file");
  }
  for (const JumpEdge& edge : jump_edges(mesh_))
    jumps_.push_back({mesh_.vertices[edge.from], mesh_.vertices[edge.to]});
  clump_jumps();
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) list_face(f);
  index_.sort();
}

// Neighbours in the list are neighbours on the mesh, mostly.
void GapBracket::clump_jumps() {
  for (std::size_t first = 0; first < jumps_.size(); first += kClump) {
    const std::size_t last = std::min(first + kClump, jumps_.size());
    Clump clump{{jumps_[first].from, 0.0}, first, last};
    for (std::size_t k = first; k < last; ++k) {
      for (const Vec3& end : {jumps_[k].from, jumps_[k].to})
        clump.round.radius = std::max(clump.round.radius, (end - clump.round.middle).norm());
    }
    clump.round.radius += kDistanceAllowance * (clump.round.radius + clump.round.middle.norm());
    clumps_.push_back(clump);
  }
}

void GapBracket::list_face(std::size_t f) {
  const TriangleCone cone = cone_of(mesh_, mesh_.faces[f]);
  const auto& c = cone.corners();
  const double radius = std::max({c[0].norm(), c[1].norm(), c[2].norm()});
  farthest_corner_ = std::max(farthest_corner_, radius);
  if (cone.edge_on()) {
    const Vec3 middle = (c[0] + c[1] + c[2]) / 3.0;
    edge_on_.push_back(
        {middle, std::max({(c[0] - middle).norm(), (c[1] - middle).norm(), (c[2] - middle).norm()})});
    return;
  }
  const double slope = steepest(cone);
  index_.add(f, cone, listed_within_, [&](std::size_t entry, const Vec3& u) {
    Near& near = near_[entry];
    near.slope = std::max(near.slope, slope);
    near.radius = std::max(near.radius, radius);
    if (slope > kSteepSlope || !cone.contains(u)) return true;
    near.nearest = std::min(near.nearest, cone.radius(u));
    near.farthest = std::max(near.farthest, cone.radius(u));
    return true;
  });
}

// Calls visit(near, direction) for the entries within that angle of unit u, and those next to them: one of
// them lists any face that is seen within the angle.
template <class Visit>
void GapBracket::for_each_within(const Vec3& u, double angle, Visit&& visit) const {
  const double wide = angle + listed_within_;
  const double least = std::cos(wide + kAngleSlack);
  index_.for_each_near(TriangleCone(u, u, u), wide, [&](std::size_t entry, const Vec3& direction) {
    if (direction.dot(u) >= least) visit(entry, direction);
  });
}

// It lists all faces that are met along u.
std::size_t GapBracket::entry_next_to(const Vec3& u) const {
  std::size_t nearest = 0;
  double closest = -kInfinity;
  for_each_within(u, 0.0, [&](std::size_t i, const Vec3& direction) {
    if (direction.dot(u) <= closest) return;
    closest = direction.dot(u);
    nearest = i;
  });
  return nearest;
}

// All but the lower end. x and the unit vector u along it, any u for x in the centre.
DistanceEnds GapBracket::gap_and_edge(const Vec3& x, const Vec3& u) const {
  DistanceEnds found;
  found.upper_mm = kInfinity;
  const Vec3& exact_direction = x.isZero(0.0) ? u : x;
  for (const std::uint32_t f : index_[entry_next_to(u)]) {
    const TriangleCone cone = cone_of(mesh_, mesh_.faces[f]);
    if (place_in_cone(cone.corners(), cone.side(), exact_direction) < 0) continue;
    const double gap = std::abs(x.norm() - cone.radius(u));
    if (gap < found.gap_mm) {
      found.gap_mm = gap;
      found.slope = slope_along(cone, u);
    }
    if (cone.largest_slope() <= kSteepSlope) found.upper_mm = std::min(found.upper_mm, gap);
    for (const Vec3& v : cone.corners()) found.upper_mm = std::min(found.upper_mm, (x - v).norm());
  }
  for (const auto& [round, first, last] : clumps_) {
    if ((x - round.middle).norm() - round.radius > found.edge_mm) continue;
    for (std::size_t k = first; k < last; ++k)
      found.edge_mm =
          std::min(found.edge_mm, std::sqrt(squared_distance_to_segment(x, jumps_[k].from, jumps_[k].to)));
  }
  found.upper_mm = std::min(found.upper_mm, found.edge_mm);
  for (const auto& [middle, radius] : edge_on_)
    found.upper_mm = std::min(found.upper_mm, (x - middle).norm() + radius);
  return found;
}

// The upper end by points of the surface along the entries near x: where faces are steep they are nearer than
// the end of the gap.
double GapBracket::shortened(const Vec3& x, double upper) const {
  double least = upper;
  for_each_within(x.normalized(), std::asin(upper / x.norm()), [&](std::size_t i, const Vec3& u) {
    if (near_[i].farthest == 0.0) return;
    least = std::min({least, (x - near_[i].nearest * u).norm(), (x - near_[i].farthest * u).norm()});
  });
  return least;
}

// Slopes that count for some D up to `farthest`.
std::vector<GapBracket::Slope> GapBracket::slopes_near(const Vec3& x, double farthest) const {
  const double length = x.norm();
  const Vec3 axis = x / length;
  const double sine = std::sin(listed_within_);
  const double cosine = std::cos(listed_within_);
  std::vector<Slope> slopes;
  for_each_within(axis, std::asin(farthest / length), [&](std::size_t i, const Vec3& u) {
    if (index_[i].empty()) return;
    const double from =
        axis.cross(u).norm() * cosine - axis.dot(u) * sine;  // of the angle less listed_within_
    slopes.push_back({length * std::max(from, 0.0), near_[i].slope, near_[i].radius});
  });
  for (const Ball& ball : edge_on_)
    slopes.push_back({std::max((x - ball.middle).norm() - ball.radius, 0.0), kInfinity, 0.0});
  return slopes;
}

// The largest min(D, m / L(D)), nearly. As L grows with D, no D beyond one with m / L(D) < D is better: faces
// are gathered from near to far until there is one.
double GapBracket::lower_end(const Vec3& x, const DistanceEnds& found) const {
  const double m = std::min(found.gap_mm, found.edge_mm);
  const double most = std::min(found.upper_mm, kFarthest * x.norm());
  std::vector<Slope> slopes;
  const auto end = [&](double D) { return m / stretch(slopes, x.norm(), D); };
  double high = kFirstShare * most;
  for (;; high = std::min(2.0 * high, most)) {
    slopes = slopes_near(x, high);
    if (end(high) < high) break;
    if (high == most) return high;
  }
  double low = 0.0;
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = 0.5 * (low + high);
    (end(middle) >= middle ? low : high) = middle;
  }
  return std::max(low, end(high));
}

DistanceEnds GapBracket::at(const Vec3& x) const {
  const double length = x.norm();
  const double allowance = kDistanceAllowance * (length + farthest_corner_);
  DistanceEnds found = gap_and_edge(x, length > 0.0 ? Vec3(x / length) : Vec3::UnitZ());
  found.upper_mm += allowance;
  if (length == 0.0) return found;
  if (found.upper_mm < kFarthest * length) found.upper_mm = shortened(x, found.upper_mm) + allowance;
  found.lower_mm = std::clamp(lower_end(x, found) - allowance, 0.0, found.upper_mm);
  return found;
}

}  // namespace impinge::lab
