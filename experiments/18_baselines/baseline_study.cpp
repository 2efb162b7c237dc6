// SPDX-License-Identifier: GPL-3.0-or-later
#include "18_baselines/baseline_study.hpp"

#include <algorithm>
#include <utility>

#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kPosesTimed = 14;

// A joint with its methods, which refer to it.
struct Prepared {
  const BaselineJoint* joint = nullptr;
  std::vector<BaselinePose> poses;
  std::vector<BaselineCase> methods;
  std::vector<BaselineAnswers> answers;
  std::vector<BaselineVerdicts> verdicts;
};

Prepared prepare(const BaselineJoint& joint, Progress& progress) {
  Prepared prepared;
  prepared.joint = &joint;
  prepared.poses = baseline_poses(joint.meshes, joint.ways);
  prepared.methods = cases_of(baseline_methods(), &Method::baseline, joint.meshes, joint.sizes);
  const BaselinePoints points = baseline_points(joint.meshes, joint.points);
  for (const BaselineCase& method : prepared.methods) {
    prepared.answers.push_back(ask(method, points));
    prepared.verdicts.push_back(judge(method.touches, prepared.poses));
  }
  progress.say("judged " + std::to_string(prepared.poses.size()) + " poses of " + joint.name);
  return prepared;
}

std::vector<Cell> key_of(const Prepared& prepared, const BaselineCase& method, const char* step) {
  return {prepared.joint->name, method.name, method.setting, step};
}

TimedCase build_case(const Prepared& prepared, const BaselineCase& method, const BaselineOptions& options) {
  TimedCase timed;
  timed.key = key_of(prepared, method, "build");
  timed.run = method.build;
  timed.rounds = options.build_rounds;
  Stopwatch watch;
  method.build();
  const double seconds = watch.lap_s();
  if (seconds > options.slow_s) {
    timed.expected_s = seconds;
    timed.rounds = 1;
  }
  return timed;
}

TimedCase pose_case(const Prepared& prepared, const BaselineCase& method, const BaselineOptions& options) {
  TimedCase timed;
  timed.key = key_of(prepared, method, "pose");
  const std::size_t count = std::min(kPosesTimed, prepared.poses.size());
  timed.units = static_cast<double>(count);
  timed.rounds = options.pose_rounds;
  timed.run = [&poses = prepared.poses, &method, count] {
    for (std::size_t i = 0; i < count; ++i) benchmark::DoNotOptimize(method.touches(poses[i].pose));
  };
  return timed;
}

std::vector<TimedCase> cases_of(const std::vector<Prepared>& all, const BaselineOptions& options) {
  std::vector<TimedCase> cases;
  for (const Prepared& prepared : all) {
    for (const BaselineCase& method : prepared.methods) {
      if (method.build) cases.push_back(build_case(prepared, method, options));
      if (!prepared.poses.empty()) cases.push_back(pose_case(prepared, method, options));
    }
  }
  return cases;
}

// Median and IQR of the building time, ms. For sizes that are not timed, it is scaled by the work from the
// largest size that is.
struct BuildTime {
  Cell median;
  Cell iqr;
  bool extrapolated = false;
};

BuildTime build_time(const TimingRun& timing, const Prepared& prepared, const BaselineCase& method) {
  if (method.build) {
    const Summary summary = find(timing, key_of(prepared, method, "build")).summary;
    return {summary.median, summary.iqr, false};
  }
  const BaselineCase* largest = nullptr;
  for (const BaselineCase& other : prepared.methods) {
    if (other.name == method.name && other.build && (!largest || other.work > largest->work))
      largest = &other;
  }
  if (!largest) return {Cell(), Cell(), true};
  const Summary summary = find(timing, key_of(prepared, *largest, "build")).summary;
  return {summary.median * method.work / largest->work, Cell(), true};
}

std::vector<Cell> row_of(const TimingRun& timing, const Prepared& prepared, std::size_t m) {
  const BaselineCase& method = prepared.methods[m];
  const BaselineVerdicts& verdicts = prepared.verdicts[m];
  const BuildTime build = build_time(timing, prepared, method);
  Cell pose_us;
  Cell pose_iqr_us;
  if (!prepared.poses.empty()) {
    const Summary pose = find(timing, key_of(prepared, method, "pose")).summary;
    pose_us = 1e3 * pose.median;
    pose_iqr_us = 1e3 * pose.iqr;
  }
  const BaselineAnswers& answers = prepared.answers[m];
  const bool asked = answers.points > 0;
  return {prepared.joint->name,
          method.name,
          method.setting,
          method.size,
          method.bytes,
          build.median,
          build.iqr,
          build.extrapolated,
          pose_us,
          pose_iqr_us,
          prepared.joint->meshes.ball.faces.size(),
          method.missed_faces,
          asked ? Cell(answers.points) : Cell(),
          asked ? Cell(answers.missed) : Cell(),
          answers.largest_mm,
          answers.rms_mm,
          prepared.poses.size(),
          verdicts.false_touches,
          verdicts.missed_touches,
          verdicts.wrong_within_mm,
          method.gives_distance};
}

}  // namespace

BaselineAnswers ask(const BaselineCase& method, const BaselinePoints& points) {
  if (!method.radius && !method.distance) return {};
  const std::vector<double>& exact = method.radius ? points.radius : points.distance;
  std::vector<double> answers;
  for (const Vec3& x : method.radius ? points.on_socket : points.on_ball) {
    answers.push_back(method.radius ? method.radius(x) : method.distance(x));
    if (answers.back() > exact[answers.size() - 1] + method.slack_mm)
      broken(method.name, "an answer exceeds the exact one by more than is proven");
  }
  return judge_answers(answers, exact);
}

BaselineTables baseline_tables(const std::vector<BaselineJoint>& joints, const BaselineOptions& options,
                               Progress& progress) {
  std::vector<Prepared> all;
  all.reserve(joints.size());
  BaselineTables tables;
  for (const BaselineJoint& joint : joints) {
    all.push_back(prepare(joint, progress));
    add_labels(tables.labels, all.back().methods);
  }
  tables.timing = run_interleaved(cases_of(all, options), {}, progress);
  tables.table.columns = baseline_columns();
  for (const Prepared& prepared : all) {
    for (std::size_t m = 0; m < prepared.methods.size(); ++m)
      tables.table.add_row(row_of(tables.timing, prepared, m));
  }
  return tables;
}

std::vector<Column> baseline_columns() {
  return {
      {"joint", "", "generated, or the folder of a real joint"},
      {"method", "", "hu_voxels, maciel_triangles, cartesian_field, or rsid, the thesis' own"},
      {"setting", "", "its resolution, with unit"},
      {"size", "", "the number in the setting"},
      {"bytes", "B", "kept to answer"},
      {"build_ms", "ms", "median time of everything done once for the joint"},
      {"build_iqr_ms", "ms", "interquartile range; empty when extrapolated"},
      {"build_extrapolated", "", "yes: scaled by rays times faces from the largest size that was timed"},
      {"pose_us", "us", "median time of a pose, mean over the poses round a contact"},
      {"pose_iqr_us", "us", "interquartile range"},
      {"faces", "1", "triangles of the ball"},
      {"faces_missed", "1", "of them, without an entry of the table; empty where there is none by direction"},
      {"points", "1", "vertices that the other surface is exactly known for"},
      {"points_missed", "1", "of them, without an answer"},
      {"largest_error_mm", "mm", "of the answers: radius of the ball, or distance from the socket"},
      {"rms_error_mm", "mm", "root mean square of the same"},
      {"poses", "1", "on either side of a first contact, 0.05 to 4 mm of way from it"},
      {"false_touches", "1", "poses said to touch that are free"},
      {"missed_touches", "1", "poses said to be free that touch"},
      {"wrong_within_mm", "mm", "largest way from the contact with a wrong answer"},
      {"gives_distance", "", "yes: the work also yields distances everywhere"}};
}

std::vector<Column> baseline_keys() {
  return {{"joint", "", "generated, or the folder of a real joint"},
          {"method", "", "of detection"},
          {"setting", "", "its resolution"},
          {"step", "", "build: done once; pose: one pose"}};
}

}  // namespace impinge::lab
