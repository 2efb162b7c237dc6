// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cap_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/cap_search.hpp"
#include "sphere/cube_faces.hpp"

namespace impinge {
namespace {

constexpr double kMostCells = 255.0;
// With so many cells or more c is at most an eleventh of the reach, unless the grid would be too fine.
constexpr float kCellsPerReach = 16.0F;
constexpr float kFinestReach = 2.0F;      // in cells of the finest grid
constexpr double kEntriesPerFace = 0.35;  // of the finest grid for caps
constexpr double kResolution = 0.5;       // share of c; nodes as narrow as that are taken whole

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

// The limits of one level.
struct Level {
  std::int32_t cells = 0;  // along an edge
  std::vector<float> limits;
};

// Makes the levels from the least reach to the widest: a wide cap holds all that a narrow one in it holds.
class LevelsBuilder {
 public:
  LevelsBuilder(const TriangleMesh& mesh, Layer layer) : search_(mesh, layer) {}

  float overall() { return search_.limit({Vec3::UnitZ(), 4.0}, 0.0, search_.none()); }

  Level make(std::int32_t cells, float reach, const Level* narrower) {
    const double nearest_entry = std::numbers::sqrt2 / static_cast<double>(cells);
    const double radius = nearest_entry + static_cast<double>(reach) + kNodeSlack;
    const bool within = narrower != nullptr && narrower->cells == cells;
    Level level{cells, {}};
    for (const Vec3& axis : entries(static_cast<std::size_t>(cells))) {
      const float known = within ? narrower->limits[level.limits.size()] : search_.none();
      level.limits.push_back(search_.limit({axis, radius}, kResolution * nearest_entry, known));
    }
    return level;
  }

 private:
  CapSearch search_;
};

}  // namespace

CapLimits::CapLimits(const TriangleMesh& mesh, Layer layer) {
  const double most = std::ceil(std::sqrt(kEntriesPerFace / 6.0 * static_cast<double>(mesh.faces.size())));
  const auto cells = static_cast<std::int32_t>(std::clamp(most, 4.0, kMostCells));
  while (reach(finest_) > kFinestReach / static_cast<float>(cells)) ++finest_;

  LevelsBuilder builder(mesh, layer);
  std::vector<Level> levels(static_cast<std::size_t>(finest_) + 2);
  levels.back() = builder.make(2 * cells, kAloneReach, nullptr);
  for (int k = finest_; k > 0; --k) {
    const auto i = static_cast<std::size_t>(k);
    const auto of_reach = std::min(static_cast<std::int32_t>(kCellsPerReach / reach(k)), cells);
    levels[i] = builder.make(of_reach, reach(k), k < finest_ ? &levels[i + 1] : nullptr);
  }
  levels.front() = {1, std::vector<float>(24, builder.overall())};
  for (const Level& level : levels) {
    steps_.push_back(static_cast<std::int32_t>(limits_.size() << kLineBits) + level.cells);
    limits_.insert(limits_.end(), level.limits.begin(), level.limits.end());
  }
}

float CapLimits::reach(int level) const {
  if (level == 0) return HUGE_VALF;
  return std::bit_cast<float>(static_cast<std::uint32_t>(kWidest + 1 - level) << kQuarterOctave);
}

float CapLimits::look_up(int level, const Vec3& x) const {
  if (level == 0) return limits_.front();
  const auto step = static_cast<std::uint32_t>(steps_[static_cast<std::size_t>(level)]);
  const std::size_t cells = step & static_cast<std::uint32_t>(kMostLines);
  return limits_[(step >> kLineBits) + cube_entry(x, cells)];
}

std::size_t CapLimits::bytes() const {
  return steps_.size() * sizeof(std::int32_t) + limits_.size() * sizeof(float);
}

}  // namespace impinge
