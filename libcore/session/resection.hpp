// SPDX-License-Identifier: GPL-3.0-or-later
// What of a session's ball would have to go so that required motions are reached, and whether that can be:
// motion/resection.hpp, with the checks that a user's joint needs, and the cut ball held against the exact
// means of the library.
//
// A cut is refused where
//   * the pose of the scan touches, or has a gap below the clearance, already;
//   * the mesh of the ball ends under the socket on the way: what is missing may be in the way too;
//   * it reaches the bearing surface: vertices of the ball that lie on the sphere that fits the head, as near
//     as those that the fit took (hip/sphere_fit.hpp, SphereFit::trim), and face the socket in the pose of
//     the scan;
//   * it comes so near to the axis of the neck that the widest round bar about it which no cut enters is
//     narrower than was asked for. The axis is that of hip/hip_measures.hpp; a ball without a neck is not
//     asked.
//
// The least cut of all takes bone along the same rays, from the same radius on: what holds for the radial cut
// of bearing surface and neck holds for it. It is refused where the socket has no wall.
#pragma once

#include <optional>
#include <vector>

#include "motion/resection.hpp"
#include "motion/turn_limit.hpp"
#include "session/session.hpp"

namespace impinge {

/// What is asked.
struct ResectionRequest {
  std::vector<Motion> required;         // degrees; each along its own path (motion/required_motion.hpp)
  double clearance_mm = 0.5;            // above 0
  std::optional<double> least_neck_mm;  // width of the bar; kNeckShare of the neck's width if not given
  bool least = false;                   // the least cut of all too
};

/// Of the neck's width, where no width was asked for: up to 30 % of the anterolateral quadrant of the neck
/// can go before less load breaks it (Mardones et al. 2005, cadaver femora).
inline constexpr double kNeckShare = 0.7;

/// A leg of a required path, before the cut and after.
struct ReachedLeg {
  RequiredLeg leg;   // joint frame
  TurnLimit before;  // of first contact, up to the end of the leg
  TurnLimit after;   // the same with the ball cut, up to kBeyondLeg degrees more
};

inline constexpr double kBeyondLeg = 10.0;  // degrees that are looked at beyond what is required

/// What is left of the neck, mm.
struct NeckBar {
  double least = 0.0;   // that was asked for
  double before = 0.0;  // width of the bar that the ball holds where it is cut
  double after = 0.0;   // and that the cut leaves
};

struct ResectionAnswer {
  Resection cut;                  // joint frame, mm
  std::vector<ReachedLeg> legs;   // none of which touches after the cut
  Vec3 deepest = Vec3::Zero();    // where the cut is deepest, input frame, mm
  std::optional<LeastCut> least;  // joint frame, mm, if it was asked for
  std::optional<NeckBar> neck;    // none without a neck, or without a cut beside it
};

/// std::runtime_error, one line with the place in the input frame, where it is refused.
ResectionAnswer answer_resection(Session& session, const ResectionRequest& request);

}  // namespace impinge
