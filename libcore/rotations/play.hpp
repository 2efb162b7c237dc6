// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Which rotations are free if the joint has play? The ball may be shifted by any d with |d| <= r: a point x
/// of it goes to R x + d. Theorem 15 (play).
///
///   free     with one shift nothing touches in any of the rotations
///   blocked  with every shift something touches in every one of them
///
/// To shift the ball by d is to shift the socket by -d. So each shift has a test with its own socket
/// (rotations/cell_test.hpp), and a search of that test with a play of s answers for every shift within s
/// of d. The first search is about no shift, with the play r. The others are about balls of shifts: the
/// cube about all shifts is divided into 27, and each ball holds what one small cube has of them. They are
/// asked once the rotations of a cell move the socket's surface by less than a ball is wide. A cell is free
/// if it is free with the middle of one ball, blocked if it is blocked with all shifts of every ball. A ball
/// that is blocked for a cell is blocked for its eighths.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>

#include "rotations/cell_test.hpp"

namespace impinge {

/// A ball of shifts, in units of r. The middle is no farther than 1 from the origin.
struct ShiftBall {
  Vec3 middle = Vec3::Zero();
  double radius = 1.0;
};
/// Place 0 holds all shifts up to 1 long. So do the other places together.
inline constexpr std::size_t kShiftBalls = 28;
ShiftBall shift_ball(std::size_t place);

/// Tests of a joint, one for the middle of each ball of shifts; each is built when it is first asked for.
/// Several threads may use them at the same time.
class PlayTests {
 public:
  /// No play, only this test. It must outlive this object.
  explicit PlayTests(const CellTest& test) : still_(&test) {}
  explicit PlayTests(const CellTest&&) = delete;
  /// As for CellTest; question.play_mm is r. Throws std::invalid_argument if the socket comes that near to
  /// the origin.
  PlayTests(BallSocketPair joint, const CellQuestion& question, BoneParts beside = {});

  double play_mm() const { return question_.play_mm; }
  /// The test for the shift in the middle of a ball.
  const CellTest& test(std::size_t place) const;
  /// The shift in the middle of a ball, mm.
  Vec3 shift(std::size_t place) const { return play_mm() * shift_ball(place).middle; }

 private:
  struct Made {
    std::once_flag once;
    std::optional<CellTest> test;
  };
  const CellTest* still_ = nullptr;  // the test that was given, if any
  BallSocketPair joint_;
  CellQuestion question_;
  BoneParts beside_;
  std::unique_ptr<std::array<Made, kShiftBalls>> made_;
};

/// Asks the tests about one cell after the other. Each thread has its own.
class PlaySearch {
 public:
  /// The tests must outlive this object.
  explicit PlaySearch(const PlayTests& tests) : tests_(tests) {}
  explicit PlaySearch(const PlayTests&&) = delete;

  /// The state of a cell. Where it is free or unknown, the hint has the place of the shift. `from` is the
  /// hint of the parent cell.
  CellVerdict decide(const RotationCell& cell, const CellHint& from = {});
  /// What is known of parts of a cell whose verdict is open; nothing with play.
  CellPart part_of(const RotationCell& cell, const CellHint& hint);

 private:
  struct Searches {
    CellSearch still;    // answers for the middle of a ball
    CellSearch shifted;  // answers for all of the ball
  };
  Searches& at(std::size_t place);

  const PlayTests& tests_;
  std::array<std::unique_ptr<Searches>, kShiftBalls> made_;
};

}  // namespace impinge
