// SPDX-License-Identifier: GPL-3.0-or-later
// Space, and a motion with it, divided until no part has faces of both bodies: a proof that they do not meet.
//
// The proof is a tree of cuts. Each node has faces of the ball, faces of the socket and an arc of the motion,
// and says that no two of them meet in it; the root has all. A cut makes two nodes of one, so that a pair of
// faces that meet would be in one of both: the point where they meet lies on one side of a plane or of a
// sphere, and its angle in one part of the arc. Where one body has no face left nothing is to be proven.
// There is such a tree if no two faces meet: a plane between two of them leaves each in one part alone.
//
// While the ball turns by an arc of 2 delta < 180 degrees a point of it stays in the triangle of its two ends
// and of the place where their tangents meet, 1 / cos(delta) as far from the axis as they are. So a face is
// on one side of a plane during all of the arc if its three corners are at these three places: a plane needs
// no bound on a movement. A sphere about the centre sees the ball at rest. All of a face with corners a, b, c
// is at least as far from the centre as the root of min(a.a, b.b, c.c) - L^2 / 3 with L its longest side,
// since |sum w_k x_k|^2 = sum w_k |x_k|^2 - sum_{j<k} w_j w_k |x_j - x_k|^2, and the last weights add up to
// 1/3 at most. Theorem 19 (certificate).
//
// What is computed in doubles has to hold for slightly different numbers: those of the files, before reading
// rounded them. Each face counts for both sides where it is nearer to a plane or a sphere than that.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr std::int64_t kCutUnit = 1 << 10;  // distances of cuts are whole numbers of 1 / kCutUnit mm

/// The cosine and sine of half an angle from 0 to below 360 degrees, times any whole number above 0.
using HalfAngle = std::array<std::int64_t, 2>;
HalfAngle half_angle(double degrees);  // the nearest of length about 2^30
double degrees_of(const HalfAngle& half);

/// A node of the tree; its first part follows it in the list, and then its second part.
struct ClearCut {
  enum class Kind : std::uint8_t {
    none,    // one body has no face here
    plane,   // along . x <= at / kCutUnit, and >= ; the socket's frame, about the centre
    sphere,  // |x| <= at / kCutUnit, and >=
    turn,    // the arc up to the half angle (along[0], along[1]), and from it
  };
  Kind kind = Kind::none;
  std::array<std::int64_t, 3> along{};
  std::int64_t at = 0;
};

/// A surface about the centre, mm.
struct UncertainMesh {
  TriangleMesh mesh;
  double off_mm = 0.0;  // no point is farther than this from the true one
};

/// Poses x -> outer R(axis, a) inner x + shift of the ball, a from 0 to `last`.
struct CutMotion {
  Eigen::Matrix3d outer = Eigen::Matrix3d::Identity();
  Vec3 axis = Vec3::UnitX();
  Eigen::Matrix3d inner = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();  // mm
  HalfAngle last{1, 0};       // of a pose: 0
};

/// The tree, or why there is none: no cuts then.
struct CutAnswer {
  std::vector<ClearCut> cuts;
  /// In a pose: a face of the ball and one of the socket that cross, beyond doubt.
  std::optional<std::array<std::uint32_t, 2>> crossing;
  /// Else: where, and at which angle, the surfaces are too near to each other to be told apart.
  struct Open {
    Vec3 place;      // mm, socket's frame, about the centre
    double degrees;  // from the start
  };
  std::optional<Open> open;
};

/// Divides until every node is proven, a crossing is found (of a pose alone) or the finest nodes are reached.
CutAnswer clear_cuts(const UncertainMesh& ball, const UncertainMesh& socket, const CutMotion& motion);

}  // namespace impinge
