// SPDX-License-Identifier: GPL-3.0-or-later
// All poses near one rotation: how near do the faces of two bodies come in them, and what stays inside a body
// in all of them? A shift of the ball and a gap that counts as contact are allowed for. Theorem 14 (volume).
//
// Inner balls are spheres that hold nothing but the inside of a body, such as the largest ones that touch its
// surface from within. A point of another body that stays in one of them is inside in all of the poses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limits/swept_parts.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {

/// All poses near a rotation of the ball.
struct NearPoses {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double turn = 0.0;           // radians, the largest turn away from `rotation`
  double shift_mm = 0.0;       // the largest shift of the ball
  double gap_mm = 0.0;         // a face as near as this counts as in contact
  Vec3 offset = Vec3::Zero();  // mm, a shift of the ball that all poses have, beside that one
};

/// A point of each body, in the body's own frame, mm. The bodies are in contact in every rotation that brings
/// the points to within `reach` of each other; an offset of the poses is taken off `of_socket`.
struct WithinReach {
  Vec3 of_ball;
  Vec3 of_socket;
  double reach;  // mm
};

/// A plane that keeps two faces apart in the middle pose R: n . R x < least for all points x of the ball's
/// face, n . y >= least plus the gap for all y of the socket's.
struct ApartPlane {
  Vec3 normal;   // unit n, socket's frame
  double least;  // mm
  double angle;  // radians, of a turn that closes the distance, roughly
};

/// A face of the ball and a face of the socket that may come near each other in one of the poses.
struct ClosePair {
  const Triangle& of_ball;          // as the ball lies at rest, mm
  const Triangle& moved;            // as R turns it
  const Triangle& of_socket;        // from the shifted ball's centre
  const std::array<Vec3, 3>& ways;  // unit, to be tried first; those of both faces are among them
  double gap;                       // mm, the shift and the gap

  static constexpr std::size_t kPlanes = 12;
  /// The kth plane that is tried: across the ways, then along an edge of each face. None where it does not
  /// keep the faces apart. If no k has a plane, they meet, or their gap is too small.
  std::optional<ApartPlane> plane(std::size_t k) const;
};

using TakeClose = std::function<bool(const ClosePair&)>;  // false ends the search

/// A body: its faces, and its inner balls (below).
struct BodyTrees {
  const SweptParts& faces;  // borrowed
  const SweptParts& inner;  // borrowed
};

/// Answers for two bodies: `ball` turns, `socket` rests. Each tree is in its body's frame, mm.
class NearBodies {
 public:
  /// Does the caller decide about the faces of these two nodes by other means? They are left out then.
  using Told = std::function<bool(std::uint32_t ball, std::uint32_t socket)>;

  NearBodies(const NearPoses& poses, double gap_mm);

  /// Two trees, and which pairs of their nodes are asked about; the caller knows of all others that they are
  /// apart.
  struct Asked {
    const SweptParts& ball;    // borrowed
    const SweptParts& socket;  // borrowed
    const Told& told;          // borrowed
    const NodePairs& pairs;    // borrowed
  };
  /// At most some `most` pairs of nodes below those that hold all parts which may come as near as the gap.
  NodePairs left(const Asked& asked, std::size_t most) const;
  /// May the surfaces come as near as the gap in one of the poses? No is proven.
  bool may_meet(const Asked& asked) const;
  /// Calls take() for all pairs of faces that may come so near, the nearest first, more or less. False if
  /// take() was.
  bool each_close(const Asked& asked, const TakeClose& take) const;
  /// Is there a point of one body that stays in an inner ball of the other, or within the gap of it, in all
  /// of the poses? Yes is proven.
  bool stay_in_contact(const BodyTrees& ball, const BodyTrees& socket) const;
  /// The points that are deepest inside in the middle pose, one for each inner ball, at most `most`.
  std::vector<WithinReach> deepest(const BodyTrees& ball, const BodyTrees& socket, std::size_t most) const;

 private:
  Vec3 turned(const Vec3& x) const { return poses_.rotation * x; }
  TurnFace turned(const TurnFace& face) const;
  Vec3 seen(const Vec3& y) const { return y - poses_.offset; }  // from the shifted ball's centre
  TurnFace seen(TurnFace face) const;
  double least_squared(const Vec3& p, const Vec3& y) const;  // distance of p, turned by R, from y, mm^2
  double most_squared(const Vec3& p, const Vec3& y) const;
  template <class Far, class Take>
  bool any_within_reach(const BodyTrees& ball, const BodyTrees& socket, const Far& far,
                        const Take& take) const;
  double most_along(const Vec3& n, const Vec3& p) const;
  bool apart(const Asked& asked, std::uint32_t p, std::uint32_t q) const;
  template <class Meet>
  bool any_close(const Asked& asked, const Meet& meet) const;
  using Ways = std::array<Vec3, 3>;  // directions that are tried for two faces
  bool apart(const TurnFace& moved, const TurnFace& face, Ways& ways) const;
  Vec3 way(std::size_t k, const TurnFace& moved, const TurnFace& face) const;
  bool apart_along(const Vec3& n, const TurnFace& moved, const TurnFace& face, double slack) const;

  const NearPoses& poses_;
  double cosine_, sine_;  // of the largest turn
  double chord_;          // by which it moves a point, as a share of its distance from the centre
  double more_;           // mm, the shift and the gap
  double gap_;            // mm
  double away_;           // mm, the length of the offset
};

/// What InnerBalls has to know of a body.
struct BodyInside {
  using Holds = std::function<bool(const Vec3& x)>;
  Holds holds;                                      // is x certainly inside? Empty if there is no inside
  std::function<double(const Vec3& x)> to_opening;  // mm, distance of x from the nearest opening
};

/// Inner balls of a body, coarse and fine, as points whose `doubt` is the radius, mm. A body without an
/// inside has points of its surface, with the radius 0.
class InnerBalls {
 public:
  InnerBalls() = default;
  InnerBalls(const SweptParts& faces, const BodyInside& inside);

  /// The level that is worth asking about poses within `turn` radians: the narrower, the finer.
  const SweptParts& of(double turn) const;

 private:
  /// For each level: the surface is no farther from some ball than this share of the body's size.
  static constexpr std::array<double, 6> kNear{0.03, 0.01, 0.003, 0.001, 0.0005, 0.00025};
  static constexpr double kOfWay = 0.02;           // of() takes a share of at most this part of the turn
  static constexpr std::size_t kMostAsked = 6000;  // faces
  std::array<SweptParts, kNear.size()> levels_;
};

}  // namespace impinge
