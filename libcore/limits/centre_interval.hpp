// SPDX-License-Identifier: GPL-3.0-or-later
// Where the limit of a turn is for every centre within a distance r of the one that was given.
//
// Unknown common centre. Were it t, both meshes would turn about t: a vertex x of the ball goes to R x + d,
// d = (I - R) t, |d| <= s(R) = 2 r sin(theta / 2) = r root(3 - tr R), theta the angle of R, and rays start at
// t. Play. The ball is shifted by any d, |d| <= s = r; rays start at the centre of the socket and at that of
// the ball.
//
// Lower end. From the start, let t (or d) grow from 0 to what it is, and then the angle: a path of poses that
// begins without contact (nothing is known where it does not), so that at the first contact the surfaces of
// bones have a common point: without the shift these were within s of each other. A search
// (limits/swept_parts.hpp) finds the first angle at which any are as near as that.
// For a threshold g of the gap it may also be that a vertex passes a jump edge, as seen from where the rays
// start: an end of a jump edge of one surface is in the wall of one of the other, moved by g. That is
//   R x + d against k y beyond the socket, k >= 1        within s + (k - 1) r; of the play, as the centre of
//                                                        the ball sees it, within k r
//   y against k (R x + d) within the ball, 0 <= k <= 1   within k s + (1 - k) r; of the play within r
// of each other. Walls are cut in shells of k, each with the largest of it. A jump edge of some t is one of
// the origin, or has a face whose plane is within r of it: both have walls. Where a surface comes within r of
// the origin some t is behind it, rays from there see nothing of what was shown, and the lower end is 0. A
// threshold adds g to all of them, since the distance is no larger than the gap along the ray, and every
// vertex is asked for at walls.
//
// Upper end. There is contact whatever the centre where a vertex of one body is farther than s inside the
// other and, if that has openings, the sphere about the origin on which the vertex turns is farther than s
// from all of them: it came in through the surface. A sheet has no inside (limits/body_pairs.hpp): let the
// way of a vertex, as it turns about the origin, nowhere come within s of the border of a sheet, cross the
// sheet an odd number of times, and begin and end farther than s from it. The ways about other centres stay
// within s of this one and can be shrunk to it clear of the border, so they cross the sheet too: surfaces
// meet. The crossings are counted by layers: before the limit there is none, and from there on, where no jump
// edge comes into the vertex's direction, the layers of the mesh that are nearer than the vertex change by
// one with each. Of a threshold: let p = R x be a vertex of the ball beyond the nearest layer of the socket,
// moved out by g, farther than s from all of its faces, and let no jump edge of the socket be within
// asin(max(r, s) / m) of p's direction, m its least radius. Over that cap the nearest layer is a continuous
// graph. The path from t to R x + d along a ray from t is within max(r, s) of the one from 0 to p; where it
// is beyond m it is in the cone over the cap; it begins within the layer, and ends in a ball about p that
// does not meet it and is beyond: it crosses the layer. So the gap is reached for every t and every d.
// Likewise for a vertex of the socket within the farthest layer of the ball, with asin((r + s) / |y|). The
// turn of the ray adds 2 g r / |p| to s. Theorem 13 (centre).
#pragma once

#include <optional>
#include <vector>

#include "contact/culled_joint.hpp"
#include "hip/motion.hpp"
#include "limits/body_pairs.hpp"
#include "limits/swept_parts.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/edges.hpp"

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
};

/// Contains the limit for every such centre.
struct CentreInterval {
  double low_deg = 0.0;   // with none of them there is contact, or the gap, up to here
  double high_deg = 0.0;  // with each of them there is up to here; the largest angle if no such is known
  bool limited = false;   // is such an angle known?
};

/// The limit of the origin.
struct CentreLimit {
  double low_deg = 0.0;                // no contact, and no gap as small, up to here
  double high_deg = 0.0;               // there is one here
  double largest_deg = 0.0;            // of the motion
  std::optional<TurnContact> contact;  // in the socket's frame
};

/// The intervals of several turns of one joint.
class CentreIntervals {
 public:
  /// The main surfaces, without edge-on faces (mesh/surface_vertices.hpp), and all bodies; both must outlive
  /// this.
  CentreIntervals(const CulledJoint& joint, const CentreQuestion& question, const BodyPairs& bodies);
  CentreIntervals(const CulledJoint&&, const CentreQuestion&, const BodyPairs&) = delete;

  const CentreQuestion& question() const { return question_; }  // as it was asked

  /// The lower end, `to_deg` at most: no centre is free beyond the lower end of the origin. 0 where the start
  /// is within reach of a contact. There must be none at the start: then no faces pierce each other there,
  /// which first_within() would not see.
  double low_deg(const JointTurn& turn, double to_deg) const;
  /// The least angle found at which every centre has come to a contact, or the gap; none if none was found.
  std::optional<double> high_deg(const JointTurn& turn, const CentreLimit& limit) const;

 private:
  /// A surface as the other one meets it.
  struct Side {
    SweptParts faces;
    SweptParts walls;
    SweptParts points;            // ends of possible jump edges, or all vertices
    std::vector<JumpEdge> jumps;  // of the origin
    std::vector<Edge> border;     // where the mesh ends, or three of its faces meet
    double nearest = 0.0;         // mm, of the faces
  };
  Side side(const TriangleMesh& mesh, const TriangleMesh& other, bool is_socket) const;
  /// A vertex on the way that a turn takes it, from the end of what is free on.
  struct Way {
    const JointTurn& turn;
    double free_deg;  // no contact up to here
    double angle_deg;
    Pose pose;        // there
    double shift_mm;  // there
  };
  /// Vertices near a contact, of bodies and, where these have no inside, of the main surfaces.
  struct NearContact {
    std::vector<BodyPairs::Vertex> vertices;
    std::vector<ScannedVertex> scanned;
  };
  NearContact near_contact(const JointTurn& turn, const TurnContact& contact) const;
  /// Was there a contact up to that angle, whatever the centre is? Yes is proven.
  bool contact_always(const Way& way, const NearContact& near) const;
  /// The same of the gap.
  bool gap_always(const Way& way) const;
  bool is_certain(const Way& way, const ScannedVertex& at) const;
  bool has_crossed(const Way& way, const ScannedVertex& at) const;
  std::optional<int> layers_passed(const ScannedVertex& at, const Vec3& x) const;
  double shift(const Pose& pose) const;
  double most_shift(const Way& way) const;

  const CulledJoint& joint_;
  CentreQuestion question_;
  const BodyPairs& bodies_;
  Side ball_;
  Side socket_;
};

}  // namespace impinge
