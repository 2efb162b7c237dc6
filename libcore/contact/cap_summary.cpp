// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cap_summary.hpp"

#include <algorithm>
#include <cmath>

namespace impinge {
namespace {

constexpr double kQuarter = 0.5 * kPi;

float above(double number) { return std::nextafter(static_cast<float>(number), HUGE_VALF); }
float below(double number) { return std::nextafter(static_cast<float>(number), 0.0F); }

}  // namespace

CapSummary summary_of(std::span<const CapSummary> parts) {
  CapSummary all;
  all.cap.axis = Vec3::Zero();
  for (const CapSummary& part : parts) {
    all.cap.axis += part.cap.axis;
    all.range.include(part.range.low);
    all.range.include(part.range.high);
    all.widest = std::max(all.widest, part.widest);
  }
  if (all.cap.axis.norm() < 1e-3) all.cap.axis = Vec3::UnitZ();
  all.cap.axis = all.cap.axis.normalized().cast<float>().cast<double>();
  for (const CapSummary& part : parts)
    all.cap.radius = std::max(all.cap.radius, angle_between(all.cap.axis, part.cap.axis) + part.cap.radius);
  return all;
}

void keep_to(const CubeCell& cell, CapSummary& summary) {
  double widest = 0.0;
  for (const Vec3& corner : cell_corners(cell))
    widest = std::max(widest, angle_between(summary.cap.axis, corner));
  if (widest < kQuarter) summary.cap.radius = std::min(summary.cap.radius, widest + summary.widest);
}

void write(const SummarisedNode& node, std::size_t lane, CapBlock& block) {
  const CapSummary& summary = node.summary;
  const Eigen::Vector3f axis = summary.cap.axis.cast<float>();
  block.x[lane] = axis.x();
  block.y[lane] = axis.y();
  block.z[lane] = axis.z();
  block.angle[lane] = above(std::min(summary.cap.radius, kPi) + kNodeSlack);
  block.low[lane] = below(summary.range.low * (1.0 - kNodeSlack));
  block.high[lane] = above(summary.range.high * (1.0 + kNodeSlack));
  const double low = block.low[lane];
  const double high = block.high[lane];
  block.mean[lane] = low > 0.0 ? static_cast<float>(2.0 * low * high / (low + high)) : 0.0F;
  block.spread[lane] = high > 0.0 ? above((high - low) / (2.0 * high) + kNodeSlack) : 0.0F;
  block.first[lane] = node.first;
  block.items[lane] = node.items;
}

}  // namespace impinge
