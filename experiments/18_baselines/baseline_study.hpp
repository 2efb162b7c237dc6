// SPDX-License-Identifier: GPL-3.0-or-later
// What baselines.csv says: bytes, times, lost triangles and wrong answers of every method of Section 3.6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "gap/pose.hpp"
#include "harness/timing.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "methods/baseline.hpp"
#include "methods/method.hpp"

namespace impinge::lab {

// Vertices that the methods of Section 3.6 are asked about, with exact answers, and what they answered.

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

// Poses at known distances from a contact, and how a method answers in them.

// A pose near a contact.
struct BaselinePose {
  Pose pose;               // of the ball in the socket
  double beyond_mm = 0.0;  // way of the ball past the first contact; negative before it
  bool touches = false;    // exactly
};

// Which ways the ball is sent.
struct BaselineWays {
  std::size_t count = 10;  // of ways
  double turn = 0.6;       // radians, the largest turn before a way, about any axis
  double shift = 12.0;     // mm, the length of a way, in any direction
  std::uint64_t seed = 0;  // of turns and directions
};

// Fourteen poses of each way: 0.05, 0.1, 0.2, 0.5, 1, 2 and 4 mm before and after its first contact, as
// CGAL's tree decides it. Fewer ways where random ones do not bring the surfaces together.
std::vector<BaselinePose> baseline_poses(const BallSocketPair& joint, const BaselineWays& ways);

// How many poses a method got wrong.
struct BaselineVerdicts {
  std::size_t false_touches = 0;   // free poses that it calls touching
  std::size_t missed_touches = 0;  // touching poses that it calls free
  double wrong_within_mm = 0.0;    // the largest way from the contact at which an answer was wrong
};

// Asks the method about all of them.
BaselineVerdicts judge(const Touch& touches, const std::vector<BaselinePose>& poses);

// One joint, and what is tried on it.
struct BaselineJoint {
  std::string name;           // in the results
  BallSocketPair meshes;      // centre frames, mm
  BaselineSizes sizes;        // of the methods
  BaselineWays ways;          // of the poses near contact
  std::size_t points = 2000;  // vertices of each surface that are asked, at most
};

// How often everything is timed.
struct BaselineOptions {
  int build_rounds = 3;  // of building a method
  int pose_rounds = 9;   // of asking it
  double slow_s = 3.0;   // building that takes longer is timed once
};

// The result and its times.
struct BaselineTables {
  Table table;                                     // baselines.csv
  TimingRun timing;                                // of building and asking
  std::map<std::string, std::string> labels = {};  // of the methods
};

/// The answers of a method about the points beside the exact ones; nothing for one that gives none. Throws
/// std::runtime_error for an answer that breaks what is proven.
BaselineAnswers ask(const BaselineCase& method, const BaselinePoints& points);

// Columns of the table, and keys of the timed cases.
std::vector<Column> baseline_columns();
std::vector<Column> baseline_keys();  // joint, method, setting and what is timed

// Builds, checks and judges all methods on all joints, then times them in one interleaved run.
BaselineTables baseline_tables(const std::vector<BaselineJoint>& joints, const BaselineOptions& options,
                               Progress& progress);

}  // namespace impinge::lab
