// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Where are hips impinged through the recorded motions of two patients? (Tables 11 to 13)
// @writes    motion_frames motion_zones
// @files     motion_frames/forward-ball.ply motion_frames/forward-socket.ply
// @timing    no
// @seconds   1 3
// @links     harness gap_simd hip ply_series
//
// The hips are stand-ins, since the patients' scans are not public (hip/hip_presets.hpp).

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "files/csv.hpp"
#include "files/file_bytes.hpp"
#include "gap/gap_summary.hpp"
#include "gap/pose.hpp"
#include "gap/simd/joint_scan.hpp"
#include "harness/driver.hpp"
#include "harness/ply_series.hpp"
#include "hip/anatomy.hpp"
#include "hip/close_zones.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/motion.hpp"
#include "hip/recorded_range.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/exact_raster.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

// A hip in the joint frame, mm, with the centre of rotation as origin.
struct ReplayedHip {
  std::string name;         // in the results and of the files
  Side side = Side::right;  // of the body
  TriangleMesh ball;        // mm
  TriangleMesh socket;      // must have a dial, else std::invalid_argument (hip/clock.hpp)
};

// Everything that the poses of one hip share; the hip must outlive it.
struct HipScanner {
  const ReplayedHip& hip;                        // borrowed
  ClockFace dial;                                // of the socket
  PackedJoint<PackedTable<Rsid, double>> lanes;  // tables and vertices of both surfaces
  std::vector<double> ball_area;                 // vertex_areas(), mm^2
  std::vector<double> socket_area;
};

// One surface in one pose.
struct PosedSurface {
  std::vector<Vec3> vertices;       // as posed
  std::vector<double> gap;          // mm, NaN where the other surface is not met
  const std::vector<double>& area;  // of each vertex, mm^2

  PosedGaps gaps() const { return {vertices, gap, area}; }  // for close_zones()
  // Summary of the gaps of at most `threshold` mm.
  GapSummary within(double threshold) const { return impinge::summarise(gap, area, threshold); }
};

// Both surfaces in one pose.
struct PosedHip {
  PosedSurface ball;    // vertices where the pose has put them
  PosedSurface socket;  // at rest
};

// Fills the tables exactly.
HipScanner hip_scanner(const ReplayedHip& hip, double precision_deg) {
  const auto dial = clock_face(hip.socket);
  if (!dial) throw std::invalid_argument(hip.name + ": the socket has no dial: see hip/clock.hpp");
  const Rsid scheme = Rsid::with_precision(precision_deg);
  return {hip, *dial,
          packed_joint(packed_table<double>(fill_exact(hip.ball, scheme, Layer::farthest)),
                       packed_table<double>(fill_exact(hip.socket, scheme, Layer::nearest)), hip.ball,
                       hip.socket),
          vertex_areas(hip.ball), vertex_areas(hip.socket)};
}

// The gaps of every vertex in the pose.
PosedHip scan(const HipScanner& scanner, const Pose& pose) {
  const ReplayedHip& hip = scanner.hip;
  PosedHip posed{{hip.ball.vertices, std::vector<double>(hip.ball.vertices.size()), scanner.ball_area},
                 {hip.socket.vertices, std::vector<double>(hip.socket.vertices.size()), scanner.socket_area}};
  scan_joint(scanner.lanes, pose, posed.ball.gap, posed.socket.gap);
  for (Vec3& x : posed.ball.vertices) x = to_socket(pose, x);
  return posed;
}

// Replays recorded motions of a hip. Each motion turns the ball about one axis of the joint, from the
// modelled pose to the recorded angle. Every pose gives the gaps of both surfaces, and where they are small
// on the dial of the socket (thesis, Section 5.2, Tables 11 to 13).

// One motion and its end; names as in hip/motion.hpp, degrees.
struct RecordedMotion {
  std::string motion;      // one of motion_names()
  double angle_deg = 0.0;  // at its end
};

// How finely a motion is followed, and what is reported.
struct ReplayOptions {
  double precision_deg = 0.5;  // of the tables, RSID
  double step_deg = 1.0;       // largest step between the evenly spread poses of a motion
  // Gaps up to which a zone is reported, mm: contact; the colours of Tables 12 and 13, red, orange and
  // yellow; and the cartilage of Section 3.4.
  std::vector<double> thresholds{0.0, 2.0, 4.0, 6.0};
};

// Rows of every pose, and of every zone of every pose.
struct ReplayTables {
  Table frames;  // a row a pose
  Table zones;   // a row a zone of a pose
};

constexpr const char* kNeutral = "neutral";

// A pose during a motion.
struct Step {
  std::string motion;
  double angle_deg = 0.0;
  bool at_end = false;
};

// The modelled pose, then each motion from its first step.
std::vector<Step> steps_of(const std::vector<RecordedMotion>& motions, double step_deg) {
  std::vector<Step> steps{{kNeutral, 0.0, false}};
  for (const RecordedMotion& recorded : motions) {
    const auto count = static_cast<std::size_t>(std::ceil(recorded.angle_deg / step_deg));
    for (std::size_t k = 1; k <= count; ++k) {
      const double done = static_cast<double>(k) / static_cast<double>(count);
      steps.push_back({recorded.motion, done * recorded.angle_deg, k == count});
    }
  }
  return steps;
}

Motion motion_of(const Step& step) {
  Motion motion;
  if (step.motion == kNeutral) return motion;
  const MotionName& name = motion_name(step.motion);
  motion.*name.angle = name.sign * step.angle_deg;
  return motion;
}

// The smallest gap of both surfaces and its place: gap_mm, surface, hours; empty if the surfaces never meet.
std::vector<Cell> smallest_cells(const ClockFace& dial, const PosedHip& state) {
  const GapSummary ball = state.ball.within(0.0);
  const GapSummary socket = state.socket.within(0.0);
  if (!ball.smallest && !socket.smallest) return {Cell(), Cell(), Cell()};
  const bool on_ball = ball.smallest && (!socket.smallest || ball.smallest_gap <= socket.smallest_gap);
  const GapSummary& found = on_ball ? ball : socket;
  const Vec3& place = (on_ball ? state.ball : state.socket).vertices[*found.smallest];
  return {found.smallest_gap, on_ball ? "ball" : "socket", dial.hours(place)};
}

void add_frame(const HipScanner& scanner, const Step& step, const PosedHip& state, Table& frames) {
  std::vector<Cell> row{scanner.hip.name, step.motion, step.angle_deg, step.at_end};
  for (const Cell& cell : smallest_cells(scanner.dial, state)) row.push_back(cell);
  frames.add_row(std::move(row));
}

void add_zones(const HipScanner& scanner, const Step& step, const PosedHip& state,
               const std::vector<double>& thresholds, Table& zones) {
  for (const PosedSurface* surface : {&state.ball, &state.socket}) {
    for (const double threshold : thresholds) {
      for (const ClockZone& zone : close_zones(scanner.dial, surface->gaps(), threshold)) {
        zones.add_row({scanner.hip.name, step.motion, step.angle_deg, step.at_end,
                       surface == &state.ball ? "ball" : "socket", threshold, zone.from, zone.to, zone.area});
      }
    }
  }
}

// The tables with columns and no rows.
ReplayTables replay_tables() {
  ReplayTables tables;
  tables.frames.columns = {{"joint", "", "name of the hip"},
                           {"motion", "", "neutral is the pose as modelled"},
                           {"angle_deg", "deg", "by which the ball is turned from it"},
                           {"at_end", "", "whether this is the angle recorded"},
                           {"smallest_gap_mm", "mm", "of both surfaces, radial; below 0 they overlap"},
                           {"surface", "", "of the vertex that has it"},
                           {"clock_hours", "h", "of that vertex on the dial of the socket"}};
  tables.zones.columns = {{"joint", "", "name of the hip"},
                          {"motion", "", "neutral is the pose as modelled"},
                          {"angle_deg", "deg", "by which the ball is turned from it"},
                          {"at_end", "", "whether this is the angle recorded"},
                          {"surface", "", "ball or socket"},
                          {"within_mm", "mm", "gaps up to this one make the zone"},
                          {"from_hours", "h", "where the zone begins on the dial, clockwise"},
                          {"to_hours", "h", "where it ends"},
                          {"area_mm2", "mm^2", "of its faces"}};
  return tables;
}

// Adds the poses of a hip to the tables.
void replay(const ReplayedHip& hip, const std::vector<RecordedMotion>& motions, const ReplayOptions& options,
            ReplayTables& tables) {
  const HipScanner scanner = hip_scanner(hip, options.precision_deg);
  for (const Step& step : steps_of(motions, options.step_deg)) {
    const PosedHip state = scan(scanner, {joint_rotation(motion_of(step), hip.side), Vec3::Zero()});
    add_frame(scanner, step, state, tables.frames);
    add_zones(scanner, step, state, options.thresholds, tables.zones);
  }
}

const ReplayOptions kOptions;
constexpr double kForward = 4.0;  // mm by which Figure 41 moves the ball forward

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

// Writes both posed meshes with the gap of each vertex.
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
    const Vec3 centre = fit_ball(hip.ball).centre;  // as in the thesis
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
