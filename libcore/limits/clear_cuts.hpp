// SPDX-License-Identifier: GPL-3.0-or-later
// A proof that two surfaces do not meet in a pose or in a turn: space, and the arc of the turn, are divided
// until no node has faces of both. Theorem 19 (certificate).
//
// The proof is a tree of cuts. Each node has faces of the ball, faces of the socket and an arc, and says that
// no two of these faces meet in it; the root has all. A cut by a plane, a sphere about the centre, or an
// angle of the arc makes two nodes of one. Where one body has no face left nothing remains to be proven.
//
// The proof has to hold for the numbers of the files, which reading rounded: a face that is nearer to a plane
// or a sphere than this rounding counts on both sides.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr std::int64_t kCutUnit = 1 << 10;  // distances of cuts are whole numbers of 1 / kCutUnit mm

/// The cosine and the sine of half an angle from 0 to below 360 degrees, scaled to whole numbers.
using HalfAngle = std::array<std::int64_t, 2>;
HalfAngle half_angle(double degrees);      // the nearest one of length about 2^30
double degrees_of(const HalfAngle& half);  // the whole angle

/// A node of the tree. In the list its first child follows with all of that child's tree, then its second
/// child.
struct ClearCut {
  enum class Kind : std::uint8_t {
    none,    // no cut: one body has no face here
    plane,   // first child: along . x <= at / kCutUnit, second: >= ; mm, socket's frame about the centre
    sphere,  // first child: |x| <= at / kCutUnit, second: >=
    turn,    // first child: the arc up to the half angle (along[0], along[1]), second: from there on
  };
  Kind kind = Kind::none;
  std::array<std::int64_t, 3> along{};
  std::int64_t at = 0;
};

/// A surface about the centre, mm.
struct UncertainMesh {
  TriangleMesh mesh;
  double off_mm = 0.0;  // no vertex is farther than this from its true place
};

/// Poses x -> outer R(axis, a) inner x + shift of the ball, a from 0 to `last`.
struct CutMotion {
  Eigen::Matrix3d outer = Eigen::Matrix3d::Identity();
  Vec3 axis = Vec3::UnitX();
  Eigen::Matrix3d inner = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();  // mm
  HalfAngle last{1, 0};       // the angle 0 for a pose
};

/// The tree; or, where `cuts` is empty, why there is none.
struct CutAnswer {
  std::vector<ClearCut> cuts;
  /// In a pose: indices of a face of the ball and one of the socket that certainly cross.
  std::optional<std::array<std::uint32_t, 2>> crossing;
  /// Else: where, and at which angle, the surfaces are too near to decide whether they meet.
  struct Open {
    Vec3 place;      // mm, socket's frame, about the centre
    double degrees;  // from the start
  };
  std::optional<Open> open;
};

/// Divides until every node is proven, a crossing is found (of a pose only) or a node is too fine to be
/// divided.
CutAnswer clear_cuts(const UncertainMesh& ball, const UncertainMesh& socket, const CutMotion& motion);

}  // namespace impinge
