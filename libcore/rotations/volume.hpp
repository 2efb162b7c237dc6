// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The motion volume of a joint: all its rotations at once, as cells that are free, blocked or still open
/// (rotations/cell_test.hpp), refined until the open ones are a small enough share of all rotations.
///
/// Of the cells that are open the one with the largest share is split first, those of a quarter octave of
/// shares together and in the order in which they were found: the result depends on the joint and the
/// settings alone, not on time or the number of threads.
///
/// An open cell may be free and blocked in parts (rotations/cell_part.hpp): then only the rest of it is open,
/// a slab about the border that is as thin as the square of the cell.
///
/// The free rotations are an open set, so that a way through them can be moved off the edges and corners of
/// cells: it goes from cell to cell across common sides. Those that can be reached from the neutral pose
/// without contact are at least the free cells, and parts, that are joined to it so through free ones, and at
/// most what is not blocked of cells that are joined through cells that are not blocked. Two parts are joined
/// where a rotation on the side between their cells is in both. Theorem 14 (volume). With play the ball may
/// be shifted in each of these rotations (rotations/play.hpp). Between two shifts there may be contact: of
/// the cells that are free, those with the ball in its place are reached at least.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "hip/motion.hpp"
#include "rotations/cell_test.hpp"
#include "rotations/play.hpp"

namespace impinge {

/// When to stop, and who is told.
struct VolumeSettings {
  double width = 0.05;                 // share of all rotations that may stay open, above 0
  std::size_t most_cells = 4'000'000;  // no more cells are tested
  std::size_t threads = 2;             // the result is the same for any number
  /// Verdicts of an earlier run with the same joint and question, in the order in which they were reached:
  /// these are not worked out again.
  std::span<const CellVerdict> known{};
  /// Called after each batch, on the thread that made the volume: the verdicts of the batch, to be kept for
  /// `known`, and the share that is open now.
  std::function<void(std::span<const CellVerdict>, double)> reached{};
};

/// Shares of all rotations; the first four sum to 1.
struct VolumeShares {
  double free = 0.0;            // in every rotation of these cells and parts nothing touches
  double blocked = 0.0;         // in every one something does
  double unknown = 0.0;         // nothing touches, but the ball's mesh ends under the socket
  double open = 0.0;            // the rest
  double reachable_low = 0.0;   // free and joined to the neutral pose
  double reachable_high = 0.0;  // the most that may be
  std::size_t cells = 0;        // that were decided

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
  bool within_reach = false;       // perhaps: joined to it by cells that are not blocked
  CellHint hint;                   // of an open or blocked cell: where surfaces may touch
  const CellPart* part = nullptr;  // of one that is free or blocked in parts; borrowed from the volume
  std::optional<Vec3> shift;       // mm, of the ball, with which it is free; none without play
};

/// Angles of a turn, degrees from its start: every rotation up to low is free, at high one is blocked.
struct VolumeLimit {
  double low_deg = 0.0;
  std::optional<double> high_deg;   // none where no cell on the way is blocked
  std::optional<VolumeCell> stops;  // a cell at low that is not free; none where all of the way is
};

class MotionVolume {
 public:
  /// Refines at once, about 17 us of a core a cell for surfaces of 12,000 faces. std::invalid_argument for a
  /// width that is not above 0.
  MotionVolume(const CellTest& test, const VolumeSettings& settings)
      : MotionVolume(PlayTests(test), settings) {}
  MotionVolume(const PlayTests& tests, const VolumeSettings& settings);

  const VolumeShares& shares() const { return shares_; }
  /// Calls visit for each cell, cube by cube in the order of their numbers.
  void for_each(const std::function<void(const VolumeCell&)>& visit) const;
  /// The cell that holds a rotation, one of them on a border; where it is free or blocked in parts, with
  /// what is known of that rotation.
  VolumeCell at(const Quaternion4& q) const;
  /// The limit of a motion, read off the cells. A turn is a great circle of quaternions, which central
  /// projection shows as straight lines: which angles are within a cell has a closed form. largest_deg in
  /// (0, 180], else std::invalid_argument.
  VolumeLimit limit(const JointTurn& turn, double largest_deg) const;

 private:
  struct Node {
    std::uint32_t first = 0;  // of eight children; 0 for none
    CellState state = CellState::open;
    std::uint8_t reach = 0;  // bits: certainly, perhaps
    std::uint32_t part = 0;  // place in parts_; 0 for none
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
  std::vector<CellHint> hints_;  // of each
  std::vector<CellPart> parts_;  // of open leaves; the first is none
  double play_mm_;
  VolumeShares shares_;
};

}  // namespace impinge
