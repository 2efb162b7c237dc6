// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How much of a cam must be cut so that a hip reaches a required motion?
// @writes    resection_by_cam
// @timing    no
// @seconds   3 40
// @links     harness joint
//
// Hips with cams of several heights must reach 30 degrees of internal rotation at 90 of flexion. Each cam is
// cut, between proven ends (change/resection.hpp); then it is found how far the cut hip turns.

#include <array>
#include <stdexcept>

#include "harness/driver.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "joint/resect.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::string_view kRequired = "flexion=90,internal_rotation=30";
constexpr double kClearance = 0.5;                                 // mm
constexpr std::array kHeights{2.0, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0};  // mm, of the top of the cam

HipParameters cam_of(double height) {
  HipParameters parameters = hip_preset("cam");
  parameters.cam_height = height;
  return parameters;
}

Session session_of(const HipParameters& parameters, std::size_t faces) {
  const Hip hip = make_hip(parameters, faces);
  JointInput input;
  input.ball = {"ball", hip.ball};
  input.socket = {"socket", hip.socket};
  input.centre = Vec3::Zero();
  input.side = parameters.side;
  return {assemble_joint(std::move(input)), parameters.side, "RAS"};
}

void add_cam(double height, std::size_t faces, Table& table) {
  Session session = session_of(cam_of(height), faces);
  std::vector<Cell> row{height};
  try {
    const ResectAnswer cut = answer(session, ResectRequest{{parse_motion(kRequired)}, kClearance});
    const ResectLeg& last = cut.legs.back();
    row.insert(row.end(), {cut.volume_mm3.low, cut.volume_mm3.high, cut.mesh_volume_mm3, cut.area_mm2.low,
                           cut.area_mm2.high, cut.depth_mm.low, cut.depth_mm.high, last.before.low_deg,
                           last.after.low_deg, Cell()});
  } catch (const std::runtime_error& refusal) {
    row.resize(10);
    row.emplace_back(refusal.what());
  }
  table.add_row(std::move(row));
}

void body(DriverRun& run) {
  const std::size_t faces = run.quick() ? 3000 : kHipFaces;
  Result result{"resection_by_cam",
                "How much of a cam has to go for the required motion?",
                {{{"cam_height_mm", "mm", "of the top of the cam over the sphere"},
                  {"volume_low_mm3", "mm^3", "that has to go, at least"},
                  {"volume_high_mm3", "mm^3", "at most"},
                  {"cut_mm3", "mm^3", "that the cut mesh leaves out"},
                  {"area_low_mm2", "mm^2", "of the surface that has to go, at least"},
                  {"area_high_mm2", "mm^2", "at most"},
                  {"depth_low_mm", "mm", "the largest along a ray, at least"},
                  {"depth_high_mm", "mm", "at most"},
                  {"before_deg", "degrees", "free internal rotation at that flexion before, at least"},
                  {"after_deg", "degrees", "and after, looked at up to 10 degrees beyond what is required"},
                  {"refused", "", "why there is no cut"}}}};
  result.parameters = {
      {"hip", "cam"}, {"faces", faces}, {"required", kRequired}, {"clearance_mm", kClearance}};
  for (const double height : kHeights) add_cam(height, faces, result.table);
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"26_resection", "What of a cam would have to go for a motion."}, body);
}
