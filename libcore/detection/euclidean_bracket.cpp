// SPDX-License-Identifier: GPL-3.0-or-later
#include "detection/euclidean_bracket.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mesh/jump_edges.hpp"

namespace impinge {
namespace {

constexpr double kGridPrecision = 1.0;  // degrees
constexpr double kFarthest = 0.45;      // of |x|: no lower end for a distance beyond it
constexpr double kAngleSlack = 1e-9;    // radians, for rounding
constexpr double kSteep = 1e4;          // tan psi beyond which rounding of a radius may reach the allowance
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance_from_segment(const Vec3& x, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double length = along.squaredNorm();
  const double share = length > 0.0 ? std::clamp((x - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (x - from - share * along).norm();
}

}  // namespace

EuclideanBracket::EuclideanBracket(TriangleMesh mesh)
    : mesh_(std::move(mesh)),
      grid_(CubeGnomonic::with_precision(kGridPrecision)),
      walker_(grid_.walker()),
      near_(grid_.size()) {
  if (mesh_.faces.empty()) {
    throw std::invalid_argument("mesh: it has no faces, so there is no distance to it; read another file");
  }
  for (const JumpEdge& edge : jump_edges(mesh_))
    jumps_.push_back({mesh_.vertices[edge.from], mesh_.vertices[edge.to]});
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) list_face(f);
}

void EuclideanBracket::list_face(std::size_t f) {
  const TriangleCone cone = cone_of(mesh_, mesh_.faces[f]);
  const auto& c = cone.corners();
  if (cone.edge_on()) {
    const Vec3 middle = (c[0] + c[1] + c[2]) / 3.0;
    edge_on_.push_back(
        {middle, std::max({(c[0] - middle).norm(), (c[1] - middle).norm(), (c[2] - middle).norm()})});
    return;
  }
  const double slope = cone.largest_slope();
  const double radius = std::max({c[0].norm(), c[1].norm(), c[2].norm()});
  walker_.visit_near(cone, grid_.covering_radius() + kAngleSlack, [&](const DirectionRun& run) {
    for (std::size_t k = 0; k < run.count; ++k) {
      Near& near = near_[run.first + k];
      near.faces.push_back(static_cast<std::uint32_t>(f));
      near.slope = std::max(near.slope, slope);
      near.radius = std::max(near.radius, radius);
      if (slope > kSteep || !cone.contains(run[k])) continue;
      near.nearest = std::min(near.nearest, cone.radius(run[k]));
      near.farthest = std::max(near.farthest, cone.radius(run[k]));
    }
  });
}

// Calls visit(near, direction) for the entries within that angle of unit u, and those next to them: one of
// them lists any face that is seen within the angle.
template <class Visit>
void EuclideanBracket::for_each_within(const Vec3& u, double angle, Visit&& visit) const {
  const double wide = angle + grid_.covering_radius() + kAngleSlack;
  const double least = std::cos(wide + kAngleSlack);
  walker_.visit_near(TriangleCone(u, u, u), wide, [&](const DirectionRun& run) {
    for (std::size_t k = 0; k < run.count; ++k) {
      const Vec3 direction = run[k];
      if (direction.dot(u) >= least) visit(run.first + k, direction);
    }
  });
}

// It lists all faces that are met along u.
std::size_t EuclideanBracket::entry_next_to(const Vec3& u) const {
  std::size_t nearest = 0;
  double closest = -kInfinity;
  for_each_within(u, 0.0, [&](std::size_t i, const Vec3& direction) {
    if (direction.dot(u) <= closest) return;
    closest = direction.dot(u);
    nearest = i;
  });
  return nearest;
}

// x and the unit vector u along it, any u for x in the centre.
EuclideanBracket::Reach EuclideanBracket::reach_of(const Vec3& x, const Vec3& u) const {
  Reach reach{kInfinity, kInfinity};
  const Vec3& exact_direction = x.isZero(0.0) ? u : x;
  for (const std::uint32_t f : near_[entry_next_to(u)].faces) {
    const TriangleCone cone = cone_of(mesh_, mesh_.faces[f]);
    if (place_in_cone(cone.corners(), cone.side(), exact_direction) < 0) continue;
    const double gap = std::abs(x.norm() - cone.radius(u));
    reach.gap = std::min(reach.gap, gap);
    if (cone.largest_slope() <= kSteep) reach.upper = std::min(reach.upper, gap);
    for (const Vec3& v : cone.corners()) reach.upper = std::min(reach.upper, (x - v).norm());
  }
  for (const auto& [from, to] : jumps_) {
    const double distance = distance_from_segment(x, from, to);
    reach.gap = std::min(reach.gap, distance);
    reach.upper = std::min(reach.upper, distance);
  }
  for (const auto& [middle, radius] : edge_on_)
    reach.upper = std::min(reach.upper, (x - middle).norm() + radius);
  return reach;
}

// The upper end by points of the surface along the entries near x: where faces are steep they are nearer than
// the end of the gap.
double EuclideanBracket::shortened(const Vec3& x, double upper) const {
  double least = upper;
  for_each_within(x.normalized(), std::asin(upper / x.norm()), [&](std::size_t i, const Vec3& u) {
    if (near_[i].farthest == 0.0) return;
    least = std::min({least, (x - near_[i].nearest * u).norm(), (x - near_[i].farthest * u).norm()});
  });
  return least;
}

// L, where the distance from x is at most `upper`.
double EuclideanBracket::stretch(const Vec3& x, double upper) const {
  double slope = 0.0;
  double radius = 0.0;
  for_each_within(x.normalized(), std::asin(upper / x.norm()), [&](std::size_t i, const Vec3&) {
    slope = std::max(slope, near_[i].slope);
    radius = std::max(radius, near_[i].radius);
  });
  if (std::isinf(slope)) return kInfinity;
  const double inner = x.norm() - upper;
  const double q = upper / inner;
  double ratio = radius / inner;
  const double rest = 1.0 - q * q * slope * slope;
  if (rest > 0.0) ratio = std::min(ratio, (1.0 + std::sqrt(1.0 - rest * (1.0 - q * q))) / rest);
  return std::hypot(1.0, ratio * slope);
}

bool EuclideanBracket::is_near_edge_on(const Vec3& x, double upper) const {
  return std::ranges::any_of(
      edge_on_, [&](const Ball& ball) { return (x - ball.middle).norm() <= ball.radius + upper; });
}

DistanceBracket EuclideanBracket::at(const Vec3& x) const {
  const double length = x.norm();
  const double allowance = kDistanceAllowance * length;
  const Reach reach = reach_of(x, length > 0.0 ? Vec3(x / length) : Vec3::UnitZ());
  double upper = reach.upper + allowance;
  if (upper < kFarthest * length) upper = std::min(upper, shortened(x, upper) + allowance);
  if (!(upper < kFarthest * length) || is_near_edge_on(x, upper)) return {0.0, upper};
  return {std::clamp(reach.gap / stretch(x, upper) - allowance, 0.0, upper), upper};
}

}  // namespace impinge
