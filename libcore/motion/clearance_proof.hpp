// SPDX-License-Identifier: GPL-3.0-or-later
// A proof that a pose or a motion is clear, or that a pose is not, which can be checked with the mesh files
// and without this library. (session/certificate.hpp has the exact verdict on a pose, without a proof.)
//
// The page experiments/certificate_format.md says what the text means, and experiments/check_certificate.py
// checks it in exact arithmetic. Here all is prepared in doubles with a margin for their rounding: that
// script refuses a false text, and none is written where the margin is missing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gap/pose.hpp"
#include "gap/surface.hpp"
#include "hip/motion.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "motion/clear_leaves.hpp"

namespace impinge {

/// A rotation by the quaternion w, x, y, z of whole numbers.
using IntegerTurn = std::array<std::int64_t, 4>;

/// The nearest of those of length about 2^20: within 2e-6 rad of `rotation`, which is orthogonal with
/// determinant 1.
IntegerTurn integer_turn(const Eigen::Matrix3d& rotation);
/// Its matrix, rounded.
Eigen::Matrix3d rotation_of(const IntegerTurn& turn);

/// The cosine and sine of half an angle, times any whole number.
using HalfAngle = std::array<std::int64_t, 2>;

/// A stretch of the motion, and the leaves that hold for all of it.
struct ProofCell {
  Surface about = Surface::socket;  // whose centre the leaves are about
  HalfAngle from{1, 0};
  HalfAngle to{1, 0};
  HalfAngle at{1, 0};      // between
  std::int64_t slack = 0;  // in 2^-30: no point moves by more than this share of its distance from `at`
  std::vector<ClearLeaf> leaves;
};

/// R(a) = outer R(axis, a) inner, and what is proven of it.
struct ClearanceProof {
  Vec3 centre = Vec3::Zero();  // mm, input frame; to nine decimals
  Vec3 shift = Vec3::Zero();   // of the ball, mm, the same
  IntegerTurn outer{1, 0, 0, 0};
  std::array<int, 3> axis{1, 0, 0};  // a coordinate axis, or against it
  IntegerTurn inner{1, 0, 0, 0};
  std::vector<ProofCell> cells;                    // of a clear pose or motion
  std::optional<std::array<std::int64_t, 3>> ray;  // of a blocked pose
  Surface ray_from = Surface::socket;              // whose centre the ray is from
  std::optional<Vec3> open;  // neither is proven: in this direction from the centre surfaces are too near
  std::array<std::size_t, 2> bodies{1, 1};  // files of ball and socket: the main surface and its parts
  double rounded_deg = 0.0;                 // by how much the rotations differ from those asked for, at most

  std::size_t leaves() const;
  double end_deg() const;  // of the motion, from its start
};

/// The meshes in the centre frame as they were read, and their centre in the input frame, mm. Faces of parts
/// (mesh/mesh_parts.hpp) are more faces of their side: a proof that they are clear is one for each pair.
struct ProofJoint {
  const BallSocketPair& meshes;
  Vec3 centre;
};

/// Of a pose. Clear: cells about the socket's centre and, where the pose has a shift, about the ball's.
/// Blocked: a ray. Neither proven: `open`.
ClearanceProof prove_pose(const ProofJoint& joint, const Pose& pose);

/// Of the turn from its start to last_deg (above 0, at most 360): cells one after the other. If they end
/// earlier (end_deg()), `open` says why. The turn's axis is a coordinate axis.
ClearanceProof prove_turn(const ProofJoint& joint, const JointTurn& turn, double last_deg);

/// The text of a proof that is not open.
std::string proof_text(const ClearanceProof& proof);

}  // namespace impinge
