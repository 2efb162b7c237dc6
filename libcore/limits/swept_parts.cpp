// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/swept_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <Eigen/Geometry>

#include "contact/part_distance.hpp"

namespace impinge {
namespace {

constexpr double kSweptRounding = 1e-12;  // share of a length, three times the rounding of a distance
constexpr double kWholeTurn = 2.0 * kPi;
// Radians, added to spans: azimuths and the arc sine are right to some 1e-15. Rounding of the arc sine's
// argument is less than what is added to the reach.
constexpr double kSpanRounding = 1e-12;
constexpr double kFinest = 1e-5;  // radians, half of the narrowest span
constexpr int kMostSteps = 2000;  // for a pair of parts

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

// Is all of t on one side of the plane of s and farther from it than `distance`?
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

// The first angle of a span at which two parts may be near: the span is halved until that is decided.
class FirstNear {
 public:
  FirstNear(const TurnFace& turning, const TurnFace& resting, const WithinSpan& within, double doubt)
      : turning_(turning), resting_(resting), within_(within), arm_(arm_of(turning)), doubt_(doubt) {}

  std::optional<double> in(double from, double to) {
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    const double near = doubt_ + within_({from, to}) + arm_ * half;
    if (farther_than(turned_face(turning_, middle), resting_, near)) return std::nullopt;
    if (half <= kFinest || --steps_ <= 0) return from;
    const auto early = in(from, middle);
    return early ? early : in(middle, to);
  }

 private:
  const TurnFace& turning_;
  const TurnFace& resting_;
  const WithinSpan& within_;
  double arm_;    // mm, largest distance of the turning part from the axis
  double doubt_;  // mm, added to what counts as near
  int steps_ = kMostSteps;
};

}  // namespace

SweptSpheres::SweptSpheres(const SweptPair& pair)
    : pair_(pair),
      turning_(pair.turning.nodes().size()),
      resting_(pair.resting.nodes().size()),
      rounding_(kSweptRounding *
                std::max(pair.turning.nodes()[0].farthest, pair.resting.nodes()[0].farthest)) {}

static void place(const SweptParts::Node& node, const Eigen::Matrix3d& frame, Vec3& centre, double& arm) {
  centre = frame * node.centre;
  arm = std::sqrt(centre.head<2>().squaredNorm());
}

const SweptSpheres::Place& SweptSpheres::turning(std::uint32_t node) {
  Place& at = turning_[node];
  if (at.arm < 0.0) place(pair_.turning.nodes()[node], pair_.turning_frame, at.centre, at.arm);
  return at;
}

const SweptSpheres::Place& SweptSpheres::resting(std::uint32_t node) {
  Place& at = resting_[node];
  if (at.arm < 0.0) place(pair_.resting.nodes()[node], pair_.resting_frame, at.centre, at.arm);
  return at;
}

AngleSpans SweptSpheres::spans(std::uint32_t turning_node, std::uint32_t resting_node, double within) {
  AngleSpans spans;
  const SweptParts::Node& turning_of = pair_.turning.nodes()[turning_node];
  const SweptParts::Node& resting_of = pair_.resting.nodes()[resting_node];
  const double near = within + rounding_;
  if (std::max(turning_of.nearest - resting_of.farthest, resting_of.nearest - turning_of.farthest) > near)
    return spans;
  const Place& a = turning(turning_node);
  const Place& b = resting(resting_node);
  const double reach = turning_of.radius + resting_of.radius + near;
  const double rise = a.centre.z() - b.centre.z();
  const double apart = a.arm - b.arm;
  // Two centres with the arms a, b at the azimuths f + t, g are within `reach` of each other where
  // 2 a b (1 - cos(f + t - g)) <= reach^2 - rise^2 - (a - b)^2.
  const double rest = (reach - rise) * (reach + rise) - apart * apart;
  if (rest < 0.0) return spans;
  const double both = 2.0 * a.arm * b.arm;
  if (rest >= 2.0 * both) {
    spans.span[spans.count++] = {0.0, kWholeTurn};
    return spans;
  }
  const double half = 2.0 * std::asin(std::sqrt(rest / (2.0 * both))) + kSpanRounding;
  double middle = std::atan2(a.centre.x() * b.centre.y() - a.centre.y() * b.centre.x(),
                             a.centre.head<2>().dot(b.centre.head<2>()));
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

double SweptSpheres::earliest(std::uint32_t turning_node, std::uint32_t resting_node, double within,
                              double from) {
  for (const AngleSpan& span : spans(turning_node, resting_node, within)) {
    if (span.to >= from) return std::max(span.from, from);
  }
  return HUGE_VAL;
}

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

// The sphere about the middle of the box round the corners.
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

bool SweptParts::farther_than(double distance, const Vec3& x) const {
  return !any_part(distance, x,
                   [&](std::uint32_t part) { return least_distance(x, parts_[part]) <= distance; });
}

double first_within(const SweptPair& pair, const WithinSpan& within, double largest) {
  double first = largest;
  if (pair.turning.empty() || pair.resting.empty()) return first;
  SweptSpheres spheres(pair);
  double asked = -1.0;
  double found_most = 0.0;
  const auto most = [&](double to) {
    if (to != asked) found_most = within({0.0, to});
    asked = to;
    return found_most;
  };
  visit_meetings(pair, 0.0, first, most, [&](std::uint32_t a, std::uint32_t b) {
    const TurnFace& resting = pair.resting.parts()[pair.resting.nodes()[b].at];
    const TurnFace moved = turned_by(pair.turning_frame, pair.turning.parts()[pair.turning.nodes()[a].at]);
    const TurnFace still = turned_by(pair.resting_frame, resting);
    FirstNear near(moved, still, within, moved.doubt + still.doubt + spheres.rounding());
    for (const AngleSpan& span : spheres.spans(a, b, most(first))) {
      if (span.from > first) continue;
      const auto found = near.in(span.from, std::min(span.to, first));
      if (found) first = std::min(first, *found);
    }
    return first;
  });
  return first;
}

}  // namespace impinge
