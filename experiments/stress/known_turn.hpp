// SPDX-License-Identifier: GPL-3.0-or-later
// Turns with a first contact in closed form, and the answers of methods. Lengths in mm, angles in radians
// unless a name says degrees.
//
// Bones turn about an axis through the centre. R is the largest radius, `rate` the decrease of the bones'
// distance per radian where they first meet. Rounding (20 u R for a turned vertex of either bone,
// limits/turn_contact.hpp) may move the contact by 40 u R / rate: the condition is R / (rate angle), the
// threshold 40. For bones that pass at a distance d the condition is R / d.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "hip/motion.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "stress/family.hpp"
#include "stress/slide.hpp"

namespace impinge::lab {

inline constexpr double kTurnThreshold = 40.0;
inline constexpr const char* kTurnDerivation =
    "20 u R of a turned vertex, of either bone, over what their distance loses a radian";
inline constexpr std::array kTurnSteps{1.0, 0.1};  // degrees, for methods that test poses in steps

struct KnownTurn {
  BallSocketPair bones;
  JointTurn turn;
  double largest_deg = 60.0;      // the turn goes up to this
  std::optional<double> contact;  // the first one, from the start; none if they never meet
  double rate = 1.0;              // mm a radian, see above
  double deepest = 0.0;           // angle of deepest overlap, or least distance
  double depth_mm = 0.0;          // overlap there; a negative one is a distance
};

// In each, k chooses radius, start and axis, which is x, y or z.

// Bone behind bone: a slab passes the far side of a tetrahedron's tip, at this distance.
KnownTurn passing_behind(std::size_t k, double distance_mm);
// A ridge of the ball passes across a ridge of the socket; they overlap by at most this.
KnownTurn grazing_ridges(std::size_t k, double depth_mm);
// A ridge meets another that is turned by this angle from it.
KnownTurn meeting_ridges(std::size_t k, double between);
// A tip meets a sheet this far from the sheet's border.
KnownTurn tip_beside_opening(std::size_t k, double beside_mm);
// A tip slides along the face of an octahedron (slide.hpp) and touches it `angle` before the deepest point of
// its path.
KnownTurn sliding_tip(std::size_t k, double angle, double octahedron_radius);
// The slide of that turn; the first three are about different axes.
Slide known_slide(std::size_t k, double angle, double octahedron_radius);

// Tests every method on turns of one magnitude: the first contact in closed form, and again for a ball that
// is too large (`mutated`); the exact test and the thesis' gaps of vertices, in steps of poses; and each test
// of a pose in the deepest pose and just before the contact.
std::vector<StabilityCase> judge_turns(double magnitude, std::span<const KnownTurn> turns);

// Tests turn_at(k, magnitude) for 9 or 60 values of k at each magnitude.
std::vector<StabilityCase> over_turns(std::span<const double> magnitudes, const StabilityRun& run,
                                      const std::function<KnownTurn(std::size_t, double)>& turn_at);

inline constexpr const char* kTurnMutation = "the ball has a skin of 1e-5 mm (a tolerance)";

}  // namespace impinge::lab
