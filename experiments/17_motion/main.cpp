// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How far does a joint turn before its bones touch, and where do they?
// @writes    motion_limits motion_limit_details phantoms
// @bones     yes
// @timing    no
// @seconds   12 70
// @links     harness real_joints change phantoms
//
// Covers every named motion of every generated hip and real joint. A bracket of the angle of first contact,
// over which no step can jump (limits/turn_limit.hpp), is found about the centre of the head and about the
// socket's; then a bracket of the angle at which gaps fall to a threshold, and the interval that holds for
// every centre within half a millimetre (limits/centre_interval.hpp). Table 11 is replayed on stand-ins.

#include <cmath>
#include <stdexcept>

#include "17_motion/limit_study.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kFacesInQuick = 3000;
const std::vector<double> kGaps{0.5, 2.0};  // mm; the thesis' red is below 2 (Section 5.2)

StudiedJoint generated(std::string_view name, std::size_t faces) {
  const HipParameters parameters = hip_preset(name);
  Hip hip = make_hip(parameters, faces);
  return {std::string(name), {std::move(hip.ball), std::move(hip.socket)}, parameters.side};
}

void write_limits(DriverRun& run, std::size_t faces) {
  std::vector<LimitCase> cases;
  const auto add = [&](const StudiedJoint& joint) {
    const std::vector<LimitCase> more = limits_of(joint, kGaps);
    cases.insert(cases.end(), more.begin(), more.end());
    run.progress.say("limits of " + joint.name);
  };
  for (const std::string_view name : hip_preset_names()) add(generated(name, faces));
  if (run.bones) {
    for (const RealJoint& joint : read_real_joints(*run.bones, run.progress))
      add({joint.subject, in_joint_frame(joint), joint.side});
  }
  Result result{"motion_limits",
                "How far does each joint turn about the centre of its head until the surfaces touch?",
                limit_table(cases)};
  result.parameters = {{"faces_of_the_generated_models", faces},
                       {"largest_angle_deg", kLargestAngle},
                       {"input_error_mm", kErrorOfInput}};
  run.write(result);
  result.name = "motion_limit_details";
  result.question = "How does the limit depend on the centre, the threshold and the input?";
  result.table = limit_detail_table(cases);
  run.write(result);
}

void write_phantoms(DriverRun& run) {
  std::vector<PhantomRow> rows = phantom_limits();
  const std::vector<PhantomRow> gaps = phantom_gaps();
  rows.insert(rows.end(), gaps.begin(), gaps.end());
  Result result{"phantoms", "Do limits and gaps of joints with closed forms come out?", phantom_table(rows)};
  for (const PhantomRow& row : rows) {
    if (std::abs(row.error) > row.allowed)
      throw std::runtime_error(row.phantom + ", " + row.quantity + ": the error is " +
                               std::to_string(row.error) + ", above " + std::to_string(row.allowed));
  }
  run.write(result);
}

void body(DriverRun& run) {
  write_phantoms(run);
  write_limits(run, run.quick() ? kFacesInQuick : kHipFaces);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"17_motion", "How far joints turn before their bones touch.", /*takes_bones=*/true}, body);
}
