// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/swept_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>

#include <Eigen/Geometry>

#include "mesh/triangle_distance.hpp"
#include "motion/part_distance.hpp"

namespace impinge {
namespace {

constexpr double kSweptRounding = 1e-12;  // of lengths: that of a distance is below a third of it
constexpr double kWholeTurn = 2.0 * kPi;
// Radians, of spans: azimuths and the arc sine are right to some 1e-15. What its argument is rounded by is
// below what is added to the reach.
constexpr double kSpanRounding = 1e-12;
constexpr double kFinest = 1e-5;  // radians
constexpr int kMostSteps = 2000;  // of a pair of parts

double arm_of(const TurnFace& face) {
  double squared = 0.0;
  for (const Vec3& x : face.corner) squared = std::max(squared, x.head<2>().squaredNorm());
  return std::sqrt(squared);
}

TurnFace turned_face(const TurnFace& face, double angle) {
  TurnFace moved = face;
  for (Vec3& x : moved.corner) x = turned(x, angle);
  moved.normal = turned(face.normal, angle);
  return moved;
}

// Is t on one side of the plane of s, farther from it than that?
bool plane_separates(const TurnFace& s, const TurnFace& t, double distance) {
  if (s.thin) return false;
  const double far = distance * s.normal.norm();
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Vec3& x : t.corner) {
    const double height = s.normal.dot(x - s.corner[0]);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return low > far || high < -far;
}

// The sphere of a node, by the axis.
struct Place {
  double z;        // mm, height
  double arm;      // mm, from the axis
  double azimuth;  // radians
  double radius;   // mm
};

std::vector<Place> places_of(const SweptParts& surface) {
  std::vector<Place> places;
  places.reserve(surface.nodes().size());
  for (const SweptParts::Node& node : surface.nodes()) {
    const Vec3& c = node.centre;
    places.push_back({c.z(), std::hypot(c.x(), c.y()), std::atan2(c.y(), c.x()), node.radius});
  }
  return places;
}

// A pair of nodes and when they may first be near.
struct PairOfNodes {
  double first;
  std::uint32_t turning;
  std::uint32_t resting;
  bool operator<(const PairOfNodes& other) const { return first > other.first; }  // the earliest on top
};

class SweptSearch {
 public:
  SweptSearch(const SweptParts& turning, const SweptParts& resting, const WithinSpan& within, double largest)
      : turning_(turning),
        resting_(resting),
        within_(within),
        first_(largest),
        turning_places_(places_of(turning)),
        resting_places_(places_of(resting)) {
    for (const SweptParts* surface : {&turning, &resting}) {
      for (const TurnFace& face : surface->parts()) {
        for (const Vec3& x : face.corner) rounding_ = std::max(rounding_, kSweptRounding * x.norm());
      }
    }
  }

  double run() {
    if (turning_.nodes().empty() || resting_.nodes().empty()) return first_;
    consider(0, 0);
    while (!pending_.empty() && pending_.top().first < first_) {
      const PairOfNodes next = pending_.top();
      pending_.pop();
      open(next);
    }
    return first_;
  }

 private:
  void open(const PairOfNodes& pair) {
    const SweptParts::Node& a = turning_.nodes()[pair.turning];
    const SweptParts::Node& b = resting_.nodes()[pair.resting];
    if (a.leaf && b.leaf) return meet(pair);
    const bool open_a = b.leaf || (!a.leaf && a.radius >= b.radius);
    for (std::uint32_t k = 0; k < 2; ++k) {
      if (open_a)
        consider(a.at + k, pair.resting);
      else
        consider(pair.turning, b.at + k);
    }
  }

  // Angles in which the spheres may be within the distance: at most two spans, the first that begins first.
  AngleSpans spans_of(std::uint32_t turning, std::uint32_t resting, double within) const {
    const Place& a = turning_places_[turning];
    const Place& b = resting_places_[resting];
    const double reach = a.radius + b.radius + within + rounding_;
    const double rise = a.z - b.z;
    const double apart = a.arm - b.arm;
    // 2 a b (1 - cos of what they are apart by) is at most this.
    const double rest = (reach - rise) * (reach + rise) - apart * apart;
    AngleSpans spans;
    if (rest < 0.0) return spans;
    const double both = 2.0 * a.arm * b.arm;
    if (rest >= 2.0 * both) {
      spans.span[spans.count++] = {0.0, kWholeTurn};
      return spans;
    }
    const double half = 2.0 * std::asin(std::sqrt(rest / (2.0 * both))) + kSpanRounding;
    double middle = b.azimuth - a.azimuth;
    if (middle < 0.0) middle += kWholeTurn;
    if (middle - half < 0.0) {
      spans.span[spans.count++] = {0.0, std::min(middle + half, kWholeTurn)};
      spans.span[spans.count++] = {std::max(middle - half + kWholeTurn, 0.0), kWholeTurn};
    } else if (middle + half > kWholeTurn) {
      spans.span[spans.count++] = {0.0, middle + half - kWholeTurn};
      spans.span[spans.count++] = {middle - half, kWholeTurn};
    } else {
      spans.span[spans.count++] = {middle - half, middle + half};
    }
    return spans;
  }

  // Of all angles that are still looked at.
  double most_within() {
    if (most_for_ != first_) most_ = within_({0.0, first_});
    most_for_ = first_;
    return most_;
  }

  // Is one of them that much farther from the origin than the other, whatever the angle?
  bool never_near(std::uint32_t turning, std::uint32_t resting, double within) const {
    const SweptParts::Node& a = turning_.nodes()[turning];
    const SweptParts::Node& b = resting_.nodes()[resting];
    return std::max(a.nearest - b.farthest, b.nearest - a.farthest) > within + rounding_;
  }

  void consider(std::uint32_t turning, std::uint32_t resting) {
    if (never_near(turning, resting, most_within())) return;
    double earliest = first_;
    for (const AngleSpan& span : spans_of(turning, resting, most_within()))
      earliest = std::min(earliest, span.from);
    if (earliest < first_) pending_.push({earliest, turning, resting});
  }

  void meet(const PairOfNodes& pair) {
    const SweptParts::Node& a = turning_.nodes()[pair.turning];
    const SweptParts::Node& b = resting_.nodes()[pair.resting];
    const TurnFace& turning = turning_.parts()[a.at];
    const TurnFace& resting = resting_.parts()[b.at];
    const double arm = arm_of(turning);
    const double doubt = turning.doubt + resting.doubt + rounding_;
    int steps = kMostSteps;
    const auto first_in = [&](const auto& again, double from, double to) -> std::optional<double> {
      const double middle = 0.5 * (from + to);
      const double half = 0.5 * (to - from);
      const double near = doubt + within_({from, to}) + arm * half;
      const double spheres = (turned(a.centre, middle) - b.centre).norm() - a.radius - b.radius;
      if (spheres > near) return std::nullopt;
      if (farther_than(turned_face(turning, middle), resting, near)) return std::nullopt;
      if (half <= kFinest || --steps <= 0) return from;
      const auto early = again(again, from, middle);
      return early ? early : again(again, middle, to);
    };
    for (const AngleSpan& span : spans_of(pair.turning, pair.resting, most_within())) {
      const double to = std::min(span.to, first_);
      if (span.from > to) continue;
      const auto found = first_in(first_in, span.from, to);
      if (found) first_ = std::min(first_, *found);
    }
  }

  const SweptParts& turning_;
  const SweptParts& resting_;
  const WithinSpan& within_;
  double first_;
  std::vector<Place> turning_places_;
  std::vector<Place> resting_places_;
  double most_ = 0.0;
  double most_for_ = -1.0;
  double rounding_ = 0.0;
  std::priority_queue<PairOfNodes> pending_;
};

}  // namespace

bool farther_than(const TurnFace& s, const TurnFace& t, double distance) {
  return plane_separates(s, t, distance) || plane_separates(t, s, distance) ||
         least_distance(s, t) > distance;
}

SweptParts::SweptParts(std::vector<TurnFace> parts) : parts_(std::move(parts)) {
  if (parts_.empty()) return;
  std::vector<std::uint32_t> order(parts_.size());
  std::iota(order.begin(), order.end(), 0U);
  nodes_.reserve(2 * parts_.size());
  nodes_.emplace_back();
  split(order.data(), order.data() + order.size(), 0);
}

// The sphere about the middle of the box of the corners.
void SweptParts::split(std::uint32_t* first, std::uint32_t* last, std::uint32_t node) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t* p = first; p != last; ++p) {
    for (const Vec3& x : parts_[*p].corner) box.extend(x);
  }
  Node made{box.center(), 0.0, *first, last - first == 1};
  for (const std::uint32_t* p = first; p != last; ++p) {
    for (const Vec3& x : parts_[*p].corner)
      made.radius = std::max(made.radius, (x - made.centre).norm() + parts_[*p].doubt);
  }
  made.radius *= 1.0 + kSweptRounding;
  if (!made.leaf) {
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    std::uint32_t* middle = first + (last - first) / 2;
    const auto place = [&](std::uint32_t p) {
      const auto& c = parts_[p].corner;
      return c[0][axis] + c[1][axis] + c[2][axis];
    };
    std::nth_element(first, middle, last,
                     [&](std::uint32_t p, std::uint32_t q) { return place(p) < place(q); });
    made.at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    split(first, middle, made.at);
    split(middle, last, made.at + 1);
  }
  if (made.leaf) {
    const TurnFace& part = parts_[made.at];
    const auto& [a, b, c] = part.corner;
    made.nearest = least_distance(Vec3::Zero(), part) - part.doubt;
    made.farthest = std::max({a.norm(), b.norm(), c.norm()}) + part.doubt;
  } else {
    made.nearest = std::min(nodes_[made.at].nearest, nodes_[made.at + 1].nearest);
    made.farthest = std::max(nodes_[made.at].farthest, nodes_[made.at + 1].farthest);
  }
  nodes_[node] = made;
}

SweptParts SweptParts::rotated(const Eigen::Matrix3d& rotation) const {
  SweptParts moved = *this;
  for (TurnFace& face : moved.parts_) {
    const double doubt = face.doubt;
    face = turn_face(rotation * face.corner[0], rotation * face.corner[1], rotation * face.corner[2]);
    face.doubt = doubt;
  }
  for (Node& node : moved.nodes_) node.centre = rotation * node.centre;
  return moved;
}

// Calls found(part) for those whose spheres are that near until it returns true.
template <class Found>
bool SweptParts::any_part(double distance, const Vec3& x, const Found& found) const {
  std::vector<std::uint32_t> pending;
  if (!nodes_.empty()) pending.push_back(0);
  while (!pending.empty()) {
    const Node node = nodes_[pending.back()];
    pending.pop_back();
    if ((node.centre - x).norm() - node.radius > distance) continue;
    if (!node.leaf)
      pending.insert(pending.end(), {node.at, node.at + 1});
    else if (found(parts_[node.at]))
      return true;
  }
  return false;
}

bool SweptParts::farther_than(double distance, const Vec3& x) const {
  return !any_part(distance, x, [&](const TurnFace& part) { return least_distance(x, part) <= distance; });
}

bool SweptParts::within(double distance, const Vec3& x) const {
  return distance >= 0.0 && any_part(distance, x, [&](const TurnFace& part) {
           return squared_distance_to_point_of(x, part.corner) <= distance * distance;
         });
}

double first_within(const SweptParts& turning, const SweptParts& resting, const WithinSpan& within,
                    double largest) {
  return SweptSearch(turning, resting, within, largest).run();
}

}  // namespace impinge
