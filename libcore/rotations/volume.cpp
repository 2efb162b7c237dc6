// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/volume.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <stdexcept>

#include "files/thread_team.hpp"
#include "mesh/disjoint_sets.hpp"

namespace impinge {
namespace {

constexpr std::size_t kBatch = 1024;  // cells that are split before anyone looks at the width
constexpr std::size_t kTaken = 16;    // of them that a thread takes at a time
constexpr std::uint8_t kCertainly = 1;
constexpr std::uint8_t kPerhaps = 2;

}  // namespace

// Splits open cells, the largest first.
class MotionVolume::Refinement {
 public:
  Refinement(MotionVolume& volume, const CellTest& test, const VolumeSettings& settings)
      : volume_(volume), settings_(settings), known_(settings.known) {
    for (std::size_t k = 0; k < std::max<std::size_t>(settings.threads, 1); ++k) searches_.emplace_back(test);
  }

  void run() {
    std::vector<Asked> cubes;
    for (std::uint64_t cube = 0; cube < 4; ++cube) cubes.push_back({{0, cube}, {}, {}, 0.0});
    volume_.nodes_.resize(4);
    volume_.hints_.resize(4);
    decide(cubes);
    for (std::uint32_t cube = 0; cube < 4; ++cube) take_in(cubes[cube], cube);
    report(cubes);
    while (!waiting_.empty() && open_ > settings_.width) {
      const std::size_t left = (settings_.most_cells - std::min(settings_.most_cells, cells_)) / 8;
      if (left == 0) break;
      split(std::min(left, kBatch));
    }
  }

  std::size_t cells() const { return cells_; }

 private:
  struct Asked {
    RotationCell cell;
    CellHint hint;
    CellVerdict verdict;
    double share;
  };

  void split(std::size_t most) {
    std::vector<Open>& largest = waiting_.begin()->second;
    std::size_t& begun = begun_;
    const std::size_t count = std::min(most, largest.size() - begun);
    const std::vector<Open> parents(largest.begin() + static_cast<std::ptrdiff_t>(begun),
                                    largest.begin() + static_cast<std::ptrdiff_t>(begun + count));
    begun += count;
    if (begun == largest.size()) {
      waiting_.erase(waiting_.begin());
      begun = 0;
    }
    std::vector<Asked> children;
    for (const Open& parent : parents) {
      open_ -= parent.share;
      for (std::uint64_t k = 0; k < 8; ++k)
        children.push_back({child(parent.cell, k), volume_.hints_[parent.node], {}, 0.0});
    }
    decide(children);
    for (std::size_t k = 0; k < parents.size(); ++k) {
      const auto first = static_cast<std::uint32_t>(volume_.nodes_.size());
      volume_.nodes_[parents[k].node].first = first;
      volume_.nodes_.resize(first + 8);
      volume_.hints_.resize(first + 8);
      for (std::uint32_t l = 0; l < 8; ++l) take_in(children[8 * k + l], first + l);
    }
    report(children);
  }

  void decide(std::vector<Asked>& cells) {
    std::atomic<std::size_t> next = 0;
    on_threads(searches_.size(), [&](std::size_t thread) {
      for (std::size_t from = next.fetch_add(kTaken); from < cells.size(); from = next.fetch_add(kTaken)) {
        for (std::size_t k = from; k < std::min(cells.size(), from + kTaken); ++k) {
          Asked& at = cells[k];
          at.verdict = k < known_.size() ? known_[k] : searches_[thread].decide(at.cell, at.hint);
          at.share = share(at.cell);
        }
      }
    });
    known_ = known_.subspan(std::min(known_.size(), cells.size()));
    cells_ += cells.size();
  }

  void take_in(const Asked& at, std::uint32_t node) {
    volume_.nodes_[node].state = at.verdict.state;
    volume_.hints_[node] = at.verdict.hint;
    if (at.verdict.state != CellState::open) return;
    open_ += at.share;
    if (at.cell.level == kFinestCells) return;
    // Not into the list that is being split: a child has an eighth of the share, or somewhat more or less.
    const auto octave = static_cast<int>(std::floor(-4.0 * std::log2(at.share)));
    waiting_[std::max(octave, next_octave())].push_back({at.cell, node, at.share});
  }
  int next_octave() const { return waiting_.empty() ? 0 : waiting_.begin()->first + (begun_ > 0 ? 1 : 0); }

  void report(const std::vector<Asked>& cells) const {
    if (!settings_.reached) return;
    std::vector<CellVerdict> verdicts;
    verdicts.reserve(cells.size());
    for (const Asked& at : cells) verdicts.push_back(at.verdict);
    settings_.reached(verdicts, open_);
  }

  MotionVolume& volume_;
  const VolumeSettings& settings_;
  std::span<const CellVerdict> known_;
  std::vector<CellSearch> searches_;
  std::map<int, std::vector<Open>> waiting_;  // by share, quarter octaves below 1
  std::size_t begun_ = 0;                     // so many of the first list are split
  double open_ = 0.0;
  std::size_t cells_ = 0;
};

MotionVolume::MotionVolume(const CellTest& test, const VolumeSettings& settings) {
  if (!(settings.width > 0.0))
    throw std::invalid_argument(
        "motion volume: the width must be above 0, as 0.01; the cells never end else");
  Refinement refinement(*this, test, settings);
  refinement.run();
  shares_.cells = refinement.cells();
  join(kCertainly);
  join(kPerhaps);
  sum();
}

template <class Visit>
void MotionVolume::visit_leaves(const RotationCell& cell, std::uint32_t node, const Visit& visit) const {
  if (nodes_[node].first == 0) {
    visit(cell, node);
    return;
  }
  for (std::uint32_t k = 0; k < 8; ++k) visit_leaves(child(cell, k), nodes_[node].first + k, visit);
}

VolumeCell MotionVolume::leaf(const RotationCell& cell, std::uint32_t node) const {
  const Node& at = nodes_[node];
  return {cell, at.state, (at.reach & kCertainly) != 0, (at.reach & kPerhaps) != 0, hints_[node]};
}

void MotionVolume::for_each(const std::function<void(const VolumeCell&)>& visit) const {
  for (std::uint32_t cube = 0; cube < 4; ++cube) {
    visit_leaves({0, cube}, cube,
                 [&](const RotationCell& cell, std::uint32_t node) { visit(leaf(cell, node)); });
  }
}

// The node of the cell, or the leaf that holds it.
std::uint32_t MotionVolume::find(const RotationCell& cell) const {
  auto node = static_cast<std::uint32_t>(cell.number >> (3 * cell.level));
  for (std::uint32_t level = cell.level; level > 0 && nodes_[node].first != 0; --level)
    node = nodes_[node].first + static_cast<std::uint32_t>((cell.number >> (3 * (level - 1))) & 7U);
  return node;
}

VolumeCell MotionVolume::at(const Quaternion4& q) const {
  RotationCell cell = cell_of(q, kFinestCells);
  const std::uint32_t node = find(cell);
  for (; cell.level > 0 && find(parent(cell)) == node;) cell = parent(cell);
  return leaf(cell, node);
}

// Joins leaves across their sides and marks those that are joined to the neutral rotation, which is where the
// eight parts of the first cube meet.
void MotionVolume::join(std::uint8_t bit) {
  const auto counts = [&](std::uint32_t node) {
    return bit == kCertainly ? nodes_[node].state == CellState::free
                             : nodes_[node].state != CellState::blocked;
  };
  DisjointSets sets(nodes_.size());
  for (std::uint32_t cube = 0; cube < 4; ++cube) {
    visit_leaves({0, cube}, cube, [&](const RotationCell& cell, std::uint32_t node) {
      if (!counts(node)) return;
      for (std::size_t side = 0; side < 6; ++side) {
        const std::uint32_t other = find(beside(cell, side));
        if (nodes_[other].first == 0 && counts(other)) sets.join(node, other, false);
      }
    });
  }
  std::vector<bool> marked(nodes_.size(), false);
  for (std::uint32_t k = 0; k < 8; ++k) {
    std::uint32_t node = 0;
    for (std::uint32_t at = k; nodes_[node].first != 0; at = 7 - k) node = nodes_[node].first + at;
    if (counts(node)) marked[sets.find(node).root] = true;
  }
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
    if (nodes_[node].first == 0 && counts(node) && marked[sets.find(node).root]) nodes_[node].reach |= bit;
  }
}

void MotionVolume::sum() {
  for_each([&](const VolumeCell& at) {
    const double part = share(at.cell);
    (at.state == CellState::free      ? shares_.free
     : at.state == CellState::blocked ? shares_.blocked
     : at.state == CellState::unknown ? shares_.unknown
                                      : shares_.open) += part;
    if (at.reachable) shares_.reachable_low += part;
    if (at.within_reach) shares_.reachable_high += part;
  });
}

}  // namespace impinge
