// SPDX-License-Identifier: GPL-3.0-or-later
// The volume of all rotations of a session's joint (rotations/volume.hpp), in the joint frame, about the
// centre of the ball, which is not shifted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "joint/session.hpp"
#include "rotations/volume.hpp"

namespace impinge {

struct VolumeRequest {
  double width = 0.05;
  double gap_mm = 0.0;
  double centre_within_mm = 0.0;
  double play_mm = 0.0;

  static constexpr const char* kThresholdOption = "--gap";
  double threshold_mm() const { return gap_mm; }

  static constexpr std::tuple fields{
      Field{"width", "1", "share of all rotations that may stay undecided, above 0 and up to 1",
            &VolumeRequest::width, Range{.least = 0.0, .most = 1.0, .above = true}},
      Field{"gap_mm", "mm", "gaps up to this count as contact, e.g. the cartilage's thickness",
            &VolumeRequest::gap_mm, kNotNegative},
      Field{"centre_within_mm", "mm", "the answer holds for every common centre within this distance",
            &VolumeRequest::centre_within_mm, kNotNegative},
      Field{"play_mm", "mm",
            "how far the ball may shift: free if one shift clears the bones, blocked if all let them touch",
            &VolumeRequest::play_mm, kNotNegative}};
};

/// What stops a motion, as far as the cells tell.
struct VolumeMotion {
  std::string_view motion;
  double low_deg = 0.0;
  std::optional<double> high_deg;
  std::optional<std::string> clock;
  std::optional<Vec3> ball_direction;
  std::optional<std::string> ball_part;
  std::optional<std::string> socket_part;

  static constexpr std::tuple fields{
      Field{"motion", "", "its name (hip/named_motion.hpp)", &VolumeMotion::motion},
      Field{"low_deg", "deg", "every rotation from its start to here is free", &VolumeMotion::low_deg},
      Field{"high_deg", "deg", "here one is blocked; null where none is on the way", &VolumeMotion::high_deg},
      Field{"clock", "", "on the dial, of the socket's face that may be touched first", &VolumeMotion::clock},
      Field{"ball_direction", "1",
            "unit vector to the ball's face that may be touched first, at rest: right, anterior, superior",
            &VolumeMotion::ball_direction},
      Field{"ball_part", "", "part of the ball that may be touched first; null: the ball itself",
            &VolumeMotion::ball_part},
      Field{"socket_part", "", "the same of the socket", &VolumeMotion::socket_part}};
};

/// Volume of all rotations as three Euler angles, degrees^3. The middle axis is perpendicular to the two
/// others, and the volume is weighted by the cosine of the middle angle. This makes it the invariant measure:
/// a share of it is the same for all choices of axes (Manafzadeh and Gatesy 2020, doi:10.1242/jeb.227108).
inline constexpr double kAllRotationsDeg3 = 360.0 * 360.0 * 360.0 / kPi;

/// Of answers that rest on cells (rotations/cell_test.hpp), and in words.
inline constexpr const char* kByRadii =
    "does radial overlap block, too, as the socket is a sheet? `limits` may then go further";
inline constexpr std::string_view kBlockedByRadii =
    "blocked             by radii, too: where the ball reaches beyond the socket, which is a sheet, "
    "though no surfaces meet; limits may go further";

struct VolumeAnswer {
  std::vector<VolumeMotion> motions;
  bool by_radii = false;
  MotionVolume volume;

  const VolumeShares& shares() const { return volume.shares(); }
  double mobility_low_deg3() const { return shares().low() * kAllRotationsDeg3; }
  double mobility_high_deg3() const { return shares().high() * kAllRotationsDeg3; }
  bool neutral_blocked() const { return shares().reachable_high == 0.0; }

  static constexpr std::tuple fields{
      Field{"share_low", "1", "of all rotations that is free, at least",
            via(&VolumeAnswer::shares, &VolumeShares::low)},
      Field{"share_high", "1", "at most", via(&VolumeAnswer::shares, &VolumeShares::high)},
      Field{
          "mobility_low_deg3", "deg^3",
          "volume that is free in Euler angles, weighted by the cosine of the middle one, whatever the axes "
          "(Manafzadeh and Gatesy 2020); of 14,851,066 in all, at least",
          &VolumeAnswer::mobility_low_deg3},
      Field{"mobility_high_deg3", "deg^3", "at most", &VolumeAnswer::mobility_high_deg3},
      Field{"reachable_low", "1",
            "share that is reached without contact from where all angles are 0, at least",
            via(&VolumeAnswer::shares, &VolumeShares::reached)},
      Field{"reachable_high", "1", "at most", via(&VolumeAnswer::shares, &VolumeShares::within_reach)},
      Field{"neutral_blocked", "", "does contact block the pose in which all angles are 0?",
            &VolumeAnswer::neutral_blocked},
      Field{"by_radii", "", kByRadii, &VolumeAnswer::by_radii},
      Field{"unknown", "1", "share of which nothing is known: the ball's mesh ends there",
            via(&VolumeAnswer::shares, &VolumeShares::unknown)},
      Field{"open", "1", "share that is undecided", via(&VolumeAnswer::shares, &VolumeShares::open)},
      Field{"cells_asked", "1", "cells of rotations that were decided",
            via(&VolumeAnswer::shares, &VolumeShares::cells)},
      Field{"motions", "", "each named motion; none without a side", &VolumeAnswer::motions}};
};

/// A cell, as a row of volume.csv.
struct VolumeRow {
  std::uint32_t level = 0;
  std::uint64_t cell = 0;
  double w = 0.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double radius_deg = 0.0;
  double share = 0.0;
  double free = 0.0;
  double blocked = 0.0;
  std::string_view state;
  std::optional<bool> reachable;

  static constexpr std::tuple fields{
      Field{"level", "1", "how often a cube was halved (rotations/rotation_cells.hpp)", &VolumeRow::level},
      Field{"cell", "1", "its number among the cells of that level", &VolumeRow::cell},
      Field{"w", "1", "of the quaternion of its middle, the largest coordinate 1: a rotation of the ball",
            &VolumeRow::w},
      Field{"x", "1", "likewise, about the axis to the right", &VolumeRow::x},
      Field{"y", "1", "anterior", &VolumeRow::y},
      Field{"z", "1", "superior", &VolumeRow::z},
      Field{"radius_deg", "deg", "no rotation of the cell is farther from its middle",
            &VolumeRow::radius_deg},
      Field{"share", "1", "of all rotations", &VolumeRow::share},
      Field{"free", "1", "of all rotations, that is free: all of the cell, or part of one that is open",
            &VolumeRow::free},
      Field{"blocked", "1", "the same, that is blocked", &VolumeRow::blocked},
      Field{"state", "", "free, blocked, unknown, or open: undecided", &VolumeRow::state},
      Field{"reachable", "", "without contact from where all angles are 0; empty where it is not known",
            &VolumeRow::reachable}};
};
VolumeRow volume_row(const VolumeCell& at);

/// Columns that a row has besides with play: the shift of the ball with which a cell is free.
struct ShiftRow {
  std::optional<double> shift_x_mm;
  std::optional<double> shift_y_mm;
  std::optional<double> shift_z_mm;

  static constexpr std::tuple fields{
      Field{"shift_x_mm", "mm", "of the ball to the right, with which all of a free cell is",
            &ShiftRow::shift_x_mm},
      Field{"shift_y_mm", "mm", "anterior", &ShiftRow::shift_y_mm},
      Field{"shift_z_mm", "mm", "superior", &ShiftRow::shift_z_mm}};
};
ShiftRow shift_row(const VolumeCell& at);

/// The most cells that programs allow; they take some gigabytes of memory.
inline constexpr std::size_t kMostVolumeCells = 20'000'000;

/// The most with play, where a cell takes several times as long.
inline constexpr std::size_t kMostPlayCells = 400'000;

/// The width in `how` is replaced by the request's; with play its cells are bounded by kMostPlayCells. Throws
/// as CellTest and MotionVolume do.
VolumeAnswer answer(Session& session, const VolumeRequest& request,
                    VolumeSettings how = {.most_cells = kMostVolumeCells});

/// The test for cells of rotations, with parts of bone. `socket` is the socket's mesh with its parts, about
/// the centre of the ball: SessionJoint::seen, or as it was before the ball was shifted.
CellTest cell_test(const SessionJoint& joint, const TriangleMesh& socket, const CellQuestion& question = {});

}  // namespace impinge
