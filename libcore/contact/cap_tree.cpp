// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cap_tree.hpp"

#include <algorithm>
#include <cmath>

#include "contact/cube_cell.hpp"
#include "sphere/as_floats.hpp"
#include "sphere/lists.hpp"

namespace impinge {
namespace {

constexpr std::size_t kLanes = CapBlock::kLanes;
constexpr std::size_t kFew = kLanes * kLanes;  // items that are split into runs, and no longer into cells

constexpr double kQuarter = 0.5 * kPi;

float above(double number) { return std::nextafter(static_cast<float>(number), HUGE_VALF); }
float below(double number) { return std::nextafter(static_cast<float>(number), 0.0F); }

// The numbers of a node, in double.
struct CapSummary {
  DirectionCap cap;     // holds the directions of all parts
  RadiusRange range;    // holds their radii, mm
  double widest = 0.0;  // largest cap of a part, radians
};

// A node, before it is written into its block.
struct SummarisedNode {
  CapSummary summary;       // of its parts
  std::uint32_t first = 0;  // see CapBlock
  std::uint32_t items = 0;
};

// One cap and range that hold the caps and ranges of several parts. The axis is as exact as a float.
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
  all.cap.axis = as_floats(all.cap.axis.normalized());
  for (const CapSummary& part : parts)
    all.cap.radius = std::max(all.cap.radius, angle_between(all.cap.axis, part.cap.axis) + part.cap.radius);
  return all;
}

// Narrows the cap to the directions that parts with their axes in the cell can have.
void keep_to(const CubeCell& cell, CapSummary& summary) {
  double widest = 0.0;
  for (const Vec3& corner : cell_corners(cell))
    widest = std::max(widest, angle_between(summary.cap.axis, corner));
  if (widest < kQuarter) summary.cap.radius = std::min(summary.cap.radius, widest + summary.widest);
}

// Writes a node into a lane, rounded outwards.
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

// Items that follow each other in the order of a tree.
struct ItemRun {
  std::uint32_t first;  // place of the first of them
  std::uint32_t count;  // number of them
};

class CapTreeBuilder {
 public:
  CapTreeBuilder(std::span<const CapItem> items, std::vector<CapBlock>& blocks,
                 std::vector<std::uint32_t>& order)
      : items_(items), blocks_(blocks), order_(order) {
    while (levels_ < CapTree::kDeepest && ((6 * kLanes) << (3 * levels_)) < items.size()) ++levels_;
  }

  void build() {
    sort();
    std::vector<CubeCell> faces;
    for (std::size_t face = 0; face < 6; ++face) {
      if (run({0, face}).count > 0) faces.push_back({0, face});
    }
    fill_block(faces, [&](const CubeCell& cell) { return of_cell(cell); });
  }

 private:
  // Sorts the items by the cells of the last level.
  void sort() {
    std::vector<Lists::Pair> pairs;
    for (std::uint32_t k = 0; k < items_.size(); ++k)
      pairs.push_back({static_cast<std::uint32_t>(cell_of(items_[k].cap.axis, levels_)), k});
    in_cell_ = Lists(std::size_t{6} << (3 * levels_), pairs);
    order_ = in_cell_.numbers();
  }

  std::uint32_t begin(const CubeCell& cell) const {
    return in_cell_.first(cell.prefix << (3 * (levels_ - cell.level)));
  }
  ItemRun run(const CubeCell& cell) const {
    return {begin(cell), begin({cell.level, cell.prefix + 1}) - begin(cell)};
  }

  // The node of a cell, or the node of its child if there is only one.
  SummarisedNode of_cell(CubeCell cell) {
    for (;;) {
      const ItemRun all = run(cell);
      if (all.count <= kFew || cell.level == levels_) {
        SummarisedNode node = of_run(all);
        keep_to(cell, node.summary);
        return node;
      }
      std::vector<CubeCell> parts;
      for (std::size_t k = 0; k < kLanes; ++k) {
        const CubeCell child{cell.level + 1, kLanes * cell.prefix + k};
        if (run(child).count > 0) parts.push_back(child);
      }
      if (parts.size() > 1) {
        SummarisedNode node = fill_block(parts, [&](const CubeCell& part) { return of_cell(part); });
        keep_to(cell, node.summary);
        return node;
      }
      cell = parts[0];
    }
  }

  // The node of a run of items: up to eight runs of up to eight items, or more in the deepest cells.
  SummarisedNode of_run(const ItemRun& all) {
    if (all.count == 1) return leaf(all);
    // Runs of eight items, as long as there are no more than eight of them: fewer blocks, all lanes in use.
    const auto each = static_cast<std::uint32_t>(
        all.count <= kLanes ? 1 : std::max<std::size_t>(kLanes, (all.count + kLanes - 1) / kLanes));
    std::vector<ItemRun> parts;
    for (std::uint32_t k = 0; k < all.count; k += each)
      parts.push_back({all.first + k, std::min(each, all.count - k)});
    return fill_block(parts,
                      [&](const ItemRun& part) { return part.count <= kLanes ? of_run(part) : leaf(part); });
  }

  SummarisedNode leaf(const ItemRun& run) const {
    std::vector<CapSummary> parts;
    for (std::uint32_t k = 0; k < run.count; ++k) {
      const CapItem& item = items_[order_[run.first + k]];
      parts.push_back({item.cap, item.range, item.cap.radius});
    }
    return {summary_of(parts), run.first, run.count};
  }

  // Makes a block of these parts, and returns the node above it.
  template <class Part, class Make>
  SummarisedNode fill_block(const std::vector<Part>& parts, const Make& make) {
    const std::size_t block = blocks_.size();
    blocks_.emplace_back();
    std::vector<CapSummary> summaries;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const SummarisedNode node = make(parts[k]);
      summaries.push_back(node.summary);
      if (k == 0) {  // fills the unused places, too: their numbers are computed with, and ignored
        for (std::size_t lane = 0; lane < kLanes; ++lane) write(node, lane, blocks_[block]);
      }
      write(node, k, blocks_[block]);
    }
    blocks_[block].nodes = static_cast<std::uint32_t>(parts.size());
    return {summary_of(summaries), static_cast<std::uint32_t>(block), 0};
  }

  std::span<const CapItem> items_;
  std::vector<CapBlock>& blocks_;
  std::vector<std::uint32_t>& order_;
  std::size_t levels_ = 0;
  Lists in_cell_;  // items of each cell of the last level
};

}  // namespace

std::optional<CapItem> cap_item(const TriangleMesh& mesh, const Face& face) {
  const TriangleCone cone = cone_of(mesh, face);
  if (cone.edge_on()) return std::nullopt;
  FaceCap seen = face_cap(cone.corners());
  if (!(cone.largest_slope() <= kSteepSlope)) seen.range.low = 0.0;
  if (!seen.small()) seen.cap.radius = kPi;
  return CapItem{seen.cap, seen.range};
}

CapTree::CapTree(std::span<const CapItem> items) {
  if (!items.empty()) CapTreeBuilder(items, blocks_, order_).build();
  blocks_.shrink_to_fit();
}

}  // namespace impinge
