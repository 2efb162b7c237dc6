// SPDX-License-Identifier: GPL-3.0-or-later
// Error and time of the limits of all named motions, by our closed form and by others' tests of touch in
// steps, halved where a pose touches.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "files/csv.hpp"
#include "harness/driver.hpp"
#include "harness/timing.hpp"
#include "hip/anatomy.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/mesh_parts.hpp"

namespace impinge::lab {

// The joints whose limits are timed: a generated hip, whole bones, a replaced hip, and a needle that passes
// spikes.

struct TurnedMotion {
  std::string name;
  JointTurn turn;
  double largest_deg;
  std::optional<double> known_deg;  // first contact of the surfaces in closed form, to 1e-9
};

// Meshes in the joint frame about the centre, mm.
struct TurnedJoint {
  std::string name;
  BallSocketPair bones;   // whole, as other libraries take them
  BallSocketPair main{};  // of whole bones the surfaces of the joint (hip/whole_bone.hpp), else the same
  BoneParts beside{};
  std::optional<Side> side{};
  std::vector<TurnedMotion> motions{};  // empty: the named motions

  // What our method prepares once for a joint.
  TurnLimits limits() const { return TurnLimits(main, beside); }
  std::size_t faces() const { return bones.ball.faces.size() + bones.socket.faces.size(); }
};

// The normal hip of hip_presets.hpp and the implant of phantoms/phantom.hpp, each with about so many faces.
TurnedJoint generated_hip(std::size_t faces);
TurnedJoint replaced_hip(std::size_t faces);

// A ball with a thin pyramid, the needle. It turns in twelve directions, in each past the tip of a sharper
// spike in the plane of the turn. The tips of the spikes are 5 to 0.05 mm nearer to the centre than the tip
// of the needle, which therefore passes them in 6 to 0.05 degrees. It meets the rim of the cup 40 degrees or
// more later. At first contact the tip of the spike is on an edge of the pyramid.
TurnedJoint needle_past_spikes();

// The joints of a folder (harness/real_joints.hpp) that have a whole femur.ply and pelvis.ply beside their
// cut surfaces, about the centre of the sphere that fits the head.
std::vector<TurnedJoint> whole_joints(const std::filesystem::path& folder, Progress& progress);

// How much is timed.
struct LimitPlan {
  std::vector<double> steps_deg;      // for a library
  std::vector<double> few_steps_deg;  // for a slow one (ContactCase::few)
  std::size_t motions = 12;           // libraries answer this many motions, the first ones
  std::size_t few_motions = 12;       // slow ones answer this many
  int rounds = 1;
  int few_rounds = 1;  // for slow ones
  TimingOptions timing;
};
LimitPlan limit_plan(bool quick);

// The results, and the labels of the methods.
struct LimitTimes {
  Table table;
  TimingRun timing;
  std::map<std::string, std::string> labels;
};
LimitTimes empty_limit_times();         // no rows yet
std::vector<Column> limit_time_keys();  // joint, faces, method, step_deg

// Adds the rows of a joint. The truth of a motion is the smallest angle at which any method finds contact and
// CGAL exactly finds a common point. Throws std::runtime_error if this angle is before the lower end of our
// bracket, or if we report contact and there is no common point. Leaves out motions that begin in contact,
// and the joint if all do.
void add_limit_times(const TurnedJoint& joint, const LimitPlan& plan, LimitTimes& found, Progress& progress);

}  // namespace impinge::lab
