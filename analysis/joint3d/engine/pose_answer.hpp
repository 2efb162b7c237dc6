// SPDX-License-Identifier: GPL-3.0-or-later
// What the session says of one pose, of a motion, and in files.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gap/gap_histogram.hpp"
#include "gap/gap_summary.hpp"
#include "hip/gap_levels.hpp"
#include "motion/told_limit.hpp"
#include "session.hpp"

namespace impinge {

struct PoseRequest {
  Motion motion;                    // degrees
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 4.0;
};

struct SurfaceAnswer {
  std::vector<double> gap;            // mm, NaN where the other surface is not met
  GapSummary bone;                    // impinged at 0 mm
  GapSummary cartilage;               // impinged at the thickness of the cartilage
  std::vector<ClockZone> bone_zones;  // empty without a dial
  std::vector<ClockZone> cartilage_zones;
  GapHistogram histogram;
};

struct SmallestOfPose {
  Surface surface = Surface::ball;
  std::size_t vertex = 0;
  double gap_mm = 0.0;
  Vec3 place = Vec3::Zero();  // posed, centre frame, mm
  std::optional<double> hours;
};

struct PoseAnswer {
  Pose pose;  // of the ball in the socket, with its shift; gaps are those of its rotation alone, see
              // shift_ball()
  SurfaceAnswer ball;
  SurfaceAnswer socket;
  std::optional<SmallestOfPose> smallest;
  double scan_ms = 0.0;  // both scans
};

Pose pose_of(const SessionJoint& joint, const PoseRequest& request);
PoseAnswer answer_pose(Session& session, const PoseRequest& request);

// Smallest gaps while one angle grows from a start, by the tables, and the limits that no step can jump over,
// about the meshes themselves (motion/told_limit.hpp).
struct SweepRequest {
  Motion start;
  std::string growing;  // of motion_names()
  double largest_deg = 150.0;
  double step_deg = 1.0;
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 4.0;
};
struct SweepLimit {
  const char* about;  // "ball" or "socket": whose centre
  ToldLimit told;
  std::optional<double> hours;  // where they touch
};
struct SweepAnswer {
  std::vector<double> angles;    // of the growth, degrees
  std::vector<double> smallest;  // mm, NaN where the surfaces do not meet
  // Contact about the centre of the ball; about that of the socket, where a sphere fits it and the ball is
  // not shifted; and of the cartilage, about the centre of the ball.
  std::vector<SweepLimit> limits;
};
SweepAnswer answer_sweep(Session& session, const SweepRequest& request);

// The files of the program `scene`, byte for byte: gaps.csv of both surfaces; ball.ply or socket.ply.
std::string gaps_csv(Session& session, const PoseRequest& request);
std::string surface_ply(Session& session, const PoseRequest& request, Surface surface);

}  // namespace impinge
