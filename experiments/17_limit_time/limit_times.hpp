// SPDX-License-Identifier: GPL-3.0-or-later
// Error and time of the limits of all named motions: ours, in closed form, and what steps with a test of
// touch find, halved where one touches.
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

// Joints whose limits are timed: a generated hip, whole bones, a replaced hip, and a needle that passes
// spikes.

struct TurnedMotion {
  std::string name;
  JointTurn turn;
  double largest_deg;
  std::optional<double> known_deg;  // where surfaces first meet, in closed form, to 1e-9
};

// Meshes in the joint frame about the centre, mm.
struct TurnedJoint {
  std::string name;
  BallSocketPair bones;   // whole, as others' libraries take them
  BallSocketPair main{};  // of whole bones their surfaces of the joint, else the same (hip/whole_bone.hpp)
  BoneParts beside{};
  std::optional<Side> side{};
  std::vector<TurnedMotion> motions{};  // none: the named ones

  // What is done once for a joint, by ours.
  TurnLimits limits() const { return TurnLimits(main, beside); }
  std::size_t faces() const { return bones.ball.faces.size() + bones.socket.faces.size(); }
};

// hip_presets.hpp's normal hip, and that of phantoms/phantom.hpp, of about so many faces each.
TurnedJoint generated_hip(std::size_t faces);
TurnedJoint replaced_hip(std::size_t faces);

// A ball with a thin pyramid, which turns in twelve directions past the tip of a spike each, sharper and in
// the plane of the turn. The spikes are nearer than the top of the needle by 5 to 0.05 mm: the pyramid passes
// them in 6 to 0.05 degrees, and comes to the rim of the cup 40 degrees and more later. (At the first
// contact the tip is in an edge of the pyramid.)
TurnedJoint needle_past_spikes();

// The joints of a folder (harness/real_joints.hpp) that have a whole femur.ply and pelvis.ply beside their
// cut surfaces, about the centre of the sphere that fits the head.
std::vector<TurnedJoint> whole_joints(const std::filesystem::path& folder, Progress& progress);

// How much is timed.
struct LimitPlan {
  std::vector<double> steps_deg;      // of a library
  std::vector<double> few_steps_deg;  // of a slow one (ContactCase::few)
  std::size_t motions = 12;           // that libraries are asked for: the first so many
  std::size_t few_motions = 12;       // that slow ones are
  int rounds = 1;
  int few_rounds = 1;  // of slow ones
  TimingOptions timing;
};
LimitPlan limit_plan(bool quick);

// What is written, and the labels of the methods.
struct LimitTimes {
  Table table;
  TimingRun timing;
  std::map<std::string, std::string> labels;
};
LimitTimes empty_limit_times();         // no rows yet
std::vector<Column> limit_time_keys();  // its first columns: joint, faces, method, step_deg

// Adds the rows of a joint. The truth of a motion is the smallest angle at which any method finds contact and
// CGAL a common point of the surfaces, exactly. std::runtime_error where that is before the lower end of
// ours, or no common point is where ours says that there is contact. Motions that begin in contact are left
// out; none of the joint where all do.
void add_limit_times(const TurnedJoint& joint, const LimitPlan& plan, LimitTimes& found, Progress& progress);

}  // namespace impinge::lab
