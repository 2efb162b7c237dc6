// SPDX-License-Identifier: GPL-3.0-or-later
#include "17_limit_time/touch_times.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>

#include "hip/named_motion.hpp"
#include "limits/body_pairs.hpp"
#include "methods/cgal.hpp"
#include "methods/contact.hpp"

namespace impinge::lab {
namespace {

using BodyContact = impinge::Contact;

constexpr const char* kBodies = "body_pairs";
constexpr const char* kPeer = "fcl_collide";  // rates are given relative to it
constexpr std::size_t kMostDraws = 30;        // poses that are drawn for each one that is wanted
constexpr double kNearRest = 60.0;            // degrees
constexpr double kNearLimit = 2.0;            // degrees

Pose turned(const Eigen::Matrix3d& rotation) {
  Pose pose;
  pose.rotation = rotation;
  return pose;
}

// Draws a pose.
using Draw = std::function<Pose(std::mt19937_64&)>;

Vec3 random_axis(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  return Vec3(normal(engine), normal(engine), normal(engine)).normalized();
}

Pose any_rotation(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  Eigen::Quaterniond q(normal(engine), normal(engine), normal(engine), normal(engine));
  return turned(q.normalized().toRotationMatrix());
}

Draw turned_by_up_to(double most_deg) {
  return [most_deg](std::mt19937_64& engine) {
    std::uniform_real_distribution<double> angle(0.0, most_deg * kDegree);
    return turned(Eigen::AngleAxisd(angle(engine), random_axis(engine)).toRotationMatrix());
  };
}

// Poses beside the limits of the named motions; empty if no motion has a limit.
Draw near_limits(const TurnedJoint& joint) {
  struct Limit {
    JointTurn turn;
    double deg;
  };
  std::vector<Limit> found;
  const TurnLimits limits = joint.limits();
  for (const NamedMotion& motion : named_motions()) {
    const MotionName& growing = motion_name(motion.growing);
    const JointTurn turn = joint_turn(motion.start, growing, joint.side);
    const TurnLimit limit = limits.first_contact(turn, largest_growth(motion.start, growing));
    if (limit.state == LimitState::limited) found.push_back({turn, limit.high_deg});
  }
  if (found.empty()) return {};
  return [found](std::mt19937_64& engine) {
    const Limit& at = found[std::uniform_int_distribution<std::size_t>(0, found.size() - 1)(engine)];
    const double deg = at.deg + std::uniform_real_distribution<double>(-kNearLimit, kNearLimit)(engine);
    return turned(at.turn.outer * Eigen::AngleAxisd(deg * kDegree, at.turn.axis).toRotationMatrix() *
                  at.turn.inner);
  };
}

// The answer of BodyPairs; throws if it is wrong about the surfaces.
bool ours_touches(const BodyPairs& bodies, const Pose& pose) {
  return bodies.verdict(pose).contact == BodyContact::yes;
}

void hold(const TurnedJoint& joint, const BodyPairs& bodies, const Pose& pose, bool surfaces_meet) {
  const BodyPairs::Verdict said = bodies.verdict(pose);
  const bool by_surfaces = said.contact == BodyContact::yes && said.rule == ContactRule::surfaces;
  if (surfaces_meet ? said.contact == BodyContact::no : by_surfaces)
    throw std::runtime_error(joint.name + ": the exact test contradicts that of the bodies");
}

// Poses of one kind, by whether the surfaces meet.
struct Sorted {
  std::vector<Pose> touching;
  std::vector<Pose> clear;
};

Sorted sorted(const TurnedJoint& joint, const BodyPairs& bodies, const Touch& exact, const Draw& draw,
              const TouchPlan& plan) {
  std::mt19937_64 engine(plan.seed + 17);
  Sorted poses;
  for (std::size_t k = 0; k < kMostDraws * plan.poses; ++k) {
    if (std::min(poses.touching.size(), poses.clear.size()) >= plan.poses) break;
    const Pose pose = draw(engine);
    const bool meet = exact(pose);
    hold(joint, bodies, pose, meet);
    std::vector<Pose>& kept = meet ? poses.touching : poses.clear;
    if (kept.size() < plan.poses) kept.push_back(pose);
  }
  return poses;
}

struct Asked {
  std::string name;
  Touch touches;
};

std::vector<Asked> methods_of(const TurnedJoint& joint, const std::shared_ptr<const BodyPairs>& bodies,
                              LimitTimes& found) {
  std::vector<Asked> all{{kBodies, [bodies](const Pose& pose) { return ours_touches(*bodies, pose); }}};
  std::vector<ContactCase> cases = cases_of(steps_methods(), &Method::steps, joint.bones);
  std::erase_if(cases, [](const ContactCase& one) { return one.few; });
  add_labels(found.labels, cases);
  for (const ContactCase& one : cases) all.push_back({one.name, one.make().touches});
  return all;
}

// Times the methods in the poses of one kind and state.
void add_state(const TurnedJoint& joint, const std::vector<Asked>& methods, const std::string& kind,
               bool touching, const std::vector<Pose>& poses, const TouchPlan& plan,
               std::vector<TimedCase>& cases, std::vector<std::size_t>& otherwise) {
  if (poses.empty()) return;
  for (const Asked& method : methods) {
    otherwise.push_back(static_cast<std::size_t>(
        std::ranges::count_if(poses, [&](const Pose& pose) { return method.touches(pose) != touching; })));
    TimedCase timed;
    timed.key = {joint.name, joint.faces(), kind, touching ? "touching" : "clear", method.name};
    timed.run = [&poses, touches = method.touches] {
      for (const Pose& pose : poses) benchmark::DoNotOptimize(touches(pose));
    };
    timed.units = static_cast<double>(poses.size());
    timed.rounds = plan.rounds;
    cases.push_back(std::move(timed));
  }
}

void add_rows(const TimingRun& run, const std::vector<TimedCase>& cases,
              const std::vector<std::size_t>& otherwise, Table& table) {
  for (std::size_t k = 0; k < cases.size(); ++k) {
    std::vector<Cell> peer = cases[k].key;
    peer.back() = kPeer;
    const Timing& timing = run.timings[k];
    std::vector<Cell> row = timing.key;
    row.insert(row.end(), {static_cast<std::size_t>(cases[k].units), otherwise[k],
                           find(run, peer).summary.median / timing.summary.median, timing.summary.median,
                           timing.summary.iqr, timing.summary.count, timing.inconclusive});
    table.add_row(std::move(row));
  }
}

}  // namespace

std::vector<Column> touch_time_keys() {
  return {
      {"joint", "", "a generated hip, a replaced one, or the folder of a real joint whose bones are whole"},
      {"faces", "1", "of ball and socket together"},
      {"poses", "", "how they were drawn: any rotation, by up to 60 degrees, or near a limit of a motion"},
      {"state", "", "of the surfaces in all of them, by CGAL's exact signs"},
      {"method", "", "body_pairs: ours (limits/body_pairs.hpp), of the joint as the program takes it"}};
}

LimitTimes empty_touch_times() {
  LimitTimes found;
  found.labels = {{kBodies, "ours"}};
  found.table.columns = touch_time_keys();
  found.table.columns.insert(
      found.table.columns.end(),
      {{"count", "1", "poses"},
       {"otherwise", "1",
        "of these, in which it says the other; ours too counts what is inside a bone, or in a sheet beyond "
        "its "
        "radii, as contact"},
       {"rate_over_fcl", "1", "poses a second over those of FCL's oriented boxes, same round"},
       {"median_ms", "ms", "of a pose, median over the rounds, wall clock"},
       {"iqr_ms", "ms", "interquartile range of it"},
       {"rounds", "1", "rounds measured"},
       {"inconclusive", "", "yes: the spread or that of the control of its run is too large"}});
  return found;
}

void add_touch_times(const TurnedJoint& joint, const TouchPlan& plan, const TimingOptions& timing,
                     LimitTimes& found, Progress& progress) {
  const auto bodies = std::make_shared<const BodyPairs>(joint.main, joint.beside);
  const Touch exact = make_cgal_tree(joint.bones.ball, joint.bones.socket);
  const std::vector<Asked> methods = methods_of(joint, bodies, found);
  const std::vector<std::pair<std::string, Draw>> kinds{{"any rotation", any_rotation},
                                                        {"by up to 60 degrees", turned_by_up_to(kNearRest)},
                                                        {"near a limit", near_limits(joint)}};
  std::vector<Sorted> poses;
  poses.reserve(kinds.size());
  for (const auto& [kind, draw] : kinds)
    poses.push_back(draw ? sorted(joint, *bodies, exact, draw, plan) : Sorted{});
  std::vector<TimedCase> cases;
  std::vector<std::size_t> otherwise;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    add_state(joint, methods, kinds[k].first, true, poses[k].touching, plan, cases, otherwise);
    add_state(joint, methods, kinds[k].first, false, poses[k].clear, plan, cases, otherwise);
  }
  TimingRun run = run_interleaved(cases, timing, progress);
  add_rows(run, cases, otherwise, found.table);
  append(found.timing, std::move(run));
}

}  // namespace impinge::lab
