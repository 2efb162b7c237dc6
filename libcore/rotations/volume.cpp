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

constexpr std::size_t kBatch = 128;         // cells that are split before the open share is looked at
constexpr std::size_t kTaken = 16;          // cells that a thread takes at a time, of whole parents
constexpr double kFineWidth = 0.03;         // up to this width coarser cells are worth to be searched
constexpr std::uint32_t kCoarsestFree = 6;  // for a larger one, free parts are looked for from this level on
constexpr std::uint8_t kCertainly = 1;
constexpr std::uint8_t kPerhaps = 2;

}  // namespace

// Splits open cells, the largest first.
class MotionVolume::Refinement {
 public:
  Refinement(MotionVolume& volume, const CellTest& test, const VolumeSettings& settings)
      : volume_(volume),
        settings_(settings),
        coarsest_free_(settings.width <= kFineWidth || test.bodies().has_inside() ? 0 : kCoarsestFree),
        known_(settings.known) {
    for (std::size_t k = 0; k < std::max<std::size_t>(settings.threads, 1); ++k) searches_.emplace_back(test);
  }

  void run() {
    std::vector<Asked> cubes;
    for (std::uint64_t cube = 0; cube < 4; ++cube)
      cubes.push_back({{0, cube}, {}, {}, 0.0, {}, CellState::open});
    volume_.nodes_.resize(4);
    volume_.hints_.resize(4);
    volume_.parts_.resize(1);
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
    double share;  // of all rotations that is open in this cell
    CellPart part;
    CellState told;  // what the part of its parent says of it; open if nothing
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
      CellPart& part = volume_.parts_[volume_.nodes_[parent.node].part];
      for (std::uint64_t k = 0; k < 8; ++k) {
        const CellState told = part.blocks(k)  ? CellState::blocked
                               : part.frees(k) ? CellState::free
                                               : CellState::open;
        children.push_back({child(parent.cell, k), volume_.hints_[parent.node], {}, 0.0, {}, told});
      }
      part = {};
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
          if (at.cell.level > 0 && k % 8 == 0) searches_[thread].enter(parent(at.cell));
          if (at.told != CellState::open)
            at.verdict = {at.told, at.hint};
          else
            at.verdict = k < known_.size() ? known_[k] : searches_[thread].decide(at.cell, at.hint);
          if (at.verdict.state != CellState::open) continue;
          at.part = searches_[thread].part_of(at.cell, at.verdict.hint, at.cell.level >= coarsest_free_);
          at.verdict.state = at.part.state;
          at.share = std::max(0.0, share(at.cell) - at.part.free_share - at.part.blocked_share);
        }
      }
    });
    known_ = known_.subspan(std::min(known_.size(), cells.size()));
    cells_ += cells.size();
  }

  void take_in(Asked& at, std::uint32_t node) {
    volume_.nodes_[node].state = at.verdict.state;
    volume_.hints_[node] = at.verdict.hint;
    if (at.verdict.state != CellState::open) return;
    open_ += at.share;
    if (!at.part.empty()) {
      volume_.nodes_[node].part = static_cast<std::uint32_t>(volume_.parts_.size());
      volume_.parts_.push_back(std::move(at.part));
    }
    if (at.cell.level == kFinestCells || at.share <= 0.0) return;
    // A child with nearly the share of its parent must not join the list that is being split.
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
  std::uint32_t coarsest_free_;  // the level from which on free parts are looked for
  std::span<const CellVerdict> known_;
  std::vector<CellSearch> searches_;
  std::map<int, std::vector<Open>> waiting_;  // open cells by quarter octaves of their share
  std::size_t begun_ = 0;                     // so many of the first list have been split
  double open_ = 0.0;
  std::size_t cells_ = 0;
};

MotionVolume::MotionVolume(const CellTest& test, const VolumeSettings& settings)
    : play_mm_(test.question().play_mm) {
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
  const bool free = at.state == CellState::free;
  return {cell,
          at.state,
          free && (at.reach & kCertainly) != 0,
          (at.reach & kPerhaps) != 0,
          hints_[node],
          at.part == 0 ? nullptr : &parts_[at.part],
          free && play_mm_ > 0.0 ? std::optional(shift_of(hints_[node], play_mm_)) : std::nullopt};
}

void MotionVolume::for_each(const std::function<void(const VolumeCell&)>& visit) const {
  for (std::uint32_t cube = 0; cube < 4; ++cube) {
    visit_leaves({0, cube}, cube,
                 [&](const RotationCell& cell, std::uint32_t node) { visit(leaf(cell, node)); });
  }
}

// The node of the cell; or the leaf that holds it, if it is not divided so far.
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
  VolumeCell found = leaf(cell, node);
  if (found.part == nullptr) return found;
  const Vec3 t = CellFrame(cell).place(q);
  if (found.part->is_blocked(t)) {
    found.state = CellState::blocked;
    found.within_reach = false;
  } else if (found.part->is_free(t)) {
    found.state = CellState::free;
    found.reachable = (nodes_[node].reach & kCertainly) != 0;
  }
  return found;
}

// Is the rotation q of the leaf proven free?
bool MotionVolume::is_free(const RotationCell& cell, std::uint32_t node, const Quaternion4& q) const {
  const Node& at = nodes_[node];
  return at.state == CellState::free || (at.part != 0 && parts_[at.part].is_free(CellFrame(cell).place(q)));
}

// Is one of nine places on a side of a leaf free, both for the leaf and for its neighbour there? The
// neighbour must be no smaller.
bool MotionVolume::meet(const RotationCell& cell, std::uint32_t node, std::size_t side) const {
  RotationCell beyond = beside(cell, side);
  const std::uint32_t other = find(beyond);
  while (beyond.level > 0 && find(parent(beyond)) == other) beyond = parent(beyond);
  for (const double a : {0.0, -1.0, 1.0}) {
    for (const double b : {0.0, -1.0, 1.0}) {
      std::array<double, 3> along{};
      along[side / 2] = side % 2 == 1 ? 1.0 : -1.0;
      along[(side / 2 + 1) % 3] = a;
      along[(side / 2 + 2) % 3] = b;
      const Quaternion4 q = point_of(cell, along);
      if (is_free(cell, node, q) && is_free(beyond, other, q)) return true;
    }
  }
  return false;
}

// Joins leaves across their sides and marks those that are joined to the neutral rotation, which is the
// common corner of the first cube's eighths.
void MotionVolume::join(std::uint8_t bit) {
  const auto counts = [&](std::uint32_t node) {
    const Node& at = nodes_[node];
    if (bit == kPerhaps) return at.state != CellState::blocked;
    return (at.state == CellState::free && hints_[node].shift == ShiftSteps{}) ||
           (at.part != 0 && !parts_[at.part].free.empty());
  };
  DisjointSets sets(nodes_.size());
  for (std::uint32_t cube = 0; cube < 4; ++cube) {
    visit_leaves({0, cube}, cube, [&](const RotationCell& cell, std::uint32_t node) {
      if (!counts(node)) return;
      for (std::size_t side = 0; side < 6; ++side) {
        const std::uint32_t other = find(beside(cell, side));
        if (nodes_[other].first != 0 || !counts(other)) continue;
        const bool parts = nodes_[node].part + nodes_[other].part != 0;
        if (bit == kPerhaps || !parts || meet(cell, node, side)) sets.join(node, other, false);
      }
    });
  }
  const Quaternion4 neutral = Quaternion4::Unit(0);
  std::vector<bool> marked(nodes_.size(), false);
  for (std::uint32_t k = 0; k < 8; ++k) {
    RotationCell cell{0, 0};
    std::uint32_t node = 0;
    for (std::uint32_t at = k; nodes_[node].first != 0; at = 7 - k) {
      node = nodes_[node].first + at;
      cell = child(cell, at);
    }
    const CellPart& part = parts_[nodes_[node].part];
    const bool from =
        bit == kCertainly ? is_free(cell, node, neutral) : !part.is_blocked(CellFrame(cell).place(neutral));
    if (counts(node) && from) marked[sets.find(node).root] = true;
  }
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
    if (nodes_[node].first == 0 && counts(node) && marked[sets.find(node).root]) nodes_[node].reach |= bit;
  }
}

void MotionVolume::sum() {
  for (std::uint32_t cube = 0; cube < 4; ++cube) {
    visit_leaves({0, cube}, cube, [&](const RotationCell& cell, std::uint32_t node) {
      const Node& at = nodes_[node];
      const CellPart& part = parts_[at.part];
      const double all = share(cell);
      const double free = at.state == CellState::free ? all : part.free_share;
      const double blocked = at.state == CellState::blocked ? all : part.blocked_share;
      shares_.free += free;
      shares_.blocked += blocked;
      if (at.state == CellState::unknown) shares_.unknown += all;
      if (at.state == CellState::open) shares_.open += std::max(0.0, all - free - blocked);
      if ((at.reach & kCertainly) != 0) shares_.reachable_low += free;
      if ((at.reach & kPerhaps) != 0) shares_.reachable_high += all - blocked;
    });
  }
}

}  // namespace impinge
