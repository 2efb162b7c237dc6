// SPDX-License-Identifier: GPL-3.0-or-later
// Where the limit of a turn is for every centre within a distance r of the one that was given.
//
// Unknown common centre. Were it t, both meshes would turn about t: a vertex x of the ball goes to R x + d,
// d = (I - R) t, |d| <= s(R) = 2 r sin(theta / 2) = r root(3 - tr R), theta the angle of R, and rays start at
// t. Play. The ball is shifted by any d, |d| <= s = r; rays start at the centre of the socket and at that of
// the ball.
//
// Lower end. From the start, let t (or d) grow from 0 to what it is, and then the angle: a path of poses that
// begins with one that is not impinged (nothing is known where that is), so that motion/turn_contact.hpp
// holds for it: the first impinged pose has (a) a common point of the surfaces, or (b) an end of a jump edge
// of one in the wall of a jump edge of the other, as seen from where the rays start. For (a) some parts were,
// without the shift, within s of each other. For (b)
//   R x + d against k y beyond the socket, k >= 1        within s + (k - 1) r; of the play, as the centre of
//                                                        the ball sees it, within k r
//   y against k (R x + d) within the ball, 0 <= k <= 1   within k s + (1 - k) r; of the play within r
// of each other. Walls are cut in shells of k, each with the largest of it. A jump edge of some t is one of
// the origin, or has a face whose plane is within r of it: both have walls. A search (motion/swept_parts.hpp)
// finds the first angle at which any parts are as near as that. Where a surface comes within r of the origin
// some t is behind it, rays from there see nothing of what was shown, and the lower end is 0. A threshold g
// of the gap adds g to all of them, since the distance is no larger than the gap along the ray, and every
// vertex is asked for at walls.
//
// Bone beside the joint (motion/body_pairs.hpp) has (a) alone, and the pose is impinged whatever the centre
// where a vertex of one body is farther than s inside the other.
//
// Upper end. Let p = R x be a vertex of the ball beyond the nearest layer of the socket, farther than s from
// all of its faces, and let no jump edge of the socket be within asin(max(r, s) / m) of p's direction, m its
// least radius. Over that cap the nearest layer is a continuous graph. The path from t to R x + d along a ray
// from t is within max(r, s) of the one from 0 to p; where it is beyond m it is in the cone over the cap; it
// begins within the layer, and ends in a ball about p that does not meet it and is beyond: it crosses the
// layer. So the pose is impinged for every t and every d. Likewise for a vertex of the socket within the
// farthest layer of the ball, with asin((r + s) / |y|). A threshold moves p out, or in, by g, and adds
// 2 g r / |p| to s for the turn of the ray.
#pragma once

#include <vector>

#include "contact/culled_joint.hpp"
#include "hip/motion.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/edges.hpp"
#include "motion/body_pairs.hpp"
#include "motion/swept_parts.hpp"

namespace impinge {

/// What is not known of the centre: both surfaces turn about one common centre that is within a distance r of
/// the origin, t with |t| <= r; or the ball has play in the socket, which shifts it by any d with |d| <= r,
/// not the same at every angle.
enum class CentreDoubt { common, play };

/// Which centres a limit is to hold for.
struct CentreQuestion {
  CentreDoubt doubt = CentreDoubt::common;  // what is not known
  double within_mm = 0.0;                   // r
  double gap_mm = 0.0;                      // threshold; 0 for first contact of the surfaces
  double largest_deg = 0.0;                 // largest angle of the motion, as for the limit itself
};

/// Contains the limit for every such centre.
struct CentreInterval {
  double low_deg = 0.0;   // none of them has an impinged pose up to here
  double high_deg = 0.0;  // with each of them the pose is impinged here; the largest angle if none is known
  bool limited = false;   // is such an impinged pose known?
};

/// The intervals of several turns of one joint.
class CentreIntervals {
 public:
  /// The meshes of the joint are without edge-on faces (mesh/surface_vertices.hpp); it must outlive this.
  /// So must what is beside it, if it is given.
  CentreIntervals(const CulledJoint& joint, const CentreQuestion& question,
                  const BodyPairs* beside = nullptr);
  CentreIntervals(const CulledJoint&&, const CentreQuestion&, const BodyPairs* = nullptr) = delete;

  const CentreQuestion& question() const { return question_; }  // as it was asked

  /// The lower end, `to_deg` at most: no centre is free beyond the lower end of the origin. 0 where the start
  /// is within reach of a contact. The start must not be impinged: then no faces pierce each other there
  /// (reference/meeting_surfaces.hpp), which first_within() would not see.
  double low_deg(const JointTurn& turn, double to_deg) const;
  /// The least angle found, from from_deg on, at which the pose is impinged with every centre; none if none
  /// was found.
  std::optional<double> high_deg(const JointTurn& turn, double from_deg) const;

 private:
  /// A surface as the other one meets it.
  struct Side {
    SweptParts faces;
    SweptParts walls;
    SweptParts points;            // ends of possible jump edges, or all vertices
    std::vector<JumpEdge> jumps;  // of the origin
    double nearest = 0.0;         // mm, of the faces
  };
  Side side(const TriangleMesh& mesh, const TriangleMesh& other, bool is_socket) const;
  /// Is the pose at that angle impinged, or the gap reached, whatever the centre is? Yes is proven.
  bool always(const JointTurn& turn, double angle_deg) const;
  bool is_certain(const Pose& pose, const ScannedVertex& at, double shift) const;
  double shift(const Pose& pose) const;

  const CulledJoint& joint_;
  CentreQuestion question_;
  const BodyPairs* beside_;
  Side ball_;
  Side socket_;
};

}  // namespace impinge
