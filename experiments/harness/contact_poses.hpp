// SPDX-License-Identifier: GPL-3.0-or-later
// Poses in which it is hard to say whether a joint is impinged, and easy ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gap/overlay.hpp"

namespace impinge::lab {

// A path from one pose to another. At share s in [0, 1] the ball is turned about the axis by from_turn + s
// (to_turn - from_turn) and moved by s * shift.
struct PosePath {
  Vec3 axis = Vec3::UnitZ();  // unit vector through the centre
  double from_turn = 0.0;     // radians, at share 0
  double to_turn = 0.0;       // at share 1
  Vec3 shift = Vec3::Zero();  // mm, at share 1

  Pose at(double share) const;  // the pose at that share
};

// Distance from the centre, mm, at which turns are converted to lengths.
inline constexpr double kArm = 25.0;
double path_length(const PosePath& path);  // mm: the shift plus the arc of a point kArm away

// The first share of the path at which the pose is impinged, to within 2^-24, by bisection; none if the end
// is free or the beginning impinged. If `impinged` changes more than once on the path, one of the changes is
// found.
std::optional<double> first_contact(const PosePath& path, const std::function<bool(const Pose&)>& impinged);

// The number of poses, and how far they are from the given pose.
struct ContactOptions {
  std::size_t count = 1000;  // of poses
  double turn = 1.0;         // radians: the largest turn, about any axis
  double shift = 12.0;       // mm, the longest shift
  std::uint64_t seed = 0;    // of paths and places on them
};

// Poses per random path. A path turns the ball by up to `turn` and then moves it in any direction; if the
// turned ball is already impinged, the turn is the path. Of four poses one lies anywhere on its path, and
// three are close to its first contact, on either side, by 10^-5 to 10^-0.5 mm of path_length().
inline constexpr std::size_t kPosesPerPath = 8;
// A pose, and its path.
struct ContactPose {
  PosePath path;                  // the pose is on it
  std::optional<double> contact;  // share of the path at first contact
  Pose pose;                      // of the ball in the socket
};
// These poses, in the order of their paths.
std::vector<ContactPose> contact_poses(const SurfaceOverlay& joint, const ContactOptions& options);

// Is some vertex of either surface impinged in the pose? Exact.
bool vertices_impinged(const SurfaceOverlay& joint, const Pose& pose);

}  // namespace impinge::lab
