// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/cap_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "culling/cube_cell.hpp"

namespace impinge {
namespace {

constexpr std::size_t kLeafItems = 8;
constexpr double kQuarter = 0.5 * kPi;

// What a node is made of, in double.
struct Summary {
  DirectionCap cap;
  RadiusRange range;
  double widest = 0.0;  // cap of an item
};

float above(double number) { return std::nextafter(static_cast<float>(number), HUGE_VALF); }
float below(double number) { return std::nextafter(static_cast<float>(number), 0.0F); }

// The caps and ranges of several in one. The axis is as exact as a float.
Summary summary_of(std::span<const Summary> parts) {
  Summary all;
  all.cap.axis = Vec3::Zero();
  for (const Summary& part : parts) {
    all.cap.axis += part.cap.axis;
    all.range.include(part.range.low);
    all.range.include(part.range.high);
    all.widest = std::max(all.widest, part.widest);
  }
  if (all.cap.axis.norm() < 1e-3) all.cap.axis = Vec3::UnitZ();
  all.cap.axis = all.cap.axis.normalized().cast<float>().cast<double>();
  for (const Summary& part : parts)
    all.cap.radius = std::max(all.cap.radius, angle_between(all.cap.axis, part.cap.axis) + part.cap.radius);
  return all;
}

void keep_to(const CubeCell& cell, Summary& summary) {
  double widest = 0.0;
  for (const Vec3& corner : cell_corners(cell))
    widest = std::max(widest, angle_between(summary.cap.axis, corner));
  if (widest < kQuarter) summary.cap.radius = std::min(summary.cap.radius, widest + summary.widest);
}

// A node, before it is written into its block.
struct Node {
  Summary summary;
  std::uint32_t first = 0;
  std::uint32_t items = 0;
};

void write(const Node& node, std::size_t at, CapBlock& block) {
  const auto lane = static_cast<Eigen::Index>(at);
  const Summary& summary = node.summary;
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
  block.first[at] = node.first;
  block.items[at] = node.items;
}

class CapTreeBuilder {
 public:
  CapTreeBuilder(std::span<const CapItem> items, std::vector<CapBlock>& blocks,
                 std::vector<std::uint32_t>& order)
      : items_(items), blocks_(blocks), order_(order) {
    while (levels_ < CapTree::kDeepest && (std::size_t{24} << (2 * levels_)) < items.size()) ++levels_;
  }

  void build() {
    sort();
    blocks_.resize(CapTree::kRoots);
    for (std::size_t block = 0; block < CapTree::kRoots; ++block) {
      std::vector<CubeCell> faces;
      for (std::size_t face = 4 * block; face < std::min<std::size_t>(4 * block + 4, 6); ++face) {
        if (count({0, face}) > 0) faces.push_back({0, face});
      }
      if (!faces.empty()) fill_block(block, faces);
    }
  }

 private:
  // Counting sort by the cells of the last level.
  void sort() {
    std::vector<std::uint32_t> cell(items_.size());
    start_.assign((std::size_t{6} << (2 * levels_)) + 2, 0);
    for (std::size_t k = 0; k < items_.size(); ++k) {
      cell[k] = static_cast<std::uint32_t>(cell_of(items_[k].cap.axis, levels_));
      ++start_[cell[k] + 2];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    order_.resize(items_.size());
    for (std::size_t k = 0; k < items_.size(); ++k)
      order_[start_[cell[k] + 1]++] = static_cast<std::uint32_t>(k);
  }

  std::uint32_t begin(const CubeCell& cell) const {
    return start_[cell.prefix << (2 * (levels_ - cell.level))];
  }
  std::uint32_t count(const CubeCell& cell) const {
    return begin({cell.level, cell.prefix + 1}) - begin(cell);
  }

  std::vector<CubeCell> children(const CubeCell& cell) const {
    std::vector<CubeCell> found;
    for (std::size_t k = 0; k < 4; ++k) {
      const CubeCell child{cell.level + 1, 4 * cell.prefix + k};
      if (count(child) > 0) found.push_back(child);
    }
    return found;
  }

  // The node of a cell; one with a single child is that of the child.
  Node make(CubeCell cell) {
    for (;;) {
      if (count(cell) <= kLeafItems || cell.level == levels_) return make_leaf(cell);
      const std::vector<CubeCell> parts = children(cell);
      if (parts.size() > 1) {
        const std::size_t block = blocks_.size();
        blocks_.emplace_back();
        Node node{fill_block(block, parts), static_cast<std::uint32_t>(block), 0};
        keep_to(cell, node.summary);
        return node;
      }
      cell = parts[0];
    }
  }

  Node make_leaf(const CubeCell& cell) const {
    std::vector<Summary> parts;
    for (std::uint32_t k = 0; k < count(cell); ++k) {
      const CapItem& item = items_[order_[begin(cell) + k]];
      parts.push_back({item.cap, item.range, item.cap.radius});
    }
    return {summary_of(parts), begin(cell), count(cell)};
  }

  Summary fill_block(std::size_t block, const std::vector<CubeCell>& parts) {
    std::vector<Summary> summaries;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Node node = make(parts[k]);
      summaries.push_back(node.summary);
      if (k == 0) {  // in the places that stay empty, too: their numbers are worked on and not looked at
        for (std::size_t lane = 0; lane < CapBlock::kLanes; ++lane) write(node, lane, blocks_[block]);
      }
      write(node, k, blocks_[block]);
    }
    blocks_[block].nodes = static_cast<std::uint32_t>(parts.size());
    return summary_of(summaries);
  }

  std::span<const CapItem> items_;
  std::vector<CapBlock>& blocks_;
  std::vector<std::uint32_t>& order_;
  std::size_t levels_ = 0;
  std::vector<std::uint32_t> start_;  // of each cell of the last level
};

}  // namespace

CapTree::CapTree(std::span<const CapItem> items) {
  if (!items.empty()) CapTreeBuilder(items, blocks_, order_).build();
}

}  // namespace impinge
