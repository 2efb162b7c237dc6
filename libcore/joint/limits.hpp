// SPDX-License-Identifier: GPL-3.0-or-later
// How far a session's joint turns: limits of the meshes themselves, found without steps that could jump over
// a contact (limits/told_limit.hpp), and the smallest gaps on the way, by the tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "joint/pose_answer.hpp"
#include "limits/told_limit.hpp"

namespace impinge {

/// One angle grows from a start.
struct LimitRequest {
  Motion start;                     // degrees
  std::string growing;              // of motion_names()
  double largest_deg = 360.0;       // of the growth; cut to largest_growth() (hip/motion.hpp)
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 4.0;        // both layers together
};

/// One limit, and where it is reached.
struct LimitAnswer {
  const char* about;            // "ball" or "socket": about whose centre the ball turns
  Vec3 centre;                  // this centre, mm, input frame
  ToldLimit told;               // its bracket, and what half a millimetre changes
  std::optional<double> hours;  // where they touch, on the dial
  std::string ball_part;        // what of the ball touches there (hip/joint_places.hpp), or the name of its
                                // part (mesh/mesh_parts.hpp); empty without a contact
  std::string socket_part;      // the same of the socket
};

/// What meets what, as "rim and neck"; empty where nothing does.
std::string meets(const LimitAnswer& answer);
/// What a reader must know: what meets what, and a mark where half a millimetre changes the limit
/// (ToldLimit::hangs_on_less()) or the ball's mesh ends. The column `what` of limits.csv.
std::string what_of(const LimitAnswer& answer);

/// The limits of one growing angle.
struct LimitAnswers {
  double largest_deg = 0.0;           // of the growth that was looked at
  LimitAnswer contact;                // of contact, about the ball's centre
  std::optional<LimitAnswer> socket;  // about the centre of a sphere fitted to the socket; none if none fits
                                      // or the ball is shifted
  LimitAnswer cartilage;              // of a gap of cartilage_mm, about the ball's centre; `contact` if 0
};
LimitAnswers answer_limits(Session& session, const LimitRequest& request);

/// The smallest gap at each step to the largest angle, by the tables.
struct Sweep {
  std::vector<double> angles;    // of the growth, degrees
  std::vector<double> smallest;  // mm, NaN where the surfaces do not face each other
};
Sweep sweep(Session& session, const LimitRequest& request, double step_deg);

}  // namespace impinge
