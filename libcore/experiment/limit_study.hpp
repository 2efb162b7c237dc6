// SPDX-License-Identifier: GPL-3.0-or-later
// How far joints turn: every named motion, about the centre of the head and about that of the socket, up to
// contact and up to thresholds of the gap; and recorded motions replayed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiment/csv.hpp"
#include "joint/clock.hpp"
#include "joint/recorded_motion.hpp"
#include "limits/named_motion.hpp"
#include "limits/turn_limit.hpp"

namespace impinge {

// Meshes in the joint frame, mm, the centre of the head as origin.
struct StudiedJoint {
  std::string name;
  BallSocketPair meshes;
  std::optional<Side> side;  // without one flexion and extension alone are known
};

// Where the joint turns about.
enum class CentreStrategy {
  head,    // fixed: the centre of the head in the pose of the scan
  socket,  // equidistant: the head is moved to the centre of a sphere fitted to the socket, so that the joint
           // space is even (the static form of Puls et al. 2010)
};

struct LimitCase {
  std::string joint;
  const NamedMotion* motion = nullptr;
  CentreStrategy centre = CentreStrategy::head;
  double shift_mm = 0.0;         // of the head from the pose of the scan
  std::optional<double> gap_mm;  // the threshold; contact without one
  TurnLimit limit;
  std::string clock;                   // of the contact on the socket; empty where there is none
  std::optional<double> smallest_gap;  // of a vertex, mm, at the lower end of the bracket
};

// All motions up to contact, and about the head's centre up to each of these gaps, mm.
std::vector<LimitCase> limits_of(const StudiedJoint& joint, const std::vector<double>& gaps_mm);

// A recorded motion on a joint at equal steps.
struct ReplayedPose {
  const RecordedMotion* motion = nullptr;
  double angle_deg = 0.0;
  std::optional<VertexGap> smallest;
  std::string clock;  // of that vertex
  bool impinged = false;
};
std::vector<ReplayedPose> replay(const StudiedJoint& joint, const RecordedMotion& motion, double step_deg);

// The tables motion_limits, motion_limit_details and motion_replay.
Table limit_table(const std::vector<LimitCase>& cases);
Table limit_detail_table(const std::vector<LimitCase>& cases);
Table replay_table(const std::vector<ReplayedPose>& poses);

// What the error of a centre or a surface is taken to be, mm: residuals of sphere fits to real heads are 0.4
// to 0.7.
inline constexpr double kInputError = 0.5;

}  // namespace impinge
