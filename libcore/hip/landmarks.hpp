// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Anatomical frames from points that a person has marked, after Wu et al. 2002 (ISB recommendation,
/// doi:10.1016/S0021-9290(01)00222-6), written in our order of axes (x right, y anterior, z superior; theirs
/// are z, x and y).
#pragma once

#include <optional>
#include <string>

#include "hip/anatomy.hpp"
#include "hip/motion.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// Marked points, frame of the meshes, mm.
struct Landmarks {
  std::optional<Vec3> asis_right;
  std::optional<Vec3> asis_left;
  std::optional<Vec3> pubic_tubercle_right;
  std::optional<Vec3> pubic_tubercle_left;
  std::optional<Vec3> epicondyle_medial;  // of the femur
  std::optional<Vec3> epicondyle_lateral;
  std::string others{};  // labels beside them that name no landmark, for messages
};

/// Rotations from the frame of the meshes to anatomical frames: rows are right, anterior and superior.
struct AnatomicalFrames {
  Eigen::Matrix3d pelvis = Eigen::Matrix3d::Identity();
  std::optional<Eigen::Matrix3d> femur;  // none without epicondyles
  double pelvic_tilt_deg =
      0.0;  // of that plane from upright, in the scan; forward (ASIS leading) is positive
  std::optional<Motion> scanned;  // angles of the femur in the scan, degrees; none without epicondyles
};

/// The frames from these points. `centre` is the centre of rotation in the frame of the meshes (mm), `axes`
/// the rotation of input_to_joint() (hip/anatomy.hpp). Throws std::invalid_argument, one line, if a point of
/// the pelvis is missing, one epicondyle is given alone or both without a side, points are closer than 20 mm,
/// farther apart than in any human (another unit than mm) or on one line, the knee is farther from the centre
/// than in any human, or left and right, above and below, or medial and lateral contradict the axes, the side
/// or the centre.
///
/// Pelvis: x runs along the line from the left to the right ASIS. Wu et al. level the frame by the midpoint
/// of the PSIS, which a scan of a hip rarely shows. Here the anterior pelvic plane, through both ASIS and the
/// middle of the pubic tubercles (Lewinnek et al. 1978), is upright. The angle between that plane and the
/// frame of the scan is reported as pelvic tilt, since no landmark says how the patient stands. Femur: z runs
/// from the middle of the epicondyles to the centre of rotation; x lies in the plane of these three points.
AnatomicalFrames anatomical_frames(const Landmarks& landmarks, const Vec3& centre, std::optional<Side> side,
                                   const Eigen::Matrix3d& axes);

/// The motion whose joint_rotation() is `rotation`. At 90 degrees of abduction, flexion and rotation cannot
/// be told apart.
Motion motion_of_rotation(const Eigen::Matrix3d& rotation, Side side);

}  // namespace impinge
