// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/turn_tree.hpp"

#include <algorithm>
#include <numeric>

namespace impinge {
namespace {

constexpr double kFullTurn = 2.0 * kPi;
// Radians. An azimuth is right to 2^-51, and a tree of 2^32 leaves shifts it by whole turns at most 32 times,
// each time rounded by 2^-50.
constexpr double kAzimuthRounding = 1e-13;

// From one azimuth to another, the shorter way round.
double between(double from, double to) { return std::remainder(to - from, kFullTurn); }

TurnBox all_round(TurnBox box) {
  box.from = -kPi;
  box.to = kPi + kAzimuthRounding;
  return box;
}

}  // namespace

TurnPoint::TurnPoint(const Vec3& at)
    : x(at), rho(std::hypot(at.x(), at.y())), r(at.norm()), azimuth(std::atan2(at.y(), at.x())) {}

// Off the axis, a segment of length l seen along the axis comes no nearer to it than sqrt(rho^2 - l^2 / 4),
// rho that of its nearer end; a triangle round the axis has azimuths of more than half a turn. What is within
// the margin of a point at rho or more has an azimuth within asin(margin / rho) of its own.
TurnBox turn_box(std::span<const TurnPoint* const> corners, double r_low, double margin) {
  TurnBox box;
  double squared = HUGE_VAL;  // of the least distance from the axis
  for (const TurnPoint* corner : corners) {
    box.z_low = std::min(box.z_low, corner->x.z());
    box.z_high = std::max(box.z_high, corner->x.z());
    box.rho_high = std::max(box.rho_high, corner->rho);
    box.r_high = std::max(box.r_high, corner->r);
    squared = std::min(squared, corner->rho * corner->rho);
  }
  double longest = 0.0;  // squared
  for (std::size_t k = 1; k < corners.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l)
      longest = std::max(longest, (corners[k]->x - corners[l]->x).head<2>().squaredNorm());
  }
  box.rho_low = std::sqrt(std::max(0.0, squared * (1.0 - 1e-12) - 0.25 * longest * (1.0 + 1e-12)));
  box.r_low = r_low - margin;
  box.r_high += margin;
  box.z_low -= margin;
  box.z_high += margin;
  const double rho = box.rho_low;
  box.rho_low -= margin;
  box.rho_high += margin;
  if (!(rho > 2.0 * margin)) return all_round(box);
  double low = 0.0;
  double high = 0.0;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const double turn = between(corners[0]->azimuth, corners[k]->azimuth);
    low = std::min(low, turn);
    high = std::max(high, turn);
  }
  if (high - low > kPi - kAzimuthRounding) {  // the axis may pierce it
    box.rho_low = -margin;
    return all_round(box);
  }
  const double slack = 2.0 * margin / rho + kAzimuthRounding;
  box.from = corners[0]->azimuth + low - slack;
  box.to = corners[0]->azimuth + high + slack;
  return box;
}

TurnBox joined(const TurnBox& a, const TurnBox& b) {
  TurnBox both{std::min(a.z_low, b.z_low),
               std::max(a.z_high, b.z_high),
               std::min(a.rho_low, b.rho_low),
               std::max(a.rho_high, b.rho_high),
               std::min(a.r_low, b.r_low),
               std::max(a.r_high, b.r_high),
               a.from,
               a.to};
  const double by = kFullTurn * std::round(0.5 * (a.from + a.to - b.from - b.to) / kFullTurn);
  both.from = std::min(a.from, b.from + by);
  both.to = std::max(a.to, b.to + by);
  if (both.to - both.from >= kFullTurn) return all_round(both);
  return both;
}

double earliest_meeting(const TurnBox& turning, const TurnBox& resting, double from) {
  if (turning.z_low > resting.z_high || resting.z_low > turning.z_high ||
      turning.rho_low > resting.rho_high || resting.rho_low > turning.rho_high ||
      turning.r_low > resting.r_high || resting.r_low > turning.r_high)
    return HUGE_VAL;
  double first = resting.from - turning.to;
  double last = resting.to - turning.from;
  if (last - first >= kFullTurn) return from;
  const double turns = kFullTurn * std::floor((last - from) / kFullTurn);
  return std::max(from, first - turns);
}

std::vector<std::uint32_t> order_by_place(std::span<const Vec3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  struct Range {
    std::uint32_t* first;
    std::uint32_t* last;
  };
  std::vector<Range> pending{{order.data(), order.data() + order.size()}};
  while (!pending.empty()) {
    const auto [first, last] = pending.back();
    pending.pop_back();
    if (last - first < 2) continue;
    Vec3 low = points[*first];
    Vec3 high = low;
    for (const std::uint32_t* at = first; at != last; ++at) {
      low = low.cwiseMin(points[*at]);
      high = high.cwiseMax(points[*at]);
    }
    Eigen::Index widest = 0;
    (high - low).maxCoeff(&widest);
    std::uint32_t* const middle = first + (last - first) / 2;
    std::nth_element(first, middle, last,
                     [&](std::uint32_t a, std::uint32_t b) { return points[a][widest] < points[b][widest]; });
    pending.push_back({first, middle});
    pending.push_back({middle, last});
  }
  return order;
}

// In pre-order: a node of n leaves is followed by the 2 (n / 2) - 1 nodes of its first half.
void TurnTree::lay_out(std::span<const std::uint32_t> order) {
  struct Range {
    std::uint32_t node;
    std::uint32_t first;
    std::uint32_t count;
  };
  nodes_.resize(2 * order.size() - 1);
  std::vector<Range> pending{{0, 0, static_cast<std::uint32_t>(order.size())}};
  while (!pending.empty()) {
    const auto [node, first, count] = pending.back();
    pending.pop_back();
    nodes_[node].count = count;
    nodes_[node].item = order[first];
    if (count == 1) continue;
    const std::uint32_t half = count / 2;
    pending.push_back({first_half(node), first, half});
    pending.push_back({second_half(node), first + half, count - half});
  }
}

TurnTree::TurnTree(std::span<const TurnBox> boxes, std::span<const std::uint32_t> order) {
  if (order.empty()) return;
  lay_out(order);
  for (auto node = static_cast<std::uint32_t>(nodes_.size()); node-- > 0;) {
    Node& at = nodes_[node];
    at.box =
        at.count == 1 ? boxes[at.item] : joined(nodes_[first_half(node)].box, nodes_[second_half(node)].box);
  }
}

}  // namespace impinge
