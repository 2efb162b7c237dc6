// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Where are hips impinged through the recorded motions of two patients? (Tables 11 to 13)
// @writes    motion_frames motion_zones
// @files     motion_frames/forward-ball.ply motion_frames/forward-socket.ply
// @timing    no
// @seconds   1 3
// @links     harness gap_simd hip ply_series
//
// On stand-ins: the patients' scans are not public (hip/hip_presets.hpp).

#include "21_motion_frames/motion_replay.hpp"
#include "files/file_bytes.hpp"
#include "harness/driver.hpp"
#include "harness/ply_series.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/recorded_range.hpp"
#include "hip/sphere_fit.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

const ReplayOptions kOptions;
constexpr double kForward = 4.0;  // mm by which Figure 41 has the ball moved to anterior

std::vector<RecordedMotion> motions_of(double RecordedRange::*patient) {
  std::vector<RecordedMotion> motions;
  motions.reserve(kRecordedRanges.size());
  for (const RecordedRange& range : kRecordedRanges) {
    motions.push_back({std::string(range.motion), range.*patient});
  }
  return motions;
}

void write(DriverRun& run, const char* name, const char* question, Table table) {
  run.write({name,
             question,
             std::move(table),
             {{"precision_deg", kOptions.precision_deg},
              {"step_deg", kOptions.step_deg},
              {"forward_mm", kForward},
              {"joints", "stand-ins for the patients of the thesis, whose scans are not public"}}});
}

// Both meshes as posed, with the gap of each vertex.
void write_moved_forward(const ReplayedHip& hip, const std::filesystem::path& folder) {
  const PosedHip posed =
      scan(hip_scanner(hip, kOptions.precision_deg), {Eigen::Matrix3d::Identity(), kForward * Vec3::UnitY()});
  const auto write = [&](const char* part, const PosedSurface& surface, const TriangleMesh& mesh) {
    write_ply_series(folder / (std::string("forward-") + part + ".ply"), {surface.vertices, mesh.faces},
                     std::vector<VertexSeries>{{"gap", {surface.gap.begin(), surface.gap.end()}}});
  };
  write("ball", posed.ball, hip.ball);
  write("socket", posed.socket, hip.socket);
}

void body(DriverRun& run) {
  ReplayTables tables = replay_tables();
  const auto folder = run.record.folder / "motion_frames";
  require_writable_folder(folder);
  for (const auto& [name, angles] : {std::pair("patient_a", &RecordedRange::patient_a),
                                     std::pair("patient_b", &RecordedRange::patient_b)}) {
    const HipParameters parameters = hip_preset(name);
    const Hip hip = make_hip(parameters);
    const Vec3 centre = fit_ball(hip.ball).centre;  // as the thesis has it
    const ReplayedHip replayed{name, parameters.side, relative_to(hip.ball, centre),
                               relative_to(hip.socket, centre)};
    replay(replayed, motions_of(angles), kOptions, tables);
    if (replayed.name == "patient_a") write_moved_forward(replayed, folder);
  }
  write(run, "motion_frames", "How close are the surfaces through the recorded motions?",
        std::move(tables.frames));
  write(run, "motion_zones", "Where on the dial of the socket are the surfaces close?",
        std::move(tables.zones));
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"21_motion_frames", "Recorded motions of a hip, replayed (Tables 11 to 13)."}, body);
}
