// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/cap_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "culling/cube_place.hpp"
#include "sampling/face_index.hpp"

namespace impinge {
namespace {

constexpr double kMostCells = 256.0;
constexpr float kCellsPerReach =
    8.0F;  // at least: c is at most a sixth of the reach, where the grid is not too fine
constexpr float kFinestReach = 2.0F;        // in cells of the finest grid
constexpr double kEntriesPerFace = 0.7;     // of the finest grid for caps
constexpr double kResolution = 0.25;        // of c: nodes as narrow as that are taken whole
constexpr double kSteepSlope = 1e4;         // see near_faces.cpp
constexpr double kChordOfQuarter = 1.1108;  // an angle up to a quarter turn over its chord

std::vector<CapItem> items_of(const TriangleMesh& mesh) {
  std::vector<CapItem> items;
  items.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    FaceIndex::SeenFace seen = see_face(cone.corners());
    if (seen.side == 0 && cone.edge_on()) continue;
    if (!(cone.largest_slope() <= kSteepSlope)) seen.range.low = 0.0;
    if (!(seen.cap.radius < 0.5 * kPi)) seen.cap.radius = kPi;
    items.push_back({seen.cap, seen.range});
  }
  return items;
}

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

// A cap of directions about a unit axis, and the limit of what it meets so far.
class CapSearch {
 public:
  CapSearch(const TriangleMesh& mesh, Layer layer)
      : items_(items_of(mesh)), tree_(items_), nearest_(layer == Layer::nearest) {}

  float limit(const DirectionCap& cap, double resolution) {
    cap_ = cap;
    resolution_ = resolution;
    limit_ = nearest_ ? HUGE_VALF : -HUGE_VALF;
    for (std::size_t block = 0; block < std::min(CapTree::kRoots, tree_.blocks().size()); ++block)
      visit(block);
    return limit_;
  }

 private:
  void visit(std::size_t at) {
    const CapBlock& block = tree_.blocks()[at];
    for (std::size_t k = 0; k < block.nodes; ++k) {
      const auto lane = static_cast<Eigen::Index>(k);
      if (nearest_ ? block.low[lane] >= limit_ : block.high[lane] <= limit_) continue;
      const Vec3 axis(block.x[lane], block.y[lane], block.z[lane]);
      const double chord = (axis - cap_.axis).norm();
      const double angle = block.angle[lane];
      if (chord > cap_.radius + angle) continue;  // an angle is no less than its chord
      const bool inside = chord < 1.4 && kChordOfQuarter * chord + angle <= cap_.radius;
      if (inside || angle <= resolution_) {
        limit_ = nearest_ ? block.low[lane] : block.high[lane];
      } else if (block.leaf(k)) {
        for (std::uint32_t i = 0; i < block.items[k]; ++i) include(items_[tree_.order()[block.first[k] + i]]);
      } else {
        visit(block.first[k]);
      }
    }
  }

  void include(const CapItem& item) {
    if ((item.cap.axis - cap_.axis).norm() > cap_.radius + item.cap.radius) return;
    if (nearest_) {
      limit_ = std::min(limit_, std::nextafter(static_cast<float>(item.range.low), 0.0F));
    } else {
      limit_ = std::max(limit_, std::nextafter(static_cast<float>(item.range.high), HUGE_VALF));
    }
  }

  std::vector<CapItem> items_;
  CapTree tree_;
  bool nearest_;
  DirectionCap cap_;
  double resolution_ = 0.0;
  float limit_ = 0.0F;
};

}  // namespace

CapLimits::CapLimits(const TriangleMesh& mesh, Layer layer, double margin) {
  CapSearch search(mesh, layer);
  overall_ = search.limit({Vec3::UnitZ(), 4.0}, 0.0);
  const double most = std::ceil(std::sqrt(kEntriesPerFace / 6.0 * static_cast<double>(mesh.faces.size())));
  const auto cells = static_cast<std::uint32_t>(std::clamp(most, 4.0, kMostCells));
  levels_.resize(1);
  levels_[0].limits.assign(24, overall_);  // one cell a face
  while (levels_.back().reach > kFinestReach / static_cast<float>(cells)) {
    const auto bits = static_cast<unsigned>(kWidest - static_cast<int>(levels_.size()) + 1) << kHalfOctave;
    const auto reach = std::bit_cast<float>(bits);
    levels_.push_back({std::min(static_cast<std::uint32_t>(kCellsPerReach / reach), cells), reach, {}});
  }
  finest_ = static_cast<int>(levels_.size()) - 1;
  single_ = {2 * cells, 0.0F, {}};
  const auto fill = [&](Level& level) {
    const double nearest_entry = std::numbers::sqrt2 / static_cast<double>(level.cells);
    const double radius = nearest_entry + level.reach + margin + kNodeSlack;
    for (const Vec3& axis : entries(level.cells))
      level.limits.push_back(search.limit({axis, radius}, kResolution * nearest_entry));
  };
  std::for_each(levels_.begin() + 1, levels_.end(), fill);
  fill(single_);
}

std::size_t CapLimits::bytes() const {
  std::size_t entries = single_.limits.size();
  for (const Level& level : levels_) entries += level.limits.size();
  return entries * sizeof(float);
}

}  // namespace impinge
