// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does it take to know all free rotations, compared with asking pose after pose?
// @writes    motion_volume motion_volume_methods motion_volume_rotations
// @bones     yes
// @timing    yes
// @seconds   7 800
// @links     harness real_joints contact_methods 17_motion 17_limit_time
//
// For every generated hip and real joint, cropped and as whole bones: the share of all rotations that is free
// of contact, between proven ends, and the time until the ends are so close, with the time to prepare the
// joint. It is compared with a grid of poses as fine as the finest cells, by FCL, ODE and Bullet,
// extrapolated from random rotations; and with random rotations by our own test of a pose, which find the
// share soon but prove nothing. The cells also give internal rotation by flexion.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "17_limit_time/limit_times.hpp"
#include "17_motion/limit_study.hpp"
#include "files/csv.hpp"
#include "files/stopwatch.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "limits/turn_limit.hpp"
#include "methods/contact.hpp"
#include "rotations/volume.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

// A grid of poses that comes as near to every pose as the finest cells has as many poses as there are such
// cells, 4 * 8^level. No peer tests them all: it is timed on random rotations, and its time for the grid is
// extrapolated. Even then it would have tested points, and prove nothing between them.

// Sizes of the study.
struct VolumeStudyOptions {
  std::vector<double> widths;  // widths of the bracket, as shares of all rotations, the finest last
  std::size_t poses = 0;       // random rotations for a peer
  std::size_t few_poses = 0;   // random rotations for a slow peer
  std::size_t threads = 2;     // for the volume; peers have one
  std::uint64_t seed = 0;      // of the rotations
};

// The results of all joints.
struct VolumeTables {
  Table volumes;    // a row per joint and width
  Table methods;    // a row per joint and way to ask one pose after another
  Table rotations;  // internal rotation by flexion, a row per joint and flexion
};

// Of all ways to test a pose, those that only say whether it touches; others take longer.
constexpr std::array<std::string_view, 4> kAsked{"fcl_collide", "ode_collide", "bullet_collide", "culled"};
constexpr std::array kFlexions{70.0, 80.0, 90.0};  // degrees
constexpr double kSlack = 1e-6;                    // degrees, slack of angles read off cells
constexpr double kFinestWhole = 0.02;              // finest width for whole bones
constexpr double kMostRotation = 90.0;             // degrees of internal rotation that are looked at

std::uint32_t finest_level(const MotionVolume& volume) {
  std::uint32_t finest = 0;
  volume.for_each([&](const VolumeCell& at) { finest = std::max(finest, at.cell.level); });
  return finest;
}

// Angular radius of the largest cells, which are at the middle of a cube.
double covering_deg(std::uint32_t level) {
  return angular_radius(cell_of({1.0, 0.0, 0.0, 0.0}, level)) / kDegree;
}

// Times the volume to one width with a new test, and adds its row. Whole bones have main surfaces and a rest.
MotionVolume timed_volume(const StudiedJoint& joint, const BoneParts& beside,
                          const VolumeStudyOptions& options, double width, Table& table) {
  VolumeSettings settings;
  settings.width = width;
  settings.threads = options.threads;
  Stopwatch watch;
  const CellTest test(joint.meshes, {}, beside);
  const double build_s = watch.lap_s();
  MotionVolume volume(test, settings);
  const double search_s = watch.lap_s();
  const VolumeShares& found = volume.shares();
  const std::uint32_t level = finest_level(volume);
  const std::size_t faces = (beside.whole_ball ? *beside.whole_ball : joint.meshes.ball).faces.size();
  table.add_row({joint.name, faces, width, found.low(), found.high(), found.unknown, found.reachable_low,
                 found.reachable_high, found.cells, level, covering_deg(level), 4.0 * std::pow(8.0, level),
                 build_s, build_s + search_s});
  return volume;
}

std::vector<Quaternion4> random_rotations(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed + 25);
  std::normal_distribution<double> normal;
  std::vector<Quaternion4> all(count);
  for (Quaternion4& q : all)
    for (double& x : q) x = normal(engine);
  return all;
}

// Times a way to ask one pose after another, and compares its answers with the cells.
void add_method(const StudiedJoint& joint, const MotionVolume& volume, const ContactCase& method,
                const std::vector<Quaternion4>& rotations, Table& table) {
  const ContactQuery query = method.make();
  std::vector<bool> touches;
  touches.reserve(rotations.size());
  Stopwatch watch;
  for (const Quaternion4& q : rotations) touches.push_back(query.touches({rotation_of(q), Vec3::Zero()}));
  const double us_pose = 1e3 * watch.lap_ms() / static_cast<double>(rotations.size());
  std::size_t in_free = 0;
  std::size_t in_blocked = 0;
  for (std::size_t k = 0; k < rotations.size(); ++k) {
    const CellState state = volume.at(rotations[k]).state;
    if (state == CellState::free && touches[k]) ++in_free;
    if (state == CellState::blocked && !touches[k]) ++in_blocked;
  }
  if (method.contact == lab::Contact::vertices && in_free + in_blocked > 0)
    throw std::runtime_error(joint.name + ": " + std::to_string(in_free + in_blocked) +
                             " rotations are not what their cells say");
  const auto clear = std::ranges::count(touches, false);
  table.add_row({joint.name, method.name, method.label, rotations.size(), us_pose,
                 static_cast<double>(clear) / static_cast<double>(rotations.size()), in_free, in_blocked});
}

void add_methods(const StudiedJoint& joint, const MotionVolume& volume, const VolumeStudyOptions& options,
                 Table& table) {
  const std::vector<Quaternion4> many = random_rotations(options.poses, options.seed);
  const std::vector<Quaternion4> few(many.begin(),
                                     many.begin() + static_cast<std::ptrdiff_t>(options.few_poses));
  for (const ContactCase& method : cases_of(contact_methods(), &Method::contact, joint.meshes)) {
    if (std::ranges::find(kAsked, method.name) != kAsked.end())
      add_method(joint, volume, method, method.few ? few : many, table);
  }
}

void add_rotations(const StudiedJoint& joint, const MotionVolume& volume, Table& table) {
  const TurnLimits limits(joint.meshes);
  // On an open sheet, cells count radii that overlap, which may be before surfaces meet
  // (limits/body_pairs.hpp).
  const bool both = BodyPairs(joint.meshes, {}).has_inside();
  for (const double flexion : kFlexions) {
    const JointTurn turn = joint_turn({flexion, 0.0, 0.0}, motion_name("internal_rotation"), joint.side);
    const VolumeLimit cells = volume.limit(turn, kMostRotation);
    const TurnLimit exact = limits.first_contact(turn, kMostRotation);
    if (cells.low_deg > exact.high_deg + kSlack ||
        (both && cells.high_deg && *cells.high_deg < exact.low_deg - kSlack))
      throw std::runtime_error(joint.name + ": the cells and the turn contradict each other at flexion " +
                               std::to_string(flexion));
    table.add_row({joint.name, flexion, cells.low_deg, cells.high_deg ? Cell(*cells.high_deg) : Cell(),
                   name(exact.state), exact.low_deg, exact.high_deg});
  }
}

// The tables with columns and no rows.
VolumeTables make_volume_tables() {
  const Column joint{"joint", "", "name of a hip, or folder of a real joint"};
  return {
      {{joint,
        {"faces", "1", "of the ball; the socket has about as many"},
        {"width", "1", "that was asked for: of all rotations, the share that may stay open"},
        {"low", "1", "share of all rotations that is free, at least"},
        {"high", "1", "the same, at most"},
        {"unknown", "1", "share where the ball's mesh ends under the socket"},
        {"reachable_low", "1", "share that is joined to the pose of the scan, at least"},
        {"reachable_high", "1", "the same, at most"},
        {"cells", "1", "that were decided"},
        {"level", "1", "of the finest cells"},
        {"covering_deg", "degrees", "no rotation of the finest cells is farther from the middle of its own"},
        {"grid_poses", "1", "cells of that level: poses of a grid that leaves none farther"},
        {"build_s", "s", "to make the joint ready, wall clock"},
        {"time_s", "s", "in all"}},
       {}},
      {{joint,
        {"method", "", "that says whether a pose touches"},
        {"label", "", "what a reader calls it"},
        {"poses", "1", "random rotations that it was asked in"},
        {"us_pose", "us", "of one thread, mean"},
        {"clear_share", "1", "of these, without contact"},
        {"touching_in_free", "1", "of these, said to touch in a cell that is free"},
        {"clear_in_blocked", "1", "of these, said to be clear in a cell that is blocked"}},
       {}},
      {{joint,
        {"flexion_deg", "degrees", "at which internal rotation grows"},
        {"cells_low_deg", "degrees", "it is free up to here, by the cells of the finest volume"},
        {"cells_high_deg", "degrees", "and blocked here; empty where no cell on the way is"},
        {"state", "", "of the limit by closed forms (17_motion)"},
        {"low_deg", "degrees", "that limit, at least"},
        {"high_deg", "degrees", "at most"}},
       {}}};
}

// Adds the rows of a joint; with `peers` also those of asking pose after pose. Throws std::runtime_error if
// the library's own test of a pose contradicts a cell, since a time would then mean nothing.
void add_volume(const StudiedJoint& joint, const VolumeStudyOptions& options, bool peers,
                VolumeTables& tables) {
  std::unique_ptr<const MotionVolume> finest;
  for (const double width : options.widths)
    finest = std::make_unique<const MotionVolume>(timed_volume(joint, {}, options, width, tables.volumes));
  if (peers) add_methods(joint, *finest, options, tables.methods);
  if (joint.side) add_rotations(joint, *finest, tables.rotations);
}

// Adds the rows of whole bones. A peer must agree with every cell in random rotations.
void add_whole_bones(const TurnedJoint& bones, const VolumeStudyOptions& options, Table& table) {
  const StudiedJoint joint{bones.name + " whole", bones.main, bones.side};
  std::unique_ptr<const MotionVolume> finest;
  for (const double width : options.widths)
    if (width >= kFinestWhole)
      finest = std::make_unique<const MotionVolume>(timed_volume(joint, bones.beside, options, width, table));
  for (const ContactCase& method : cases_of(contact_methods(), &Method::contact, bones.bones)) {
    if (method.name != kAsked.front()) continue;
    const ContactQuery query = method.make();
    for (const Quaternion4& q : random_rotations(options.few_poses, options.seed)) {
      const CellState state = finest->at(q).state;
      const bool decided = state == CellState::free || state == CellState::blocked;
      if (decided && query.touches({rotation_of(q), Vec3::Zero()}) != (state == CellState::blocked))
        throw std::runtime_error(joint.name + ": a rotation is not what its cell says, by " + method.label);
    }
  }
}

void body(DriverRun& run) {
  VolumeStudyOptions options;
  options.widths = {0.2, 0.1, 0.05};
  if (!run.quick()) options.widths.insert(options.widths.end(), {0.02, 0.01});
  options.poses = run.quick() ? 5000 : 100000;
  options.few_poses = run.quick() ? 500 : 100000;
  options.seed = run.record.seed;
  VolumeTables tables = make_volume_tables();
  for (const std::string_view preset : hip_preset_names()) {
    const HipParameters parameters = hip_preset(preset);
    Hip hip = make_hip(parameters, kHipFaces);
    const bool peers = preset == hip_preset_names().front();
    if (run.quick() && !peers) options.widths = {0.1};
    add_volume({std::string(preset), {std::move(hip.ball), std::move(hip.socket)}, parameters.side}, options,
               peers, tables);
    run.progress.say("motion volume of " + std::string(preset));
  }
  if (run.bones) {
    for (const RealJoint& joint : read_real_joints(*run.bones, run.progress)) {
      add_volume({joint.subject, in_joint_frame(joint), joint.side}, options, /*peers=*/false, tables);
      run.progress.say("motion volume of " + joint.subject);
    }
    for (const TurnedJoint& bones : whole_joints(*run.bones, run.progress)) {
      add_whole_bones(bones, options, tables.volumes);
      run.progress.say("motion volume of " + bones.name + " whole");
    }
  }
  const nlohmann::json parameters = {
      {"faces", kHipFaces}, {"threads", options.threads}, {"threads_of_peers", 1}, {"gap_mm", 0.0}};
  run.write({"motion_volume",
             "Which share of all rotations is free, between which ends, and after which time?",
             std::move(tables.volumes), parameters});
  run.write({"motion_volume_methods", "How long does a pose take that is asked by itself?",
             std::move(tables.methods), parameters});
  run.write({"motion_volume_rotations", "How does internal rotation depend on flexion?",
             std::move(tables.rotations), parameters});
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"25_volume", "All rotations of a joint at once.", /*takes_bones=*/true}, body);
}
