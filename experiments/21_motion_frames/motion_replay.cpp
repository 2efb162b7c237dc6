// SPDX-License-Identifier: GPL-3.0-or-later
#include "21_motion_frames/motion_replay.hpp"

#include <cmath>

#include "21_motion_frames/hip_scan.hpp"
#include "hip/motion.hpp"

namespace impinge::lab {
namespace {

constexpr const char* kNeutral = "neutral";

// A pose on the way of a motion.
struct Step {
  std::string motion;
  double angle_deg = 0.0;
  bool at_end = false;
};

// The pose as modelled, each motion from its first step.
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

}  // namespace

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

void replay(const ReplayedHip& hip, const std::vector<RecordedMotion>& motions, const ReplayOptions& options,
            ReplayTables& tables) {
  const HipScanner scanner = hip_scanner(hip, options.precision_deg);
  for (const Step& step : steps_of(motions, options.step_deg)) {
    const PosedHip state = scan(scanner, {joint_rotation(motion_of(step), hip.side), Vec3::Zero()});
    add_frame(scanner, step, state, tables.frames);
    add_zones(scanner, step, state, options.thresholds, tables.zones);
  }
}

}  // namespace impinge::lab
