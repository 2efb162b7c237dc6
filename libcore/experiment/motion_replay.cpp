// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/motion_replay.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "detection/gap_scan.hpp"
#include "detection/gap_summary.hpp"
#include "joint/close_zones.hpp"
#include "joint/motion.hpp"
#include "mesh/ply_series.hpp"
#include "sampling/exact_raster.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge {
namespace {

constexpr const char* kNeutral = "neutral";

// A pose on the way of a motion, and the picture that its gaps are kept for, if they are.
struct Step {
  std::string motion;
  double angle_deg = 0.0;
  bool at_end = false;
  std::optional<std::size_t> picture;
};

// The pose as modelled, then each motion from its first step.
std::vector<Step> steps_of(const std::vector<RecordedMotion>& motions, const ReplayOptions& options) {
  std::vector<Step> steps{{kNeutral, 0.0, false, 0}};
  std::size_t pictures = 1;
  for (const RecordedMotion& recorded : motions) {
    const auto share = static_cast<double>(options.pictures) * options.step_deg;
    const auto between = static_cast<std::size_t>(std::ceil(recorded.angle_deg / share));
    const std::size_t count = between * options.pictures;
    for (std::size_t k = 1; k <= count; ++k) {
      const double done = static_cast<double>(k) / static_cast<double>(count);
      steps.push_back({recorded.motion, done * recorded.angle_deg, k == count,
                       k % between == 0 ? std::optional(pictures++) : std::nullopt});
    }
  }
  return steps;
}

// All that the poses of one hip share.
struct Scanner {
  const ReplayedHip& hip;
  ClockFace dial;
  RadialTable<Rsid> ball_table;
  RadialTable<Rsid> socket_table;
  std::vector<double> ball_area;
  std::vector<double> socket_area;
};

Scanner scanner_of(const ReplayedHip& hip, double precision_deg) {
  const auto dial = clock_face(hip.socket);
  if (!dial) throw std::invalid_argument(hip.name + ": the socket has no dial: see joint/clock.hpp");
  const Rsid scheme = Rsid::with_precision(precision_deg);
  return {hip,
          *dial,
          fill_exact(hip.ball, scheme, Layer::farthest),
          fill_exact(hip.socket, scheme, Layer::nearest),
          vertex_areas(hip.ball),
          vertex_areas(hip.socket)};
}

Motion motion_of(const Step& step) {
  Motion motion;
  if (step.motion == kNeutral) return motion;
  const MotionName& name = motion_name(step.motion);
  motion.*name.angle = name.sign * step.angle_deg;
  return motion;
}

// One surface in one pose.
struct SurfaceState {
  std::vector<Vec3> vertices;  // as posed
  std::vector<double> gap;
  const std::vector<double>& area;

  PosedGaps gaps() const { return {vertices, gap, area}; }
  GapSummary within(double threshold) const { return summarise(gap, area, threshold); }
};

struct PoseState {
  Pose pose;
  SurfaceState ball;
  SurfaceState socket;
};

PoseState scan(const Scanner& scanner, const Step& step) {
  const ReplayedHip& hip = scanner.hip;
  PoseState state{
      {joint_rotation(motion_of(step), hip.side), Vec3::Zero()},
      {hip.ball.vertices, std::vector<double>(hip.ball.vertices.size()), scanner.ball_area},
      {hip.socket.vertices, std::vector<double>(hip.socket.vertices.size()), scanner.socket_area}};
  scan_ball(scanner.socket_table, hip.ball.vertices, state.pose, state.ball.gap);
  scan_socket(scanner.ball_table, hip.socket.vertices, state.pose, state.socket.gap);
  for (Vec3& x : state.ball.vertices) x = to_socket(state.pose, x);
  return state;
}

// The smallest gap of both surfaces and its place: gap_mm, surface, hours; empty cells where they never meet.
std::vector<Cell> smallest_cells(const ClockFace& dial, const PoseState& state) {
  const GapSummary ball = state.ball.within(0.0);
  const GapSummary socket = state.socket.within(0.0);
  if (!ball.smallest && !socket.smallest) return {Cell(), Cell(), Cell()};
  const bool on_ball = ball.smallest && (!socket.smallest || ball.smallest_gap <= socket.smallest_gap);
  const GapSummary& found = on_ball ? ball : socket;
  const Vec3& place = (on_ball ? state.ball : state.socket).vertices[*found.smallest];
  return {found.smallest_gap, on_ball ? "ball" : "socket", dial.hours(place)};
}

void add_frame(const Scanner& scanner, const Step& step, const PoseState& state, Table& frames) {
  std::vector<Cell> row{scanner.hip.name, step.motion, step.angle_deg, step.at_end,
                        step.picture ? Cell(*step.picture) : Cell()};
  for (const Cell& cell : smallest_cells(scanner.dial, state)) row.push_back(cell);
  for (Eigen::Index k = 0; k < 9; ++k) row.emplace_back(state.pose.rotation(k / 3, k % 3));
  frames.add_row(std::move(row));
}

void add_zones(const Scanner& scanner, const Step& step, const PoseState& state,
               const std::vector<double>& thresholds, Table& zones) {
  for (const SurfaceState* surface : {&state.ball, &state.socket}) {
    for (const double threshold : thresholds) {
      for (const ClockZone& zone : close_zones(scanner.dial, surface->gaps(), threshold)) {
        zones.add_row({scanner.hip.name, step.motion, step.angle_deg, step.at_end,
                       surface == &state.ball ? "ball" : "socket", threshold, zone.from, zone.to, zone.area});
      }
    }
  }
}

VertexSeries kept(std::size_t picture, const std::vector<double>& gap) {
  VertexSeries series{"gap_" + std::to_string(picture), {}};
  for (const double g : gap) series.values.push_back(static_cast<float>(g));
  return series;
}

}  // namespace

ReplayTables replay_tables() {
  ReplayTables tables;
  tables.frames.columns = {{"joint", "", "name of the hip"},
                           {"motion", "", "neutral is the pose as modelled"},
                           {"angle_deg", "deg", "by which the ball is turned from it"},
                           {"at_end", "", "whether this is the angle recorded"},
                           {"picture", "1", "K of the property gap_K in motion_frames/, where it is kept"},
                           {"smallest_gap_mm", "mm", "of both surfaces, radial; below 0 they overlap"},
                           {"surface", "", "of the vertex that has it"},
                           {"clock_hours", "h", "of that vertex on the dial of the socket"}};
  for (const char* entry : {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"}) {
    tables.frames.columns.push_back({std::string("rotation_") + entry, "1", "of the ball, joint frame"});
  }
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

void replay(const ReplayedHip& hip, const std::vector<RecordedMotion>& motions, const ReplayOptions& options,
            const std::filesystem::path& folder, ReplayTables& tables) {
  const Scanner scanner = scanner_of(hip, options.precision_deg);
  std::vector<VertexSeries> ball;
  std::vector<VertexSeries> socket;
  for (const Step& step : steps_of(motions, options)) {
    const PoseState state = scan(scanner, step);
    add_frame(scanner, step, state, tables.frames);
    add_zones(scanner, step, state, options.thresholds, tables.zones);
    if (!step.picture) continue;
    ball.push_back(kept(*step.picture, state.ball.gap));
    socket.push_back(kept(*step.picture, state.socket.gap));
  }
  write_ply_series(folder / (hip.name + "-ball.ply"), hip.ball, ball);
  write_ply_series(folder / (hip.name + "-socket.ply"), hip.socket, socket);
}

}  // namespace impinge
