// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume of a session's joint (motion/volume.hpp), in the joint frame about the centre of the
// ball.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/named_motion.hpp"
#include "motion/volume.hpp"
#include "session/session.hpp"

namespace impinge {

/// Some gigabytes of memory: at about that many cells a program says what it has.
inline constexpr std::size_t kMostVolumeCells = 20'000'000;

/// What is asked, and how finely.
struct VolumeRequest {
  CellQuestion question;    // of contact, a gap, a doubtful centre
  VolumeSettings settings;  // when to stop
};

/// The test of its cells, with the bone beside the main surfaces. `socket` is the mesh to ask about: where it
/// is seen from, or where it was before the ball was shifted.
CellTest cell_test(const SessionJoint& joint, const TriangleMesh& socket, const CellQuestion& question = {});

/// What stops a motion.
struct VolumeStop {
  const NamedMotion* motion;
  VolumeLimit limit;
  std::optional<double> hours = {};  // on the dial, of the socket's face that may be touched first
  std::optional<Vec3> on_ball = {};  // unit direction of the ball's, in the ball's frame at rest, joint axes
  std::string ball_part = {};        // which part of the ball may be touched first; empty: none of them
  std::string socket_part = {};      // the same of the socket
};

struct VolumeAnswer {
  MotionVolume volume;
  std::vector<VolumeStop> stops;  // of all named motions; none without a side
};

/// std::invalid_argument as for CellTest and MotionVolume.
VolumeAnswer answer_volume(const SessionJoint& joint, const VolumeRequest& request);

}  // namespace impinge
