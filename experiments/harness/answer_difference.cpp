// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/answer_difference.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "sphere/infinity.hpp"

namespace impinge::lab {
namespace {

// Difference of two gaps of one vertex.
double difference(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return 0.0;
  return std::isnan(a) || std::isnan(b) ? kInfinity : std::abs(a - b);
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return kInfinity;
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, difference(a[i], b[i]));
  return largest;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) {
    return (std::isnan(x) && std::isnan(y)) ||
           std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

bool same_bits(const PoseGaps& a, const PoseGaps& b) {
  return same_bits(a.ball, b.ball) && same_bits(a.socket, b.socket);
}

}  // namespace

bool same_answer(const SceneAnswer& a, const SceneAnswer& b) {
  return a.touches == b.touches && a.smallest == b.smallest &&
         std::ranges::equal(a.gaps, b.gaps,
                            [](const PoseGaps& one, const PoseGaps& two) { return same_bits(one, two); });
}

double gap_difference(const PoseGaps& a, const PoseGaps& b) {
  return std::max(difference(a.ball, b.ball), difference(a.socket, b.socket));
}

double answer_difference(const SceneAnswer& a, const SceneAnswer& b) {
  if (a.touches != b.touches || a.gaps.size() != b.gaps.size() || !a.smallest != !b.smallest)
    return kInfinity;
  double largest = a.smallest ? difference(a.smallest->gap_mm, b.smallest->gap_mm) : 0.0;
  for (std::size_t p = 0; p < a.gaps.size(); ++p)
    largest = std::max(largest, gap_difference(a.gaps[p], b.gaps[p]));
  return largest;
}

}  // namespace impinge::lab
