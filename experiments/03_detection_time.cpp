// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does it take to decide whether ball and socket touch in a pose? (Tables 4 and 9)
// @writes    detection_time detection_time_samples detection_time_precision detection_time_precision_samples
// @writes-with-bones  detection_time_bones detection_time_bones_samples
// @timing    yes
// @seconds   60 260
// @links     study_detection scene
//
// The generated pair, and real joints when they are given. A time is the mean over the six poses of
// pose_set.hpp.

#include <array>
#include <limits>

#include "experiment/timing_report.hpp"
#include "scene/real_joints.hpp"
#include "studies/detection_timing.hpp"

namespace {

using namespace impinge;

constexpr std::array<std::size_t, 4> kLevels{300, 1000, 3000, 12000};  // triangles of each model
constexpr std::array<std::size_t, 2> kPrecisionLevels{3000, 12000};  // of the file that varies the precision
constexpr std::array kPrecisions{1.0, 0.5, 0.1, 0.05};               // degrees
// Of the tables in Tables 4 and 9. The thesis does not say which one it took; its time grows faster than the
// triangles, as it does when the tables are larger than the cache.
constexpr double kPrecision = 0.1;
constexpr double kMostPairsInQuick = 1e7;  // 3,000 triangles against 3,000, not 12,000 against 12,000

const Column kMethod{"method", "", "pairwise triangles, OBB trees of FCL, or two scans of the tables"};
const Column kTriangles{"triangles", "1", "triangles of each model"};

Result make_result(const char* name, const char* question) {
  Result result;
  result.name = name;
  result.question = question;
  result.parameters = {
      {"poses",
       "clear, near (gap at most 0.5 mm) and touching (at most -0.5 mm), each also turned by 10 degrees"},
      {"time",
       "mean over the six poses; pairwise stops at the first pair that meets, a scan computes every gap"},
      {"precision_deg", kPrecision},
      {"extrapolation", "pairwise beyond 1e7 pairs of triangles in the quick profile, by pairs"}};
  return result;
}

// A scan looks up each vertex of both models once: its time divided by their number is that of one query.
double race_generated(DriverRun& run, DetectionRaceOptions options) {
  Result result = make_result("detection_time", "How long does a pose of the generated pair take?");
  std::vector<RaceJoint> joints;
  joints.reserve(kLevels.size());
  for (const std::size_t n : kLevels) {
    const BallSocketPair pair = make_ball_socket_pair(n);
    joints.push_back(make_race_joint({}, pair, {n}, kPrecision));
    result.parameters["queries"][std::to_string(n)] = pair.ball.vertices.size() + pair.socket.vertices.size();
  }
  return write_race(run, result, {kMethod, kTriangles}, joints, options);
}

void race_real(DriverRun& run, DetectionRaceOptions options) {
  std::vector<RaceJoint> joints;
  for (const RealJoint& joint : read_real_joints(*run.bones, run.progress)) {
    const BallSocketPair& pair = joint.meshes;
    joints.push_back(make_race_joint({joint.subject}, pair,
                                     {pair.ball.faces.size(), pair.socket.faces.size()}, kPrecision));
  }
  const std::vector<Column> keys{{"subject", "", "folder of the joint"},
                                 kMethod,
                                 {"ball_triangles", "1", "triangles of the ball"},
                                 {"socket_triangles", "1", "triangles of the socket"}};
  write_race(run, make_result("detection_time_bones", "How long does a pose of a real joint take?"), keys,
             joints, options);
}

// The scans alone, with tables of every precision.
void vary_precision(DriverRun& run) {
  Result result =
      make_result("detection_time_precision", "How does the size of the tables change the time of a scan?");
  result.parameters.erase("precision_deg");
  const std::vector<Column> keys{kMethod, {"precision_deg", "deg", "of the tables"}, kTriangles};
  result.table.columns = timing_columns(keys);
  std::vector<DetectionRace> races;
  races.reserve(kPrecisions.size() * kPrecisionLevels.size());  // the cases refer to them
  std::vector<TimedCase> cases;
  for (const std::size_t n : kPrecisionLevels) {
    for (const double precision : kPrecisions) {
      races.push_back(make_detection_race(make_ball_socket_pair(n), precision));
      for (const auto& contender : races.back().contenders) {
        if (!contender->gives_distance()) continue;
        cases.push_back(race_case({contender->name(), precision, n}, *contender, races.back()));
      }
    }
  }
  const TimingRun timed = run_interleaved(cases, {}, run.progress);
  for (const Timing& timing : timed.timings) result.table.add_row(timing_cells(timing));
  write_timed(run, std::move(result), keys, timed);
}

void body(DriverRun& run) {
  DetectionRaceOptions options;
  options.most_pairs = run.quick() ? kMostPairsInQuick : std::numeric_limits<double>::infinity();
  options.pair_ms = race_generated(run, options);
  if (run.bones) race_real(run, options);
  vary_precision(run);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::run_driver(
      argc, argv, {"03_detection_time", "Time to test a pose (Tables 4, 9).", /*takes_bones=*/true}, body);
}
