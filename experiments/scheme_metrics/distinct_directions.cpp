// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheme_metrics/distinct_directions.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace impinge {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Places of the entries in the order of their heights along an axis that is askew to every grid, so that few
// have the same height.
std::vector<std::size_t> order_along(const std::vector<double>& height) {
  std::vector<std::size_t> order(height.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return height[a] != height[b] ? height[a] < height[b] : a < b;
  });
  return order;
}

}  // namespace

DistinctDirections distinct_directions(std::span<const Vec3> entries) {
  for (const Vec3& u : entries) {  // before the sort, which a NaN would lead astray
    if (!u.allFinite() || u.isZero(0.0))
      throw std::invalid_argument("a direction is a finite vector that is not zero");
  }
  const Vec3 axis = Vec3(0.5377, 0.6213, 0.5699).normalized();
  std::vector<double> height;
  height.reserve(entries.size());
  for (const Vec3& u : entries) height.push_back(axis.dot(u));
  const std::vector<std::size_t> order = order_along(height);

  std::vector<std::size_t> leader(entries.size(), kNone);  // an entry of the same direction
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = order[i];
    if (leader[a] != kNone) continue;
    for (std::size_t j = i; j < order.size() && height[order[j]] <= height[a] + kCoincident; ++j) {
      const std::size_t b = order[j];
      if (leader[b] == kNone && (entries[a] - entries[b]).norm() <= kCoincident) leader[b] = a;
    }
  }

  DistinctDirections distinct;
  distinct.of_entry.reserve(entries.size());
  std::vector<std::size_t> place(entries.size(), kNone);  // of a leader's direction
  for (std::size_t entry = 0; entry < entries.size(); ++entry) {
    std::size_t& at = place[leader[entry]];
    if (at == kNone) {
      at = distinct.direction.size();
      distinct.direction.push_back(entries[entry]);
      distinct.entries.push_back(0);
    }
    distinct.of_entry.push_back(at);
    ++distinct.entries[at];
  }
  return distinct;
}

}  // namespace impinge
