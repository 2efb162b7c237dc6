// SPDX-License-Identifier: GPL-3.0-or-later
// @question  What would have to go, or be turned, so that a hip reaches a motion, and how soon is it known?
// @writes    change_error resection_by_cam
// @timing    yes
// @seconds   3 40
// @links     harness session
//
// The hip `cam` is to reach 30 degrees of internal rotation at 90 of flexion. Both questions have answers
// between proven ends (motion/resection.hpp, motion/orientation.hpp): how near to each other, after which
// time, of making the joint ready and of all. Then cams of several heights, each cut and asked again how far
// it turns.

#include <array>
#include <cmath>
#include <stdexcept>

#include "files/stopwatch.hpp"
#include "harness/driver.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "session/orientation.hpp"
#include "session/resection.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::string_view kRequired = "flexion=90,internal_rotation=30";
constexpr double kClearance = 0.5;                                 // mm
constexpr std::array kHeights{2.0, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0};  // mm, of the top of the cam
constexpr double kMapWidth = 90.0;                                 // degrees, of the map of orientations

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

// Between which ends the removed volume is, by the closeness that is asked for.
void add_resections(DriverRun& run, std::size_t faces, Table& table) {
  const HipParameters parameters = hip_preset("cam");
  const Hip hip = make_hip(parameters, faces);
  const std::vector<RequiredLeg> legs = required_legs(parse_motion(kRequired), parameters.side);
  std::vector<double> closenesses{0.5, 0.2, 0.1, 0.05, 0.02};
  if (!run.quick()) closenesses.push_back(0.01);
  for (const double closeness : closenesses) {
    Stopwatch watch;
    const SweptRadius swept(hip.socket, legs);
    const double build_s = watch.lap_s();
    CutQuestion question{.clearance_mm = kClearance, .closeness = closeness, .least_mm3 = 1e-3};
    question.most_new_faces = 1'000'000;
    const Resection cut = least_radial_cut(hip.ball, swept, question);
    table.add_row({"resection", closeness, "share", cut.volume_mm3.low, cut.volume_mm3.high, "mm^3", build_s,
                   build_s + watch.lap_s()});
  }
}

// Which share of all orientations is free, by the resolution of the map.
void add_orientations(DriverRun& run, std::size_t faces, Table& table) {
  Session session = session_of(hip_preset("cam"), faces);
  for (int halvings = 4; halvings <= (run.quick() ? 7 : 10); ++halvings) {
    const double resolution = kMapWidth / std::exp2(halvings);
    Stopwatch watch;
    const OrientationAnswer answer =
        answer_orientation(session, {{parse_motion(kRequired)}, 0.0, resolution});
    const double all = kMapWidth * kMapWidth;
    table.add_row({"orientation", resolution, "degrees", answer.free / all, 1.0 - answer.blocked / all, "1",
                   Cell(), watch.lap_s()});
  }
}

void add_cam(double height, std::size_t faces, Table& table) {
  Session session = session_of(cam_of(height), faces);
  std::vector<Cell> row{height};
  try {
    const ResectionAnswer answer = answer_resection(session, {{parse_motion(kRequired)}, kClearance, {}});
    const Resection& cut = answer.cut;
    const ReachedLeg& last = answer.legs.back();
    row.insert(row.end(),
               {cut.volume_mm3.low, cut.volume_mm3.high, cut.cut_mm3, cut.area_mm2.low, cut.area_mm2.high,
                cut.depth_mm.low, cut.depth_mm.high, last.before.low_deg, last.after.low_deg, Cell()});
  } catch (const std::runtime_error& refusal) {
    row.resize(10);
    row.emplace_back(refusal.what());
  }
  table.add_row(std::move(row));
}

void body(DriverRun& run) {
  const std::size_t faces = run.quick() ? 3000 : kHipFaces;
  Result result{"change_error",
                "How near are the proven ends of an answer to each other, after which time?",
                {{{"question", "", "resection: volume that has to go; orientation: share that is free"},
                  {"setting", "", "closeness, or resolution, that was asked for"},
                  {"setting_unit", "", "of that"},
                  {"low", "", "proven lower end"},
                  {"high", "", "proven upper end"},
                  {"unit", "", "of both"},
                  {"build_s", "s", "of it, to make the socket ready"},
                  {"time_s", "s", "in all, wall clock"}}}};
  result.parameters = {{"hip", "cam"},
                       {"faces", faces},
                       {"required", kRequired},
                       {"clearance_mm", kClearance},
                       {"map_deg", kMapWidth}};
  add_resections(run, faces, result.table);
  run.progress.say("resections");
  add_orientations(run, faces, result.table);
  run.write(result);

  Result cams = result;
  cams.name = "resection_by_cam";
  cams.question = "How much of a cam has to go for the required motion?";
  cams.table = {{{"cam_height_mm", "mm", "of the top of the cam over the sphere"},
                 {"volume_low_mm3", "mm^3", "that has to go, at least"},
                 {"volume_high_mm3", "mm^3", "at most"},
                 {"cut_mm3", "mm^3", "that the cut mesh leaves out"},
                 {"area_low_mm2", "mm^2", "of the surface that has to go, at least"},
                 {"area_high_mm2", "mm^2", "at most"},
                 {"depth_low_mm", "mm", "the largest along a ray, at least"},
                 {"depth_high_mm", "mm", "at most"},
                 {"before_deg", "degrees", "free internal rotation at that flexion before, at least"},
                 {"after_deg", "degrees", "and after, looked at up to 10 degrees beyond what is required"},
                 {"refused", "", "why there is no cut"}},
                {}};
  for (const double height : kHeights) add_cam(height, faces, cams.table);
  run.write(cams);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"26_resection_orientation", "What would have to change for a motion.", false}, body);
}
