// SPDX-License-Identifier: GPL-3.0-or-later
// One joint in many poses: touch and the smallest gap of each, without asking most vertices and faces.
#pragma once

#include <optional>

#include "contact/culled_overlay.hpp"
#include "gap/pose.hpp"
#include "hip/joint.hpp"

namespace impinge {

/// What is worked out of each pose.
struct SeriesOutputs {
  bool touch = true;
  bool smallest_gap = true;
};

/// The smallest radial gap of a pose and its vertex.
struct SeriesGap {
  LeastGap least;
  double bound_mm = 0.0;      // proven, of the error of that vertex's gap; infinite where nothing is
  Vec3 place = Vec3::Zero();  // of the vertex, posed, centre frame of the socket, mm
};

struct SeriesAnswer {
  /// Do the surfaces impinge, edges and all (gap/overlay.hpp)? Exact. None if not asked for.
  std::optional<bool> touch;
  std::optional<SeriesGap> smallest;  // none also where the surfaces do not face each other
};

class PoseSeries {
 public:
  /// std::invalid_argument for lengths that CulledScan refuses.
  PoseSeries(const Joint& joint, const SeriesOutputs& outputs);

  SeriesAnswer answer(const Pose& pose) const;

 private:
  SeriesOutputs outputs_;
  BallSocketPair meshes_;
  CulledJoint joint_;
  std::optional<CulledOverlay> overlay_;  // if touch is asked for
};

/// The pose of the ball in the centre frame whose matrix is x' = motion x in the frame of the input, in which
/// the centre is.
Pose pose_about(const Vec3& centre, const Eigen::Matrix3d& rotation, const Vec3& translation);

}  // namespace impinge
