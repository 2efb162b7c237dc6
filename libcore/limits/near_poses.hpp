// SPDX-License-Identifier: GPL-3.0-or-later
// All poses near one: how near parts of two bodies come in them, and what stays within a body in all of them.
//
// A rotation within rho of R takes a point that R takes to p into the cap of radius rho about p, at |p| from
// the origin. With t the angle from p to y, its distance from y is at least and at most
//   sqrt(|p|^2 + |y|^2 - 2 |p| |y| cos t'),   t' = max(0, t - rho), min(pi, t + rho),
// and along a unit n it comes to |p| cos max(0, angle(n, p) - rho) at most. A shift adds its length. A sphere
// goes with its centre, so that this holds of all it contains. Where p slides along y as a head in its socket
// does, that is of second order in rho; |p| rho, the way of p, is not. Theorem 14 (volume).
//
// Inner balls: spheres that have nothing but a body inside, such as the largest that touch its surface from
// within. A point of another body that stays in one of them is inside in all of these poses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limits/swept_parts.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {

/// All poses near a rotation of the ball.
struct NearPoses {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double turn = 0.0;      // radians, the largest turn away from it
  double shift_mm = 0.0;  // the largest shift of the ball
  double gap_mm = 0.0;    // a distance as small as that from a part counts as contact
};

/// Points of both bodies, each in its frame, mm: they are in contact where a rotation takes them no farther
/// apart than `reach`.
struct WithinReach {
  Vec3 of_ball;
  Vec3 of_socket;
  double reach;  // mm
};

/// A face of the ball, as it lies at rest, and unit n across which it is on one side of a plane in the
/// rotation that was asked about, and a face y of the socket on the other: n . R x < least <= n . y, less the
/// gap.
struct ClosePair {
  Triangle of_ball;
  Vec3 normal;
  double least;  // mm
};

/// A body: its faces, and inner balls of it (below).
struct BodyTrees {
  const SweptParts& faces;  // borrowed
  const SweptParts& inner;  // borrowed
};

/// Of two bodies: `ball` turns by the rotations, `socket` rests. Trees in their frames, mm.
class NearBodies {
 public:
  /// Are the parts of these nodes told of by other means?
  using Told = std::function<bool(std::uint32_t ball, std::uint32_t socket)>;

  NearBodies(const NearPoses& poses, double gap_mm);

  /// May surfaces come as near as the gap in one of the poses? No is proven.
  bool may_meet(const SweptParts& ball, const SweptParts& socket, const Told& told) const;
  /// All pairs of faces that may, appended to `close`, with what keeps them apart; false if that is more than
  /// `most`, or nothing does.
  bool find_close(const SweptParts& ball, const SweptParts& socket, const Told& told, std::size_t most,
                  std::vector<ClosePair>& close) const;
  /// Do two points stay within reach in all of the poses? Yes is proven.
  bool stay_in_contact(const BodyTrees& ball, const BodyTrees& socket) const;
  /// The points that are deepest in the middle of the poses, one of each inner ball.
  std::vector<WithinReach> deepest(const BodyTrees& ball, const BodyTrees& socket, std::size_t most) const;

 private:
  Vec3 turned(const Vec3& x) const { return poses_.rotation * x; }
  TurnFace turned(const TurnFace& face) const;
  double least_squared(const Vec3& p, const Vec3& y) const;  // of p as R takes it, mm^2
  double most_squared(const Vec3& p, const Vec3& y) const;
  template <class Far, class Take>
  bool any_within_reach(const BodyTrees& ball, const BodyTrees& socket, const Far& far,
                        const Take& take) const;
  double most_along(const Vec3& n, const Vec3& p) const;
  template <class Meet>
  bool any_close(const SweptParts& ball, const SweptParts& socket, const Told& told, const Meet& meet) const;
  bool apart(const TurnFace& moved, const TurnFace& face) const;
  std::array<Vec3, 3> ways(const TurnFace& moved, const TurnFace& face) const;
  bool apart_along(const Vec3& n, const TurnFace& moved, const TurnFace& face) const;

  const NearPoses& poses_;
  double cosine_, sine_;  // of the turn
  double more_;           // mm: nearer by the shift, and the gap, which counts as contact
  double gap_;            // mm
};

/// Of a body, what InnerBalls has to know.
struct BodyInside {
  using Holds = std::function<bool(const Vec3& x)>;
  Holds holds;                                      // is x certainly inside? None if there is no inside
  std::function<double(const Vec3& x)> to_opening;  // mm, from x to where it may be open
};

/// Inner balls of a body, coarse and fine: points whose `doubt` is the radius, mm. A body without an inside
/// has points of its surface, of radius 0.
class InnerBalls {
 public:
  InnerBalls() = default;
  InnerBalls(const SweptParts& faces, const BodyInside& inside);

  /// As many as are worth asking in a turn of that, radians.
  const SweptParts& of(double turn) const;

 private:
  /// How near the surface comes to some ball, as a share of the size of the body, in each level.
  static constexpr std::array<double, 4> kNear{0.03, 0.01, 0.003, 0.001};
  static constexpr double kOfWay = 0.25;           // of a point as far from the centre as the body is large
  static constexpr std::size_t kMostAsked = 4000;  // faces
  std::array<SweptParts, kNear.size()> levels_;
};

}  // namespace impinge
