// SPDX-License-Identifier: GPL-3.0-or-later
// What each omission of a scene saves, and whether the answer stays the same.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "files/csv.hpp"
#include "harness/timing.hpp"
#include "session/scene_answer.hpp"

namespace impinge::lab {

// A joint and what is asked about it.
struct NeedsScene {
  std::string name;                             // in the results
  std::shared_ptr<const BallSocketPair> joint;  // centre frames, mm
  SceneNeeds needs;                             // what is asked
};

// What everything is done with, and how often it is timed.
struct NeedsOptions {
  double precision_deg = 0.1;  // of the RSID tables that everything is done with
  int rounds = 5;              // of each case
};

// One way to do the work of a scene.
struct NeedsCase {
  std::string scene;           // its name
  std::string left_out;        // the omission that is on, "nothing" or "all"
  std::function<void()> run;   // what is timed
  double bytes = 0.0;          // of memory, of one run
  bool identical = true;       // its answer to that of the case that leaves nothing out, see cases_of()
  double difference_mm = 0.0;  // largest, of a gap, from the answer it is compared with
};

// The questions of one joint that turns about the axis: all gaps in one pose, the smallest gap in it, touch
// along a motion there and back, all gaps along the motion within an accuracy.
std::vector<NeedsScene> scenes_of(const std::string& name, const BallSocketPair& joint, const Vec3& axis);

// Cases of a scene: nothing left out first, then one omission after the other by itself, then all together.
// Answers are compared here, before anything is timed: bit for bit, and with an accuracy against the exact
// gap of every vertex.
std::vector<NeedsCase> cases_of(const NeedsScene& scene, const NeedsOptions& options);

// Outputs that a scene of one pose may leave out, each a case of its own: bounds of all gaps, Euclidean
// distances, exact verdicts.
std::vector<NeedsCase> outputs_of(const NeedsScene& scene, const NeedsOptions& options);

// A part of the ball, a cap of 10 degrees about its first vertex, moves in and out again by up to 0.5 mm: the
// table is filled anew ("nothing"), or only where the part is ("all").
std::vector<NeedsCase> local_change_of(const std::string& name, const BallSocketPair& joint,
                                       const NeedsOptions& options);

// The rotations without contact, as 16,384 cells of one size: each is decided ("nothing"), or only the parts
// of cells that were still open ("all"), as a motion volume does. The answers are the same if no cell is free
// in one and blocked in the other. The joint must outlive the cases.
std::vector<NeedsCase> motion_volume_of(const std::string& name, const BallSocketPair& joint);

// Times all cases and makes scene_needs.csv, and scene_needs_totals.csv of every scene's everything beside
// its plan. The outputs of a joint count as part of everything in its scenes of one pose.
struct NeedsTables {
  Table needs;       // scene_needs.csv
  Table totals;      // scene_needs_totals.csv
  TimingRun timing;  // of all cases
};
// Those tables, of the cases of all scenes.
NeedsTables time_needs(const std::vector<NeedsCase>& cases, const NeedsOptions& options, Progress& progress);

}  // namespace impinge::lab
