// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/clock.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include <Eigen/Geometry>

namespace impinge {
namespace {

constexpr std::size_t kBins = 48;  // quarters of an hour
constexpr double kBinsPerHour = kBins / 12.0;
constexpr double kVertical = 1e-3;  // sine of the angle between the axis and the vertical

}  // namespace

double ClockFace::hours(const Vec3& direction) const {
  const double angle = std::atan2(direction.dot(three), direction.dot(twelve));
  const double hours = angle * 6.0 / kPi;
  return hours < 0.0 ? std::min(hours + 12.0, std::nextafter(12.0, 0.0)) : hours;
}

std::optional<ClockFace> clock_about(const Vec3& axis) {
  const Vec3 up = Vec3::UnitZ() - axis.z() * axis;
  if (up.norm() < kVertical) return std::nullopt;
  ClockFace face{up.normalized(), axis.cross(up).normalized()};
  if (std::abs(face.three.y()) < kVertical) return std::nullopt;  // neither side is anterior
  if (face.three.y() < 0.0) face.three = -face.three;
  return face;
}

std::optional<ClockFace> clock_face(const TriangleMesh& socket) {
  Vec3 axis = Vec3::Zero();
  const std::vector<double> area = vertex_areas(socket);
  for (std::size_t i = 0; i < area.size(); ++i) {
    const double length = socket.vertices[i].norm();
    if (length > 0.0) axis += area[i] / length * socket.vertices[i];
  }
  if (axis.norm() == 0.0) return std::nullopt;
  return clock_about(axis.normalized());
}

std::vector<ClockZone> clock_zones(std::span<const double> hours, std::span<const double> area) {
  assert(hours.size() == area.size());
  std::array<double, kBins> bin{};
  for (std::size_t i = 0; i < hours.size(); ++i) {
    bin[std::min(static_cast<std::size_t>(hours[i] * kBinsPerHour), kBins - 1)] += area[i];
  }
  const auto filled = [&bin](std::size_t k) { return bin[k % kBins] > 0.0; };
  const auto in_zone = [&](std::size_t k) { return filled(k) || (filled(k + kBins - 1) && filled(k + 1)); };
  std::size_t start = 0;
  while (start < kBins && in_zone(start)) ++start;
  if (start == kBins) {
    double total = 0.0;
    for (const double a : bin) total += a;
    return {{0.0, 0.0, total}};
  }
  std::vector<ClockZone> zones;
  for (std::size_t k = start + 1; k < start + kBins; ++k) {
    if (!in_zone(k)) continue;
    if (!in_zone(k - 1)) zones.push_back({static_cast<double>(k % kBins) / kBinsPerHour, 0.0, 0.0});
    zones.back().area += bin[k % kBins];
    zones.back().to = static_cast<double>((k + 1) % kBins) / kBinsPerHour;
  }
  std::ranges::stable_sort(zones, std::greater{}, &ClockZone::area);
  return zones;
}

std::string clock_text(double hours) {
  const auto minutes = static_cast<int>(std::lround(hours * 60.0)) % 720;
  char text[8];
  std::snprintf(text, sizeof text, "%d:%02d", minutes < 60 ? 12 : minutes / 60, minutes % 60);
  return text;
}

}  // namespace impinge
