// SPDX-License-Identifier: GPL-3.0-or-later
// The bone to cut from a session's ball, or its socket, so that required motions are reached
// (change/resection.hpp), with checks of the joint, and exact tests of what is left.
//
// A cut is refused where
//   * the pose of the scan touches, or has a gap below the clearance, already;
//   * the mesh of the ball ends under the socket on the way: the missing bone may be in the way too;
//   * it reaches the bearing surface of the ball: vertices within SphereFit::trim of the sphere that fits the
//     head (hip/sphere_fit.hpp) and facing the socket in the pose of the scan;
//   * it reaches the bearing surface of the socket: vertices within BallFitOptions::trim of the sphere of
//     measure_acetabulum() (hip/hip_measures.hpp) that are farther inside the rim than may be trimmed. At
//     that distance the sphere goes on all round them. A socket without a rim that can be measured is not
//     checked for this;
//   * it thins the neck too much: the widest round bar about the axis of the neck (hip/hip_measures.hpp) that
//     the cut leaves whole is narrower than asked for. A ball without a neck is not checked for this, nor a
//     cut of the socket;
//   * bone beside the joint stops a required motion after the cut (limits/body_pairs.hpp). Such parts are not
//     cut, and need no clearance.
//
// The least cut of all removes bone along the same rays, from the same radius on, so the checks of bearing
// surface and neck hold for it as well. It is refused if the socket has no wall or there is bone
// beside the joint, and there is none of the socket.
#pragma once

#include <optional>
#include <vector>

#include "change/resection.hpp"
#include "joint/session.hpp"
#include "limits/turn_limit.hpp"

namespace impinge {

/// Default of how far inside its rim a socket may be cut, mm. Our choice: no published limit is known to us.
inline constexpr double kMostRim = 5.0;

/// What is asked.
struct ResectionRequest {
  std::vector<Motion> required;         // degrees; each along its own path (change/required_motion.hpp)
  double clearance_mm = 0.5;            // above 0
  std::optional<double> least_neck_mm;  // width of the bar; kNeckShare of the neck's width if not given
  bool least = false;                   // the least cut of all too; of the ball alone
  Surface cut = Surface::ball;          // what is cut
  double most_rim_mm = kMostRim;        // of a cut of the socket: how far inside its rim it may come; above 0
};

/// Default width of the bar, as a share of the neck's width: up to 30 % of the anterolateral quadrant of the
/// neck can be resected before it breaks at a lower load (Mardones et al. 2005, cadaver femora).
inline constexpr double kNeckShare = 0.7;

/// A leg of a required path, before the cut and after.
struct ReachedLeg {
  RequiredLeg leg;   // joint frame
  TurnLimit before;  // of first contact, up to the end of the leg
  TurnLimit after;   // the same after the cut, up to kBeyondLeg degrees more
};

inline constexpr double kBeyondLeg = 10.0;  // degrees that are looked at beyond what is required

/// Width of the round bar inside the neck, mm.
struct NeckBar {
  double least = 0.0;   // asked for
  double before = 0.0;  // in the uncut ball, where it is cut
  double after = 0.0;   // in the cut ball
};

struct ResectionAnswer {
  Resection cut;                  // joint frame, mm
  std::vector<ReachedLeg> legs;   // none of which touches after the cut
  Vec3 deepest = Vec3::Zero();    // where the cut is deepest, input frame, mm
  std::optional<LeastCut> least;  // joint frame, mm, if it was asked for
  std::optional<NeckBar> neck;    // none without a neck, or without a cut beside it
};

/// std::runtime_error, one line with the place in the input frame, if the cut is refused.
ResectionAnswer answer_resection(Session& session, const ResectionRequest& request);

}  // namespace impinge
