// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/mesh_end.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/triangle_distance.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

constexpr double kOnArc = 1e-12;  // share of a product of lengths that allows for rounding
constexpr double kBehind = 1e-9;  // radians behind a border, where covered() is asked

// A border edge as the centre sees it: an arc of a great circle.
struct Arc {
  Vec3 from;  // unit vectors
  Vec3 to;
  Vec3 across;
  double z_low, z_high;  // least and largest height of its points
};

Arc arc_of(const Vec3& a, const Vec3& b) {
  const Vec3 from = a.stableNormalized();
  const Vec3 to = b.stableNormalized();
  const double nearest = std::max((0.5 * (from + to)).norm(), kOnArc);  // of the chord
  const auto [low, high] = std::minmax(from.z(), to.z());
  return {from, to, from.cross(to - from), std::min(low, low / nearest) - kOnArc,
          std::max(high, high / nearest) + kOnArc};
}

// Adds the angles up to `largest` at which the turning arc passes the direction y.
void add_passes(const Arc& arc, const Vec3& y, double largest, std::vector<double>& angles) {
  const double bound = kOnArc * std::max(arc.across.norm(), kOnArc);
  for (const AngleSpan& span : near_zero(turned_dot(arc.across, y), bound)) {
    const double t = 0.5 * (span.from + span.to);
    const Vec3 back = turned(y, -t);
    const bool on_arc =
        arc.from.cross(back).dot(arc.across) >= -bound && back.cross(arc.to).dot(arc.across) >= -bound;
    if (on_arc && t <= largest) angles.push_back(t);
  }
}

// The first angle up to `largest` at which the direction y may be within `near` radians of the turning arc:
// near its circle, and no farther from the arc's middle than its ends are.
std::optional<double> first_near(const Arc& arc, const Vec3& y, double near, double largest) {
  const Vec3 middle = (arc.from + arc.to).stableNormalized();
  const double ends = std::min(kPi, angle_between(arc.from, middle) + near + kBehind);
  const double low = std::cos(ends);
  const double across = std::max(arc.across.norm(), kOnArc);
  const double beside = near < 0.5 * kPi ? std::sin(near) + kBehind : 2.0;
  std::optional<double> first;
  for (const AngleSpan& circle : near_zero(turned_dot(arc.across / across, y), beside)) {
    Sinusoid along = turned_dot(middle, y);
    along.constant -= 0.5 * (1.0 + low);
    for (const AngleSpan& about : near_zero(along, 0.5 * (1.0 - low) + kOnArc)) {
      const double from = std::max(circle.from, about.from);
      if (from <= std::min({circle.to, about.to, largest})) first = std::min(first.value_or(from), from);
    }
  }
  return first;
}

}  // namespace

std::optional<double> first_near_border(const MeshEnd& end, double largest, double shift, double within) {
  std::vector<std::pair<Arc, double>> arcs;  // and by how much their directions may change, radians
  for (const auto& [a, b] : end.border) {
    const double nearest = std::sqrt(squared_distance_to_segment(Vec3::Zero(), end.ball[a], end.ball[b]));
    arcs.emplace_back(arc_of(end.ball[a], end.ball[b]), within < nearest ? std::asin(within / nearest) : kPi);
  }
  std::optional<double> first;
  for (std::size_t i = 0; i < end.socket.size(); ++i) {
    const double length = end.socket[i].norm();
    const double aside = shift < length ? std::asin(shift / length) : kPi;
    const Vec3 y = end.socket[i].stableNormalized();
    std::optional<double> of_point;
    for (const auto& [arc, change] : arcs) {
      const double near = std::min(kPi, aside + change);
      if (y.z() < arc.z_low - near || y.z() > arc.z_high + near) continue;
      const auto found = first_near(arc, y, near, of_point.value_or(first.value_or(largest)));
      if (found) of_point = found;
    }
    if (of_point && end.covered(i, 0.0)) first = of_point;
  }
  return first;
}

std::optional<double> first_beyond(const MeshEnd& end, double largest) {
  std::vector<Arc> arcs;
  for (const auto& [a, b] : end.border) arcs.push_back(arc_of(end.ball[a], end.ball[b]));
  std::optional<double> first;
  std::vector<double> angles;
  for (std::size_t i = 0; i < end.socket.size(); ++i) {
    const Vec3 y = end.socket[i].stableNormalized();
    angles.clear();
    for (const Arc& arc : arcs) {
      if (arc.z_low <= y.z() && y.z() <= arc.z_high) add_passes(arc, y, first.value_or(largest), angles);
    }
    if (angles.empty() || !end.covered(i, 0.0)) continue;
    std::ranges::sort(angles);
    for (const double angle : angles) {
      if (end.covered(i, angle + kBehind)) continue;
      first = std::min(first.value_or(largest), angle);
      break;
    }
  }
  return first;
}

}  // namespace impinge
