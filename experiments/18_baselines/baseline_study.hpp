// SPDX-License-Identifier: GPL-3.0-or-later
// The results in baselines.csv: bytes, times, lost triangles and wrong answers of the methods of Section 3.6.
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

// Vertices at which methods of Section 3.6 are tested, with the exact answers and the methods' answers.

// Test points in one pose, with the exact answers.
struct BaselinePoints {
  std::vector<Vec3> on_ball;     // vertices of the ball in the socket's frame, mm
  std::vector<double> distance;  // exact distance from the socket, mm
  std::vector<Vec3> on_socket;   // vertices of the socket in the ball's frame that meet the ball, mm
  std::vector<double> radius;    // exact radius of the ball along them, mm
};

// A summary of a method's answers.
struct BaselineAnswers {
  std::size_t points = 0;                                        // points that were asked
  std::size_t missed = 0;                                        // no answer, though the surface is there
  double largest_mm = std::numeric_limits<double>::quiet_NaN();  // largest absolute error
  double rms_mm = std::numeric_limits<double>::quiet_NaN();      // root mean square of the errors
};

// Takes at most `most` vertices of each surface, evenly chosen, in a pose whose rotation lines nothing up.
BaselinePoints baseline_points(const BallSocketPair& joint, std::size_t most);

// Errors of the existing answers against the exact ones.
BaselineAnswers judge_answers(const std::vector<double>& answers, const std::vector<double>& exact);

// Poses at known distances from a contact, and a method's answers in them.

// A pose near a contact.
struct BaselinePose {
  Pose pose;               // of the ball in the socket
  double beyond_mm = 0.0;  // path of the ball past the first contact; negative before it
  bool touches = false;    // exactly
};

// The paths along which the ball is moved.
struct BaselineWays {
  std::size_t count = 10;  // number of paths
  double turn = 0.6;       // radians, the largest turn before a path, about any axis
  double shift = 12.0;     // mm, the length of a path, in any direction
  std::uint64_t seed = 0;  // of turns and directions
};

// Fourteen poses on each path: 0.05, 0.1, 0.2, 0.5, 1, 2 and 4 mm before and after the first contact by
// CGAL's tree. There are fewer paths if random ones do not bring the surfaces together.
std::vector<BaselinePose> baseline_poses(const BallSocketPair& joint, const BaselineWays& ways);

// How many poses a method got wrong.
struct BaselineVerdicts {
  std::size_t false_touches = 0;   // free poses that it calls touching
  std::size_t missed_touches = 0;  // touching poses that it calls free
  double wrong_within_mm = 0.0;    // the largest distance along a path from the contact with a wrong answer
};

// Counts the method's wrong answers in these poses.
BaselineVerdicts judge(const Touch& touches, const std::vector<BaselinePose>& poses);

// A joint and what is tested on it.
struct BaselineJoint {
  std::string name;           // in the results
  BallSocketPair meshes;      // centre frames, mm
  BaselineSizes sizes;        // of the methods
  BaselineWays ways;          // of the poses near contact
  std::size_t points = 2000;  // vertices of each surface that are tested, at most
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

/// The answers of a method at the points, judged by the exact ones; empty for a method without such answers.
/// Throws std::runtime_error if an answer breaks a proven bound.
BaselineAnswers ask(const BaselineCase& method, const BaselinePoints& points);

// Columns of the table, and keys of the timed cases.
std::vector<Column> baseline_columns();
std::vector<Column> baseline_keys();  // joint, method, setting and kind of time

// Builds, checks and judges all methods on all joints, then times them in one interleaved run.
BaselineTables baseline_tables(const std::vector<BaselineJoint>& joints, const BaselineOptions& options,
                               Progress& progress);

}  // namespace impinge::lab
