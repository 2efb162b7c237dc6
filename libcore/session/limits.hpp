// SPDX-License-Identifier: GPL-3.0-or-later
// How far a session's joint turns: the limits that no step can jump over, about the meshes themselves
// (motion/told_limit.hpp), and the smallest gaps on the way by the tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/told_limit.hpp"
#include "session/pose_answer.hpp"

namespace impinge {

/// One angle grows from a start.
struct LimitRequest {
  Motion start;                     // degrees
  std::string growing;              // of motion_names()
  double largest_deg = 360.0;       // of the growth; no farther than anatomy allows
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 4.0;        // both layers together
};

/// One limit, and where it is reached.
struct LimitAnswer {
  const char* about;            // "ball" or "socket": whose centre
  Vec3 centre;                  // that, mm, input frame
  ToldLimit told;               // its bracket, and what half a millimetre changes
  std::optional<double> hours;  // where they touch, on the dial
  std::string ball_part;        // which part of the ball stops it (mesh/mesh_parts.hpp); empty: none of them
  std::string socket_part;      // the same of the socket
};

/// Of contact about the centre of the ball; about that of a sphere fitted to the socket, where one fits it
/// and the ball is not shifted; and of a gap of the cartilage's thickness, about the centre of the ball.
struct LimitAnswers {
  double largest_deg = 0.0;           // of the growth that was looked at
  LimitAnswer contact;                // about the ball's centre
  std::optional<LimitAnswer> socket;  // about the socket's
  LimitAnswer cartilage;              // of the contact where there is no cartilage
};
LimitAnswers answer_limits(Session& session, const LimitRequest& request);

/// The smallest gap of each step to the largest angle, mm, NaN where the surfaces do not meet.
struct Sweep {
  std::vector<double> angles;  // of the growth, degrees
  std::vector<double> smallest;
};
Sweep sweep(Session& session, const LimitRequest& request, double step_deg);

}  // namespace impinge
