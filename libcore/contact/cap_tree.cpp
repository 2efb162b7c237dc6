// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cap_tree.hpp"

#include <algorithm>
#include <numeric>

#include "contact/cap_summary.hpp"

namespace impinge {
namespace {

constexpr std::size_t kLanes = CapBlock::kLanes;
constexpr std::size_t kFew = kLanes * kLanes;  // items that are split into runs, and no longer into cells

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
  // Counting sort by the cells of the last level.
  void sort() {
    std::vector<std::uint32_t> cell(items_.size());
    start_.assign((std::size_t{6} << (3 * levels_)) + 2, 0);
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
    return start_[cell.prefix << (3 * (levels_ - cell.level))];
  }
  ItemRun run(const CubeCell& cell) const {
    return {begin(cell), begin({cell.level, cell.prefix + 1}) - begin(cell)};
  }

  // The node of a cell; one with a single child is that of the child.
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

  // Of items beside each other: up to eight runs of up to eight, or more of the deepest cells.
  SummarisedNode of_run(const ItemRun& all) {
    if (all.count == 1) return leaf(all);
    const auto each = static_cast<std::uint32_t>(all.count <= kLanes ? 1 : (all.count + kLanes - 1) / kLanes);
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

  // A new block of these parts, and the node above it.
  template <class Part, class Make>
  SummarisedNode fill_block(const std::vector<Part>& parts, const Make& make) {
    const std::size_t block = blocks_.size();
    blocks_.emplace_back();
    std::vector<CapSummary> summaries;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const SummarisedNode node = make(parts[k]);
      summaries.push_back(node.summary);
      if (k == 0) {  // in the places that stay empty, too: their numbers are worked on and not looked at
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
  std::vector<std::uint32_t> start_;  // of each cell of the last level
};

}  // namespace

CapTree::CapTree(std::span<const CapItem> items) {
  if (!items.empty()) CapTreeBuilder(items, blocks_, order_).build();
}

}  // namespace impinge
