// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Anatomical frames from points that a person has marked, after Wu et al. 2002 (ISB recommendation,
/// doi:10.1016/S0021-9290(01)00222-6), written in our order of axes (x right, y anterior, z superior; theirs
/// are z, x and y).
///
/// Pelvis: right along the line from the left to the right ASIS. Theirs is level with the midpoint of the
/// PSIS, which a scan of a hip rarely shows; ours stands with the anterior pelvic plane, of both ASIS and the
/// middle of the pubic tubercles (Lewinnek et al. 1978), upright. The pelvic tilt between that plane and the
/// frame of the scan is reported, since no landmark says how the patient stands. Femur: superior from the
/// middle of the epicondyles to the centre of rotation; right in the plane of these three.
#pragma once

#include <optional>

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
};

/// Rotations from the frame of the meshes to anatomical ones: rows are right, anterior and superior.
struct AnatomicalFrames {
  Eigen::Matrix3d pelvis = Eigen::Matrix3d::Identity();
  std::optional<Eigen::Matrix3d> femur;  // none without epicondyles
  double pelvic_tilt_deg = 0.0;   // of the plane from upright in the scan; forward (ASIS leading) is positive
  std::optional<Motion> scanned;  // angles of the femur in the scan, degrees; none without epicondyles
};

/// `axes` is where the meshes' axes point (hip/anatomy.hpp), the centre that of rotation, frame of the
/// meshes. std::invalid_argument, one line, where a point of the pelvis is missing, one epicondyle is given
/// alone, points are too close together, or left and right, above and below, or medial and lateral contradict
/// the axes and the side.
AnatomicalFrames anatomical_frames(const Landmarks& landmarks, const Vec3& centre, std::optional<Side> side,
                                   const Eigen::Matrix3d& axes);

/// The motion whose joint_rotation() is this one; flexion and rotation of a femur that is abducted by 90
/// degrees are not told apart.
Motion motion_of_rotation(const Eigen::Matrix3d& rotation, Side side);

}  // namespace impinge
