// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does it take to decide whether ball and socket touch in a pose? (Tables 4 and 9)
// @writes    detection_time detection_time_samples
// @bones     yes
// @timing    yes
// @seconds   54 330
// @links     harness real_joints methods touch_methods hip
//
// Tables 4 and 9 have "generic models" of up to 3,000 triangles (here the generated pair) and the "real model
// from CT" of a patient with 12,000, which is not public. Three joints replace it: the generated pair and the
// generated stand-in for the patient (hip/hip_presets.hpp), with 12,000 triangles on both surfaces, and the
// given real joint with the nearest numbers of triangles. A time is the mean over six poses (pose_set.hpp).

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "03_detection_time/detection_timing.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array<std::size_t, 3> kLevels{300, 1000, 3000};  // triangles of each generic model
constexpr std::size_t kHipLevel = 12000;                        // of each model of the patient
constexpr const char* kPatient = "patient_a";                   // stand-in for the patient
// Precision of the tables in Tables 4 and 9. The thesis does not state it; its time grows faster than the
// number of triangles, as it does when tables are larger than the cache.
constexpr double kPrecision = 0.1;
constexpr double kMostPairsInQuick = 1e7;  // pairs: 3,000 triangles against 3,000, not 12,000 against 12,000

const Column kMethod{"method", "", "pairwise triangles, OBB trees of FCL, or two scans of the tables"};
const Column kTriangles{"triangles", "1",
                        "of each model, as the thesis says it; of a real joint about so many"};

Result make_result() {
  Result result{"detection_time", "How long does a pose take?"};
  result.parameters = {
      {"poses",
       "clear, near (gap at most 0.5 mm) and touching (at most -0.5 mm), each also turned by 10 degrees"},
      {"time",
       "mean over the six poses; pairwise stops at the first pair that meets, a scan computes every gap"},
      {"precision_deg", kPrecision},
      {"extrapolation", "pairwise beyond 1e7 pairs of triangles in the quick profile, by pairs"}};
  return result;
}

// How far the numbers of triangles are from those of the patient's models, as a sum of logarithms.
double off_level(const RealJoint& joint) {
  const auto off = [](const TriangleMesh& mesh) {
    return std::abs(std::log(static_cast<double>(mesh.faces.size()) / static_cast<double>(kHipLevel)));
  };
  return off(joint.meshes.ball) + off(joint.meshes.socket);
}

// A scan looks up each vertex of both models once. Its time divided by their number is the time of one query.
void body(DriverRun& run) {
  std::vector<BenchmarkJoint> joints;
  const auto add = [&](const BallSocketPair& pair, std::size_t level, const std::string& joint) {
    joints.push_back(make_benchmark_joint(pair, {level, joint}, kPrecision));
  };
  for (const std::size_t n : kLevels) add(make_ball_socket_pair(n), n, "generated");
  add(make_ball_socket_pair(kHipLevel), kHipLevel, "generated");
  Hip hip = make_hip(hip_preset(kPatient), kHipLevel);
  add({std::move(hip.ball), std::move(hip.socket)}, kHipLevel, kPatient);
  if (run.bones) {
    const std::vector<RealJoint> real = read_real_joints(*run.bones, run.progress);
    const auto nearest = std::ranges::min_element(real, {}, off_level);
    if (nearest != real.end()) add(nearest->meshes, kHipLevel, nearest->subject);
  }
  const Column joint{"joint", "", "generated: a ball and a socket; else a hip in the patient's place"};
  write_benchmark(run, make_result(), {kMethod, kTriangles, joint}, joints,
                  {.most_pairs = run.quick() ? kMostPairsInQuick : std::numeric_limits<double>::infinity()});
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"03_detection_time", "Time to test a pose (Tables 4, 9).", /*takes_bones=*/true}, body);
}
