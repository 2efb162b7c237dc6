// SPDX-License-Identifier: GPL-3.0-or-later
// A proof that the bodies of a pose or of a turn do not meet, or that the bodies of a pose do. It can be
// checked with the mesh files and without this library. (joint/certificate.hpp gives the exact verdict on a
// pose without a proof.) Theorem 19 (certificate).
//
// Clear means: no surfaces of the two sides meet (limits/clear_cuts.hpp), and at the start no point of one
// body is inside another (limits/body_pairs.hpp). Contact means: two faces cross, or no surfaces meet and a
// point is inside a body without an opening. Where only an opening of a mesh could decide there is no proof.
//
// experiments/certificate_format.md says what the text means, and experiments/check_certificate.py checks it
// in exact arithmetic. Proofs are made in doubles with a margin for rounding; where the margin is missing
// none is written.
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

/// The nearest one of length about 2^30, within 2e-9 rad of `rotation`, an orthogonal matrix of
/// determinant 1.
IntegerTurn integer_turn(const Eigen::Matrix3d& rotation);
/// The matrix of a quaternion, rounded to doubles.
Eigen::Matrix3d rotation_of(const IntegerTurn& turn);

/// R(a) = outer R(axis, a) inner, and what is proven of it.
struct ClearanceProof {
  enum class Says : std::uint8_t {
    clear,     // from the start to `last`, by `cuts`
    crossing,  // `faces` cross in the pose
    inside,    // surfaces do not meet in the pose, and a point is inside a body without an opening
    open,      // no proof: at `open_deg`, about `place`, bodies are too near to tell a gap from a contact
    unknown,   // no proof: surfaces do not meet, but an opening of a mesh may change what is inside
  };
  Says says = Says::open;
  Vec3 centre = Vec3::Zero();  // mm, input frame; rounded to nine decimals
  Vec3 shift = Vec3::Zero();   // shift of the ball, mm; rounded to nine decimals
  IntegerTurn outer{1, 0, 0, 0};
  std::array<int, 3> axis{1, 0, 0};  // a coordinate axis, or against it
  IntegerTurn inner{1, 0, 0, 0};
  HalfAngle last{1, 0};                    // largest angle of the turn
  std::vector<ClearCut> cuts;              // if it says clear: the tree
  std::array<std::uint32_t, 2> faces{};    // if crossing: indices of the ball's and the socket's face
  Vec3 place = Vec3::Zero();               // if open: mm, about the centre
  double open_deg = 0.0;                   // if open: degrees from the start
  std::array<std::size_t, 2> files{1, 1};  // how many files the ball and the socket have, parts included
  bool closed = false;                     // is no body open?
  double rounded_deg = 0.0;                // by how much the rotations differ from those asked for, at most
};

/// What a proof is made from. Meshes have the faces of their parts too (mesh/mesh_parts.hpp).
struct ProofJoint {
  const BallSocketPair& meshes;  // as they were read, about the centre, mm
  const BodyPairs& bodies;       // the bodies of these meshes
  Vec3 centre;                   // input frame, mm
};

/// A proof about one pose.
ClearanceProof prove_pose(const ProofJoint& joint, const Pose& pose);

/// A proof about the turn from its start to last_deg, above 0 and below 360. It says clear, or inside or
/// unknown of the start, or open. The axis of the turn must be a coordinate axis.
ClearanceProof prove_turn(const ProofJoint& joint, const JointTurn& turn, double last_deg);

/// The text of a proof that is neither open nor unknown.
std::string proof_text(const ClearanceProof& proof);

}  // namespace impinge
