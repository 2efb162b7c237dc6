// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume of a session's joint (rotations/volume.hpp), in the joint frame about the centre of the
// ball.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hip/named_motion.hpp"
#include "joint/session.hpp"
#include "rotations/volume.hpp"

namespace impinge {

/// Most cells that programs allow, which take some gigabytes of memory.
inline constexpr std::size_t kMostVolumeCells = 20'000'000;

/// What is asked, and how finely.
struct VolumeRequest {
  CellQuestion question;    // contact, a gap, or an uncertain centre
  VolumeSettings settings;  // when to stop
};

/// The test for cells of rotations, parts of bone included. `socket` is the socket's mesh with its parts,
/// about the centre of the ball (SessionJoint::seen) or as it was before the ball was shifted.
CellTest cell_test(const SessionJoint& joint, const TriangleMesh& socket, const CellQuestion& question = {});

/// What stops a motion.
struct VolumeStop {
  const NamedMotion* motion;
  VolumeLimit limit;
  std::optional<double> hours = {};  // on the dial, of the socket's face that may be touched first
  std::optional<Vec3> on_ball = {};  // unit direction of the ball's face, in the ball at rest, joint frame
  std::string ball_part = {};        // part of the ball that may be touched first; empty: none
  std::string socket_part = {};      // the same of the socket
};

struct VolumeAnswer {
  MotionVolume volume;
  std::vector<VolumeStop> stops;  // of all named motions; none without a side
};

/// std::invalid_argument as for CellTest and MotionVolume.
VolumeAnswer answer_volume(const SessionJoint& joint, const VolumeRequest& request);

}  // namespace impinge
