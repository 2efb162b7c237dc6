// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/cap_floor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace impinge {
namespace {

constexpr std::size_t kMostCells = 96;  // cells along an edge of the finest grid
constexpr double kCellsOf = 8.0;        // cells along an edge of a wider grid, times its cap radius
constexpr double kWidestCap = 1.2;      // radians
constexpr std::size_t kMostSteps = 64;  // from face to face, before a search ends

}  // namespace

Vec3 CapFloor::Level::direction(std::size_t entry) const {
  const std::size_t lines = cells + 1;
  const auto place = [&](std::size_t line) {
    return -1.0 + 2.0 * static_cast<double>(line) / static_cast<double>(cells);
  };
  return cube_point(entry / (lines * lines), place(entry % lines), place(entry / lines % lines)).normalized();
}

CapFloor::CapFloor(const SeenSurface& surface) : surface_(surface) {
  sample();
  const double first = 2.0 / static_cast<double>(kMostCells);
  for (double radius = first; radius < kWidestCap; radius *= std::numbers::sqrt2)
    levels_.push_back(wider(levels_.back(), radius));
}

void CapFloor::sample() {
  Level finest{kMostCells, 0.0, {}};
  const std::size_t entries = 6 * (kMostCells + 1) * (kMostCells + 1);
  const bool nearest = surface_.layer() == Layer::nearest;
  for (std::size_t k = 0; k < entries; ++k) {
    const Vec3 u = finest.direction(k);
    const std::uint32_t f = surface_.face_along(u);
    face_.push_back(f);
    float value = -HUGE_VALF;
    if (f != DirectionFace::kNone) {
      const DirectionFace& face = surface_.faces()[f];
      const double radius = face.plane.isZero(0.0) ? face.range.high : 1.0 / face.plane.dot(u);
      value = static_cast<float>(nearest ? -radius : radius);
    }
    finest.values.push_back(value);
  }
  levels_.push_back(std::move(finest));
}

CapFloor::Level CapFloor::wider(const Level& level, double radius) {
  const auto cells = std::min(kMostCells, static_cast<std::size_t>(std::ceil(kCellsOf / radius)));
  Level wide{cells, radius, {}};
  const std::size_t entries = 6 * (cells + 1) * (cells + 1);
  const double step = std::tan(radius - level.radius);
  for (std::size_t k = 0; k < entries; ++k) {
    const Vec3 u = wide.direction(k);
    const Vec3 a = u.unitOrthogonal();
    const Vec3 b = u.cross(a);
    float least = level.values[cube_entry(u, level.cells)];
    for (const auto& [x, y] : {std::array{1.0, 0.0},
                               {0.7, 0.7},
                               {0.0, 1.0},
                               {-0.7, 0.7},
                               {-1.0, 0.0},
                               {-0.7, -0.7},
                               {0.0, -1.0},
                               {0.7, -0.7}})
      least = std::min(least, level.values[cube_entry(u + step * (x * a + y * b), level.cells)]);
    wide.values.push_back(least);
  }
  return wide;
}

float CapFloor::within(const Vec3& x, double angle) const {
  std::size_t k = 0;
  while (k + 1 < levels_.size() && levels_[k + 1].radius <= angle) ++k;
  return levels_[k].values[cube_entry(x, levels_[k].cells)];
}

std::uint32_t CapFloor::face_along(const Vec3& u) const {
  std::uint32_t at = face_[cube_entry(u, levels_.front().cells)];
  for (std::size_t step = 0; step < kMostSteps && at != DirectionFace::kNone; ++step) {
    const DirectionFace& face = surface_.faces()[at];
    std::size_t out = 3;
    double least = kSideSlack;
    for (std::size_t k = 0; k < 3; ++k) {
      const double inside = face.inward[k].dot(u);
      if (inside >= least) continue;
      least = inside;
      out = k;
    }
    if (out == 3) return at;
    if (least >= -kSideSlack) return DirectionFace::kNone;
    at = face.beyond[out];
  }
  return DirectionFace::kNone;
}

}  // namespace impinge
