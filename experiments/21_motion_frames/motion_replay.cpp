// SPDX-License-Identifier: GPL-3.0-or-later
#include "21_motion_frames/motion_replay.hpp"

#include <cmath>
#include <optional>

#include "21_motion_frames/hip_scan.hpp"
#include "harness/ply_series.hpp"
#include "hip/motion.hpp"

namespace impinge::lab {
namespace {

constexpr const char* kNeutral = "neutral";
constexpr const char* kForward = "forward";

// A pose on the way of a motion, and the picture that its gaps are kept for, if they are.
struct Step {
  std::string motion;
  double angle_deg = 0.0;
  bool at_end = false;
  std::optional<std::size_t> picture;
  double forward_mm = 0.0;
};

// The pose as modelled, each motion from its first step, the pose moved forward.
std::vector<Step> steps_of(const std::vector<RecordedMotion>& motions, const ReplayOptions& options) {
  std::vector<Step> steps{{kNeutral, 0.0, false, 0, 0.0}};
  std::size_t pictures = 1;
  for (const RecordedMotion& recorded : motions) {
    const auto share = static_cast<double>(options.pictures) * options.step_deg;
    const auto between = static_cast<std::size_t>(std::ceil(recorded.angle_deg / share));
    const std::size_t count = between * options.pictures;
    for (std::size_t k = 1; k <= count; ++k) {
      const double done = static_cast<double>(k) / static_cast<double>(count);
      steps.push_back({recorded.motion, done * recorded.angle_deg, k == count,
                       k % between == 0 ? std::optional(pictures++) : std::nullopt, 0.0});
    }
  }
  steps.push_back({kForward, 0.0, false, pictures, options.forward_mm});
  return steps;
}

Motion motion_of(const Step& step) {
  Motion motion;
  if (step.motion == kNeutral || step.motion == kForward) return motion;
  const MotionName& name = motion_name(step.motion);
  motion.*name.angle = name.sign * step.angle_deg;
  return motion;
}

Pose pose_of(const Step& step, Side side) {
  return {joint_rotation(motion_of(step), side), step.forward_mm * Vec3::UnitY()};
}

// The smallest gap of both surfaces and its place: gap_mm, surface, hours; empty cells where they never meet.
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
  std::vector<Cell> row{
      scanner.hip.name, step.motion, step.angle_deg, step.at_end, step.picture ? Cell(*step.picture) : Cell(),
      step.forward_mm};
  for (const Cell& cell : smallest_cells(scanner.dial, state)) row.push_back(cell);
  for (Eigen::Index k = 0; k < 9; ++k) row.emplace_back(state.pose.rotation(k / 3, k % 3));
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

VertexSeries kept(std::size_t picture, const std::vector<double>& gap) {
  VertexSeries series{"gap_" + std::to_string(picture), {}};
  for (const double g : gap) series.values.push_back(static_cast<float>(g));
  return series;
}

}  // namespace

ReplayTables replay_tables() {
  ReplayTables tables;
  tables.frames.columns = {
      {"joint", "", "name of the hip"},
      {"motion", "", "neutral is the pose as modelled, forward moved to anterior from it"},
      {"angle_deg", "deg", "by which the ball is turned from it"},
      {"at_end", "", "whether this is the angle recorded"},
      {"picture", "1", "K of the property gap_K in motion_frames/, where it is kept"},
      {"forward_mm", "mm", "by which the ball is moved to anterior"},
      {"smallest_gap_mm", "mm", "of both surfaces, radial; below 0 they overlap"},
      {"surface", "", "of the vertex that has it"},
      {"clock_hours", "h", "of that vertex on the dial of the socket"}};
  for (const char* entry : {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"}) {
    tables.frames.columns.push_back({std::string("rotation_") + entry, "1", "of the ball, joint frame"});
  }
  tables.zones.columns = {
      {"joint", "", "name of the hip"},
      {"motion", "", "neutral is the pose as modelled, forward moved to anterior from it"},
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
  const HipScanner scanner = hip_scanner(hip, options.precision_deg);
  std::vector<VertexSeries> ball;
  std::vector<VertexSeries> socket;
  for (const Step& step : steps_of(motions, options)) {
    const PosedHip state = scan(scanner, pose_of(step, hip.side));
    add_frame(scanner, step, state, tables.frames);
    add_zones(scanner, step, state, options.thresholds, tables.zones);
    if (!step.picture) continue;
    ball.push_back(kept(*step.picture, state.ball.gap));
    socket.push_back(kept(*step.picture, state.socket.gap));
  }
  write_ply_series(folder / (hip.name + "-ball.ply"), hip.ball, ball);
  write_ply_series(folder / (hip.name + "-socket.ply"), hip.socket, socket);
}

}  // namespace impinge::lab
