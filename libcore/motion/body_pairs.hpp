// SPDX-License-Identifier: GPL-3.0-or-later
// Bone beside the joint (mesh/mesh_parts.hpp) against the bone of the other side: a part of the ball with the
// socket or its parts, a part of the socket with the ball.
//
// The main surfaces of a joint face each other: the ball is bone from its centre to its outermost layer, the
// socket from its innermost layer outwards, and a radius beyond the other is contact (gap/overlay.hpp). A
// part does not fill a ray like that: it is bone only between where a ray enters and leaves it, and a spine
// far out on a ray does not stop a shaft below it. So here bone is in contact
//   where the surfaces have a common point, faces seen edge-on included: then, without a translation, both
//     have one radius in one direction; or
//   where a vertex of one is inside the other, although no surfaces meet.
// A closed surface has an inside; so has the ball, from its centre on, whatever end a shaft has. A socket
// that is not closed has none: what lies behind it in a single pose is not seen. Motions do not need it. From
// a clear pose bodies move continuously, and what is not inside another can come to be so only through a pose
// in which surfaces meet: of closed ones their distance is continuous, and an open one ends where its mesh
// does.
//
// Many poses at once. In a rotation within rho of R, R first and then a turn by rho at most, no point p of
// the ball is farther from R p than s = 2 |p| sin(rho / 2), and a shift adds its length. So if surfaces are
// farther than s apart under R, they meet in none of these rotations: then each connected piece of one is
// inside the other in all of them or in none, which one of its points tells. And a vertex that is inside
// under R and farther than s from the surface is inside in all of them. Where a distance of g and less counts
// as contact, surfaces farther than s + g apart are clear in all of them, and a vertex within g - s of the
// other surface is in contact in all of them. A ball whose mesh ends counts as bone beyond its end, as the
// centre sees it; so there the walls of that shadow count as surface too.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gap/pose.hpp"
#include "hip/motion.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/mesh_parts.hpp"
#include "motion/swept_parts.hpp"
#include "motion/turn_contact.hpp"

namespace impinge {

/// All poses near a rotation of the ball.
struct NearPoses {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double turn = 0.0;       // radians, the largest turn away from it
  double shift_mm = 0.0;   // the largest shift of the ball
  double centre_mm = 0.0;  // how far the centre of both bodies may be from the origin
  double gap_mm = 0.0;     // a distance of surfaces, not along rays, as small as that counts as contact
};

/// The bodies of a joint and its pairs that have a part. Meshes in one frame, mm.
class BodyPairs {
 public:
  BodyPairs(const BallSocketPair& main, const BoneParts& beside);

  /// Places of two bodies: 0 is the main surface, k the part k - 1.
  struct Pair {
    std::size_t ball;
    std::size_t socket;
  };

  bool empty() const { return pairs_.empty(); }
  /// Is any pair in contact? Exact, for the ball's vertices as the pose rounds them.
  bool impinged(const Pose& pose) const;
  struct Nearest {
    Pair pair;
    double distance_mm;  // of the surfaces, up to rounding and never above the true one; 0 in contact
    bool touch;          // exact
  };
  /// The pair whose surfaces are nearest to each other (motion/part_distance.hpp); none without a part.
  std::optional<Nearest> nearest(const Pose& pose) const;
  /// Is some vertex, along its ray, within gap_mm of the other body, or inside it?
  bool vertex_within(const Pose& pose, double gap_mm) const;
  /// Is some vertex inside the other body, and farther than that from its surface?
  /// The walls of a ball's shadow count as surface, for every centre within centre_mm of the origin.
  bool vertex_inside_by(const Pose& pose, double depth_mm, double centre_mm) const;
  /// A pair that may be in contact in one of the poses; std::nullopt proves that none is, in any of them.
  std::optional<Pair> may_meet(const NearPoses& poses) const;
  /// Is some vertex inside the other body, or within the gap of it, in all of the poses? Yes is proven.
  bool overlap(const NearPoses& poses) const;
  /// The search for first contacts in the turn, one for each pair. largest_gap: mm, as in TurnScene.
  std::vector<TurnContacts> contacts(const JointTurn& turn, double largest_gap) const;
  /// The least first_within() (swept_parts.hpp) of all pairs, radians. `ball` and `socket` are the rotations
  /// to the frame whose +z is the axis. Walls as in vertex_inside_by().
  double first_within(const Eigen::Matrix3d& ball, const Eigen::Matrix3d& socket, const WithinSpan& within,
                      double centre_mm, double largest) const;

 private:
  struct Body {
    Body(TriangleMesh of, bool main, bool ball, double farthest);
    TriangleMesh mesh;           // with the walls below, to which a turn may bring a part
    TurnParts parts;             // of it
    SweptParts faces;            // without them
    SweptParts beyond;           // of a ball that ends: walls of its shadow, to beyond all bodies
    double stretch = 0.0;        // how many times farther from the centre than its end these are
    Vec3 anchor = Vec3::Zero();  // the centre, of a main surface; a point outside of a part
    bool about_centre = false;   // which of them
    bool anchored = false;       // has it an inside?
    bool anchor_inside = false;  // is the anchor there?
    std::vector<Vec3> pieces;    // a vertex of each connected piece of the faces
    std::vector<Vec3> loose;     // vertices that only faces without area have
    bool holds(const Vec3& x) const;
    void find_pieces();
  };
  /// A body in these poses, as the frame of the other one has it.
  struct Moved {
    const Body& body;
    const NearPoses& poses;
    Eigen::Matrix3d rotation;                // to that frame
    double reach(double from_centre) const;  // mm, from where the rotation takes a point
    bool may_enter(const Body& other) const;
    bool is_within(const Body& other) const;
    bool is_off(const Body& other, const Vec3& x, double by_mm = 0.0) const;
    bool is_near(const Body& other, const Vec3& x) const;
  };
  template <class Found>
  bool any_vertex_of(const Pair& pair, const Pose& pose, const Found& found) const;
  template <class Found>
  bool any_vertex(const Pose& pose, const Found& found) const;
  bool touch(const Pair& pair, const Pose& pose) const;

  std::vector<std::unique_ptr<const Body>> ball_;
  std::vector<std::unique_ptr<const Body>> socket_;
  std::vector<Pair> pairs_;
};

}  // namespace impinge
