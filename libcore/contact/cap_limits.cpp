// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cap_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/cap_search.hpp"
#include "sphere/cube_faces.hpp"

namespace impinge {
namespace {

constexpr double kMostCells = 255.0;
// At least: c is at most an eleventh of the reach, where the grid is not too fine.
constexpr float kCellsPerReach = 16.0F;
constexpr float kFinestReach = 2.0F;      // in cells of the finest grid
constexpr double kEntriesPerFace = 0.35;  // of the finest grid for caps
constexpr double kResolution = 0.5;       // of c: nodes as narrow as that are taken whole

// Directions of the entries of a grid.
std::vector<Vec3> entries(std::size_t cells) {
  std::vector<Vec3> found;
  found.reserve(6 * (cells + 1) * (cells + 1));
  const auto line = [&](std::size_t k) {
    return -1.0 + 2.0 * static_cast<double>(k) / static_cast<double>(cells);
  };
  for (std::size_t face = 0; face < 6; ++face) {
    for (std::size_t j = 0; j <= cells; ++j) {
      for (std::size_t i = 0; i <= cells; ++i)
        found.push_back(cube_point(face, line(i), line(j)).normalized());
    }
  }
  return found;
}

// Adds levels, one after the other.
class LevelsBuilder {
 public:
  LevelsBuilder(const TriangleMesh& mesh, Layer layer) : search_(mesh, layer) {
    limits.assign(24, search_.limit({Vec3::UnitZ(), 4.0}, 0.0));
  }

  void add(std::int32_t cells, float reach) {
    const double nearest_entry = std::numbers::sqrt2 / static_cast<double>(cells);
    const double radius = nearest_entry + static_cast<double>(reach) + kNodeSlack;
    steps.push_back(static_cast<std::int32_t>(limits.size() << CapLimits::kLineBits) + cells);
    for (const Vec3& axis : entries(static_cast<std::size_t>(cells)))
      limits.push_back(search_.limit({axis, radius}, kResolution * nearest_entry));
  }

  std::vector<std::int32_t> steps{1};
  std::vector<float> limits;

 private:
  CapSearch search_;
};

}  // namespace

CapLimits::CapLimits(const TriangleMesh& mesh, Layer layer) {
  LevelsBuilder builder(mesh, layer);
  const double most = std::ceil(std::sqrt(kEntriesPerFace / 6.0 * static_cast<double>(mesh.faces.size())));
  const auto cells = static_cast<std::int32_t>(std::clamp(most, 4.0, kMostCells));
  while (reach(finest_) > kFinestReach / static_cast<float>(cells)) {
    ++finest_;
    builder.add(std::min(static_cast<std::int32_t>(kCellsPerReach / reach(finest_)), cells), reach(finest_));
  }
  builder.add(2 * cells, kAloneReach);
  steps_ = std::move(builder.steps);
  limits_ = std::move(builder.limits);
}

float CapLimits::reach(int level) const {
  if (level == 0) return HUGE_VALF;
  if (level > finest_) return kAloneReach;
  return std::bit_cast<float>(static_cast<std::uint32_t>(kWidest + 1 - level) << kQuarterOctave);
}

CapLimits::Limit CapLimits::look_up(int level, const Vec3& x) const {
  if (level == 0) return {overall(), HUGE_VALF};
  const auto step = static_cast<std::uint32_t>(steps_[static_cast<std::size_t>(level)]);
  const std::size_t cells = step & static_cast<std::uint32_t>(kMostLines);
  const CubePlace at = cube_place(x);
  const auto line = [&](double place) {
    return static_cast<std::size_t>(std::lround(0.5 * (place + 1.0) * static_cast<double>(cells)));
  };
  const std::size_t row = at.face * (cells + 1) + line(at.b);
  return {limits_[(step >> kLineBits) + row * (cells + 1) + line(at.a)], reach(level)};
}

std::size_t CapLimits::bytes() const {
  return steps_.size() * sizeof(std::int32_t) + limits_.size() * sizeof(float);
}

}  // namespace impinge
