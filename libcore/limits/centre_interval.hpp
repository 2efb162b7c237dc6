// SPDX-License-Identifier: GPL-3.0-or-later
// Where is the limit of a turn if the centre is not known exactly? An interval that holds the limit for every
// centre within a distance r of the given one. Two kinds of doubt: both surfaces turn about a common centre
// t, |t| <= r; or the ball has play in the socket, which shifts it by any d, |d| <= r. Theorem 13 (centre).
//
// In a pose whose rotation has the angle theta a common centre shifts the ball by s = 2 r sin(theta / 2) at
// most, play by s = r. Up to the lower end no points of the surfaces come within s of each other (for a
// threshold g of the gap, within s + g, and no vertex as near to a wall). At the upper end one vertex proves
// the contact for every centre: it is deeper than s inside the other bone, or has crossed a sheet with more
// than s to spare.
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

/// What is not known: the common centre of both surfaces, which is within r of the origin; or the shift of
/// the ball by its play in the socket, which is r at most and may change with the angle.
enum class CentreDoubt { common, play };

/// Which centres a limit is to hold for.
struct CentreQuestion {
  CentreDoubt doubt = CentreDoubt::common;  // what is not known
  double within_mm = 0.0;                   // r
  double gap_mm = 0.0;                      // threshold of the gap; 0 for contact
};

/// Holds the limit for every such centre.
struct CentreInterval {
  double low_deg = 0.0;   // up to here no centre has contact, or the gap
  double high_deg = 0.0;  // up to here every centre has had it; the largest angle if that is not known
  bool limited = false;   // is it known?
};

/// The limit about the origin.
struct CentreLimit {
  double low_deg = 0.0;                // no contact, and no gap as small, up to here
  double high_deg = 0.0;               // contact, or the gap, here
  double largest_deg = 0.0;            // of the motion
  std::optional<TurnContact> contact;  // in the socket's frame
};

/// The intervals of several turns of one joint.
class CentreIntervals {
 public:
  /// The main surfaces, without edge-on faces (mesh/surface_vertices.hpp), the faces of these, and all
  /// bodies. All must outlive this.
  CentreIntervals(const CulledJoint& joint, const SweptParts& ball, const SweptParts& socket,
                  const CentreQuestion& question, const BodyPairs& bodies);
  CentreIntervals(CulledJoint&&, const SweptParts&, const SweptParts&, const CentreQuestion&,
                  const BodyPairs&) = delete;

  const CentreQuestion& question() const { return question_; }  // as it was asked

  /// The lower end of the interval, at most to_deg, the lower end about the origin. 0 if some centre may have
  /// contact at the start, or, for a threshold, if a surface comes within r of the origin. About the origin
  /// there must be no contact at the start.
  double low_deg(const JointTurn& turn, double to_deg) const;
  /// The largest shift of the ball up to that angle, mm.
  double most_shift(const JointTurn& turn, double to_deg) const;
  /// The least angle found by which every centre has had contact, or the gap; none if none was found.
  std::optional<double> high_deg(const JointTurn& turn, const CentreLimit& limit) const;

 private:
  /// A surface, as the search for contacts with the other one needs it.
  struct Side {
    const SweptParts& faces;
    SweptParts walls;
    SweptParts points;            // all vertices
    std::vector<JumpEdge> jumps;  // about the origin
    std::vector<Edge> border;     // edges of an odd number of faces
    double nearest = 0.0;         // mm, least distance of a face from the origin
  };
  Side side(const SweptParts& faces, Surface of) const;
  /// A turn from its start to an angle.
  struct Way {
    const JointTurn& turn;
    double free_deg;   // about the origin there is no contact up to here
    double angle_deg;  // the end of the way
    Pose pose;         // at the end
    double shift_mm;   // s at the end
  };
  /// Vertices near a contact: of the bodies and, where the main bones have no inside, of the main surfaces.
  struct NearContact {
    std::vector<BodyPairs::Vertex> vertices;
    std::vector<ScannedVertex> scanned;
  };
  NearContact near_contact(const JointTurn& turn, const TurnContact& contact) const;
  /// Has there been a contact up to the end of the way, whatever the centre is? Yes is proven.
  bool contact_always(const Way& way, const NearContact& near) const;
  /// Does a vertex have the gap at the end of the way, whatever the centre is? Yes is proven.
  bool gap_always(const Way& way) const;
  bool is_certain(const Way& way, const ScannedVertex& at) const;
  bool has_crossed(const Way& way, const ScannedVertex& at) const;
  std::optional<int> layers_passed(const ScannedVertex& at, const Vec3& x) const;
  double shift(const JointTurn& turn, const Pose& pose) const;

  const CulledJoint& joint_;
  CentreQuestion question_;
  const BodyPairs& bodies_;
  Side ball_;
  Side socket_;
};

}  // namespace impinge
