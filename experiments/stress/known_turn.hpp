// SPDX-License-Identifier: GPL-3.0-or-later
// Turns whose first contact is known in closed form, and what methods make of them. Lengths in mm, angles in
// radians where a name does not say degrees.
//
// Bones turn about an axis through the centre. With R the largest radius and `rate` what the distance of the
// bones loses a radian where they first meet, rounding (20 u R of a turned vertex, limits/turn_contact.hpp,
// of either bone) may move the contact by 40 u R / rate: condition R / (rate angle), threshold 40. The
// condition of a distance d at which bones pass one another is R / d.
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
inline constexpr std::array kTurnSteps{1.0, 0.1};  // degrees, of those that pose after pose is asked

struct KnownTurn {
  BallSocketPair bones;
  JointTurn turn;
  double largest_deg = 60.0;      // how far it is asked
  std::optional<double> contact;  // the first, from the start; none: they never meet
  double rate = 1.0;              // mm a radian, see above
  double deepest = 0.0;           // where they overlap most, or are nearest
  double depth_mm = 0.0;          // there; below zero their distance
};

// In each, k chooses radius, start and axis: that of x, y or z.

// Bone behind bone: a slab passes the tip of a tetrahedron on the far side from the centre, at that distance.
KnownTurn passing_behind(std::size_t k, double distance_mm);
// A ridge of the ball passes across one of the socket so that they overlap by no more than that.
KnownTurn grazing_ridges(std::size_t k, double depth_mm);
// A ridge meets another, from which it is turned by that angle.
KnownTurn meeting_ridges(std::size_t k, double between);
// A tip meets a sheet so far from the border of the sheet.
KnownTurn tip_beside_opening(std::size_t k, double beside_mm);
// A tip slides along the face of an octahedron (slide.hpp), and touches it from `angle` before the deepest
// point of its way on.
KnownTurn sliding_tip(std::size_t k, double angle, double octahedron_radius);
// The slide of that turn: the first three are about different axes.
Slide known_slide(std::size_t k, double angle, double octahedron_radius);

// Every method on turns of one magnitude: the first contact in closed form, and the same of a ball that is
// too large (`mutated`); the exact test, and the thesis' gaps of vertices, pose after pose in steps; and each
// test of a pose in the deepest one and just before the contact.
std::vector<StabilityCase> judge_turns(double magnitude, std::span<const KnownTurn> turns);

// Of turn_at(k, magnitude) for 9 or 60 k, at each magnitude.
std::vector<StabilityCase> over_turns(std::span<const double> magnitudes, const StabilityRun& run,
                                      const std::function<KnownTurn(std::size_t, double)>& turn_at);

inline constexpr const char* kTurnMutation = "the ball has a skin of 1e-5 mm (a tolerance)";

}  // namespace impinge::lab
