// SPDX-License-Identifier: GPL-3.0-or-later
// How far can the ball turn before it touches the socket, or before a gap falls to a threshold? A bracket
// [low, high] that no step can jump over.
//
//   low    no angle from the start to here is impinged (limits/turn_contact.hpp has the proof, and the 1e-12
//          of the radius up to which it holds in floating point)
//   high   here the pose is impinged: the overlay decides it exactly (detection/overlay.hpp), culled
//          (culling/culled_overlay.hpp); of a threshold, a vertex has that gap, in double
// First contact is that of the surfaces, edges across edges and rims included. A threshold of the gap is
// about the vertices of both surfaces, as the thesis' scans are: between vertices a gap may be smaller by
// about the sagitta of a face. The bracket is about as wide as 1e-7 degrees, and wider only where surfaces
// graze within the tolerance and part again: then low stays at the first of these places.
//
// How far to trust it. The bracket is that of the meshes. Where the centre is off by some delta, or the
// surface, by delta across the contact, the limit moves by delta / |n . (w x p)| to first order: p the place
// of the contact, n the normal there, w the axis. That is `deg_per_mm`; half a millimetre is a few degrees.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "culling/culled_overlay.hpp"
#include "joint/motion.hpp"
#include "limits/turn_contact.hpp"
#include "limits/vertex_gap.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

// How a search for a limit ended.
enum class LimitState {
  reached,
  free,     // not reached up to the largest angle asked for: low and high are that angle
  blocked,  // impinged at the start, or below the threshold: low and high are 0
};

// "reached", "free", "blocked".
std::string_view name(LimitState state);

// The bracket of a limit, and where the surfaces touch there.
struct TurnLimit {
  LimitState state = LimitState::free;  // says what the bracket means
  double low_deg = 0.0;                 // from the start, see above
  double high_deg = 0.0;                // likewise
  std::optional<TurnContact> contact;   // where reached, in the frame of the socket
  double deg_per_mm = 0.0;              // where reached; infinite where the contact is tangential
};

// A joint whose turns are asked for. Meshes in one frame whose origin is the centre of both, mm: a shift of
// the ball, as that to the socket's own centre, is made before.
class TurnLimits {
 public:
  explicit TurnLimits(BallSocketPair joint);  // takes the meshes, and sorts their parts once

  // largest_deg in (0, 360].
  TurnLimit first_contact(const JointTurn& turn, double largest_deg) const;
  // The bracket of the turn at which some vertex has a gap of gap_mm, mm, or less.
  TurnLimit gap_of(const JointTurn& turn, double gap_mm, double largest_deg) const;

  // Smallest gap of a vertex with the turn at that angle.
  std::optional<VertexGap> smallest_gap(const JointTurn& turn, double angle_deg) const;

  // Is the pose at that angle impinged? Exact (detection/overlay.hpp).
  bool impinged(const JointTurn& turn, double angle_deg) const;

 private:
  TurnContacts contacts(const JointTurn& turn, double largest_gap) const;
  template <class Next, class Reached>
  TurnLimit bracket(const JointTurn& turn, double largest_deg, const Next& next,
                    const Reached& reached) const;

  // The meshes, and what answers for them.
  struct Answers {
    explicit Answers(BallSocketPair joint);
    BallSocketPair meshes;
    CulledJoint vertices;
    CulledOverlay surfaces;
  };

  std::unique_ptr<const Answers> answers_;
  TurnParts ball_parts_;
  TurnParts socket_parts_;
};

}  // namespace impinge
