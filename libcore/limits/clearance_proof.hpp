// SPDX-License-Identifier: GPL-3.0-or-later
// A proof that the bodies of a pose or of a motion do not meet, or that those of a pose do, which can be
// checked with the mesh files and without this library. (joint/certificate.hpp has the exact verdict on a
// pose, without a proof.)
//
// Clear: no surfaces of the two sides meet (limits/clear_cuts.hpp), and at the start nothing is inside a body
// of the other (limits/body_pairs.hpp), nor is that left open. Contact: two faces cross, or surfaces do not
// meet and a point is inside a body without an opening. What only an opening could tell has no proof.
//
// The page experiments/certificate_format.md says what the text means, and experiments/check_certificate.py
// checks it in exact arithmetic. Here all is prepared in doubles with a margin for their rounding: that
// script refuses a false text, and none is written where the margin is missing. Theorem 19 (certificate).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gap/pose.hpp"
#include "hip/motion.hpp"
#include "limits/body_pairs.hpp"
#include "limits/clear_cuts.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// A rotation by the quaternion w, x, y, z of whole numbers.
using IntegerTurn = std::array<std::int64_t, 4>;

/// The nearest of those of length about 2^30: within 2e-9 rad of `rotation`, which is orthogonal with
/// determinant 1.
IntegerTurn integer_turn(const Eigen::Matrix3d& rotation);
/// Its matrix, rounded.
Eigen::Matrix3d rotation_of(const IntegerTurn& turn);

/// R(a) = outer R(axis, a) inner, and what is proven of it.
struct ClearanceProof {
  enum class Says : std::uint8_t {
    clear,     // from the start to `last`, by `cuts`
    crossing,  // `faces` cross in the pose
    inside,    // surfaces do not meet in the pose, and a point is inside a body without an opening
    open,     // nothing: at `open_deg` and about `place` the bodies are too near to tell a gap from a contact
    unknown,  // nothing: surfaces do not meet, and what is inside an opening of a mesh may change
  };
  Says says = Says::open;
  Vec3 centre = Vec3::Zero();  // mm, input frame; to nine decimals
  Vec3 shift = Vec3::Zero();   // of the ball, mm, the same
  IntegerTurn outer{1, 0, 0, 0};
  std::array<int, 3> axis{1, 0, 0};  // a coordinate axis, or against it
  IntegerTurn inner{1, 0, 0, 0};
  HalfAngle last{1, 0};                    // of the turn
  std::vector<ClearCut> cuts;              // where clear
  std::array<std::uint32_t, 2> faces{};    // of ball and socket, where they cross
  Vec3 place = Vec3::Zero();               // where open, mm, about the centre
  double open_deg = 0.0;                   // where open, from the start
  std::array<std::size_t, 2> files{1, 1};  // of ball and socket: the main surface and its parts
  bool closed = false;                     // have none of the bodies an opening?
  double rounded_deg = 0.0;                // by how much the rotations differ from those asked for, at most
};

/// The meshes in the centre frame as they were read, the bodies that they are, and their centre in the input
/// frame, mm. Faces of parts (mesh/mesh_parts.hpp) are more faces of their side.
struct ProofJoint {
  const BallSocketPair& meshes;
  const BodyPairs& bodies;
  Vec3 centre;
};

ClearanceProof prove_pose(const ProofJoint& joint, const Pose& pose);

/// Of the turn from its start to last_deg (above 0, below 360): clear, inside or unknown at its start, or
/// open. The turn's axis is a coordinate axis.
ClearanceProof prove_turn(const ProofJoint& joint, const JointTurn& turn, double last_deg);

/// The text of a proof that is not open.
std::string proof_text(const ClearanceProof& proof);

}  // namespace impinge
