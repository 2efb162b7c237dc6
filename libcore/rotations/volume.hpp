// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The motion volume of a joint: all its rotations, as cells that are free, blocked or still open
/// (rotations/cell_test.hpp), refined until the open ones are a small enough share. Theorem 14 (volume).
///
/// The open cells with the largest shares are split first, those of a quarter octave of shares together, in
/// the order in which they were found. So the result depends on the joint and the settings alone, not on time
/// or the number of threads.
///
/// An open cell may be free and blocked in parts (rotations/cell_part.hpp): then only the rest of it is open,
/// a slab about the border that is as thin as the square of the cell.
///
/// Rotations that can be reached from the neutral pose without contact are at least the free cells and parts
/// that are joined to it, across sides, through free ones; they are at most what is not blocked of the cells
/// that are joined to it through cells that are not blocked.
///
/// With play the ball may be shifted in each rotation (rotations/play.hpp). Bones may touch on the way from
/// one shift to another, so that only what is free without a shift counts as surely reached.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "hip/motion.hpp"
#include "rotations/cell_test.hpp"

namespace impinge {

/// When to stop, and what to report.
struct VolumeSettings {
  double width = 0.05;                 // share of all rotations that may stay open, above 0
  std::size_t most_cells = 4'000'000;  // at most so many cells are tested
  std::size_t threads = 2;             // the result is the same for any number
  /// Verdicts of an earlier run with the same joint and question, in the order in which `reached` got them.
  /// They are not computed again.
  std::span<const CellVerdict> known{};
  /// Called after each batch, on the thread that makes the volume, with the verdicts of the batch, which may
  /// be kept for `known`, and the share that is open now.
  std::function<void(std::span<const CellVerdict>, double)> reached{};
};

/// Shares of all rotations; the first four sum to 1.
struct VolumeShares {
  double free = 0.0;            // nothing touches in any rotation of these cells and parts
  double blocked = 0.0;         // something touches in every rotation of these
  double unknown = 0.0;         // nothing touches, but the ball's mesh ends under the socket
  double open = 0.0;            // the rest
  double reachable_low = 0.0;   // free and joined to the neutral pose
  double reachable_high = 0.0;  // perhaps joined to the neutral pose
  std::size_t cells = 0;        // how many cells were tested

  double low() const { return free * (1.0 - kShareError); }  // proven ends of the free share
  double high() const { return 1.0 - blocked * (1.0 - kShareError); }
  /// Proven ends of the share that can be reached from the neutral pose.
  double reached() const { return reachable_low * (1.0 - kShareError); }
  double within_reach() const { return std::min(high(), reachable_high * (1.0 + kShareError)); }
};

/// One of the cells that make up all rotations.
struct VolumeCell {
  RotationCell cell;
  CellState state = CellState::open;
  bool reachable = false;          // certainly: free and joined to the neutral pose
  bool within_reach = false;       // perhaps: joined to it through cells that are not blocked
  CellHint hint;                   // where surfaces may touch, if open or blocked
  const CellPart* part = nullptr;  // its parts, if some are free or blocked; borrowed from the volume
  std::optional<Vec3> shift;       // mm, a shift of the ball with which the cell is free; only with play
};

/// The limit of a turn, degrees from its start: every rotation up to low is free, the one at high is blocked.
struct VolumeLimit {
  double low_deg = 0.0;
  std::optional<double> high_deg;   // none if no cell on the way is blocked
  std::optional<VolumeCell> stops;  // a cell at low that is not free; none if all of the way is free
};

class MotionVolume {
 public:
  /// Computes the volume: 50 to 100 us of a core for a cell, with surfaces of 12,000 faces; with play some
  /// times that. Throws std::invalid_argument for a width that is not above 0.
  MotionVolume(const CellTest& test, const VolumeSettings& settings);

  const VolumeShares& shares() const { return shares_; }
  /// Calls visit for each cell, cube by cube in the order of their numbers.
  void for_each(const std::function<void(const VolumeCell&)>& visit) const;
  /// The cell that holds a rotation, one of them if it is on a border. If the rotation is in a free or
  /// blocked part of the cell, the state is that of the part.
  VolumeCell at(const Quaternion4& q) const;
  /// The limit of a motion, read off the cells in closed form: a turn is a straight line in a cube. Throws
  /// std::invalid_argument unless largest_deg is in (0, 180].
  VolumeLimit limit(const JointTurn& turn, double largest_deg) const;

 private:
  struct Node {
    std::uint32_t first = 0;  // index of the first of eight children; 0 for none
    CellState state = CellState::open;
    std::uint8_t reach = 0;  // bits: joined to the neutral pose certainly, perhaps
    std::uint32_t part = 0;  // index in parts_; 0 for none
  };
  struct Open {
    RotationCell cell;
    std::uint32_t node;
    double share;
  };
  class Refinement;
  template <class Visit>
  void visit_leaves(const RotationCell& cell, std::uint32_t node, const Visit& visit) const;
  std::uint32_t find(const RotationCell& cell) const;
  VolumeCell leaf(const RotationCell& cell, std::uint32_t node) const;
  bool is_free(const RotationCell& cell, std::uint32_t node, const Quaternion4& q) const;
  bool meet(const RotationCell& cell, std::uint32_t node, std::size_t side) const;
  void join(std::uint8_t bit);
  void sum();

  std::vector<Node> nodes_;      // the four cubes first
  std::vector<CellHint> hints_;  // of each node
  std::vector<CellPart> parts_;  // of open leaves; the first is empty
  double play_mm_;
  VolumeShares shares_;
};

}  // namespace impinge
