// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A joint with play: the ball may be shifted by any d with |d| <= r, x to R x + d. Rotations are free if
/// with one such shift none of them has a contact, blocked if with each of them all have. Theorem 15 (play).
///
/// A shift by d is the same as the socket shifted by -d, so that a test of cells with that socket
/// (rotations/cell_test.hpp) tells of the shift, and with a doubt of s of all shifts within s of d. Asked are
/// no shift, with the doubt r, and the 27 cubes of a third of the way along each axis: what of a cube is
/// within r of the origin lies in the box that is left of it between the planes where the ball ends, and that
/// in a ball about the box's middle, which is moved to within r if it is not. Once rotations move the
/// socket's surface by less than a cube is wide, cubes are asked. A cell is free if it is at the middle of
/// one, blocked if it is for all. What is blocked for a cube is so for the eighths of the cell as well.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>

#include "rotations/cell_test.hpp"

namespace impinge {

/// A ball of shifts, as a share of r: the middle is at most 1 from the origin.
struct ShiftBall {
  Vec3 middle = Vec3::Zero();
  double radius = 1.0;
};
/// Place 0 is all of them; the others together hold all that are at most 1 long.
inline constexpr std::size_t kShiftBalls = 28;
ShiftBall shift_ball(std::size_t place);

/// Tests of a joint, one for the middle of each ball of shifts that was asked. Several threads may use it at
/// the same time.
class PlayTests {
 public:
  /// Without play, whatever searches may ask of the test, which must outlive this.
  explicit PlayTests(const CellTest& test) : still_(&test) {}
  explicit PlayTests(const CellTest&&) = delete;
  /// As for CellTest; question.play_mm is r. std::invalid_argument if the socket comes as near to the origin.
  PlayTests(BallSocketPair joint, const CellQuestion& question, BoneParts beside = {});

  double play_mm() const { return question_.play_mm; }
  /// For the shift in the middle of a ball; made when it is first asked for.
  const CellTest& test(std::size_t place) const;
  /// mm, the shift there.
  Vec3 shift(std::size_t place) const { return play_mm() * shift_ball(place).middle; }

 private:
  struct Made {
    std::once_flag once;
    std::optional<CellTest> test;
  };
  const CellTest* still_ = nullptr;  // given
  BallSocketPair joint_;
  CellQuestion question_;
  BoneParts beside_;
  std::unique_ptr<std::array<Made, kShiftBalls>> made_;
};

/// Asks them, one cell at a time; each thread has its own.
class PlaySearch {
 public:
  /// The tests must outlive this.
  explicit PlaySearch(const PlayTests& tests) : tests_(tests) {}
  explicit PlaySearch(const PlayTests&&) = delete;

  /// The state of a cell; where it is free or unknown, the hint has the place of the shift. `from` is the
  /// hint of the cell that this one is an eighth of.
  CellVerdict decide(const RotationCell& cell, const CellHint& from = {});
  /// What is known of its parts; nothing with play.
  CellPart part_of(const RotationCell& cell, const CellHint& hint);

 private:
  struct Searches {
    CellSearch still;    // for the middle of a ball
    CellSearch shifted;  // for all of it
  };
  Searches& at(std::size_t place);

  const PlayTests& tests_;
  std::array<std::unique_ptr<Searches>, kShiftBalls> made_;
};

}  // namespace impinge
