// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/cartilage_map.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

namespace impinge {
namespace {

constexpr std::size_t kNearest = 4;

struct Neighbour {
  double squared = std::numeric_limits<double>::infinity();  // chord, on the unit sphere
  double thickness = 0.0;
};

// The nearest entries of the map, nearest first.
std::array<Neighbour, kNearest> nearest(const CartilageMap& map, const Vec3& direction) {
  std::array<Neighbour, kNearest> found;
  for (std::size_t i = 0; i < map.directions.size(); ++i) {
    const double squared = (map.directions[i] - direction).squaredNorm();
    if (!(squared < found.back().squared)) continue;
    found.back() = {squared, map.thickness[i]};
    std::ranges::sort(found, {}, &Neighbour::squared);
  }
  return found;
}

}  // namespace

double thickness_at(const CartilageMap& map, const Vec3& direction) {
  assert(!map.directions.empty() && map.directions.size() == map.thickness.size());
  const auto neighbours = nearest(map, direction.normalized());
  if (neighbours[0].squared == 0.0) return neighbours[0].thickness;
  double sum = 0.0;
  double total = 0.0;
  for (const Neighbour& n : neighbours) {
    const double weight = neighbours[0].squared / n.squared;  // 0 for those that a small map lacks
    sum += weight * n.thickness;
    total += weight;
  }
  return sum / total;
}

std::vector<double> shares_of_cartilage(std::span<const double> gap, std::span<const Vec3> places,
                                        const CartilageMap& map) {
  std::vector<double> shares(gap.begin(), gap.end());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] > 0.0) shares[i] /= thickness_at(map, places[i]);  // NaN stays
  }
  return shares;
}

}  // namespace impinge
