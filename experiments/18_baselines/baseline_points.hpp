// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that the methods of Section 3.6 are asked about, with exact answers, and what they answered.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "gap/pose.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// Points that a method is asked about, in one pose, and what is true of them.
struct BaselinePoints {
  std::vector<Vec3> on_ball;     // vertices of the ball in the socket's frame, mm
  std::vector<double> distance;  // exact, from the socket, mm
  std::vector<Vec3> on_socket;   // vertices of the socket in the ball's frame that meet the ball, mm
  std::vector<double> radius;    // exact, of the ball along them, mm
};

// What a method answered.
struct BaselineAnswers {
  std::size_t points = 0;                                        // that it was asked about
  std::size_t missed = 0;                                        // got no answer, though the surface is there
  double largest_mm = std::numeric_limits<double>::quiet_NaN();  // largest error in size
  double rms_mm = std::numeric_limits<double>::quiet_NaN();      // root mean square of the errors
};

// At most `most` vertices of each surface, evenly chosen, in a pose whose rotation lines nothing up. Exact.
BaselinePoints baseline_points(const BallSocketPair& joint, std::size_t most);

// Errors of the answers, where there is one, against the exact ones.
BaselineAnswers judge_answers(const std::vector<double>& answers, const std::vector<double>& exact);

}  // namespace impinge::lab
