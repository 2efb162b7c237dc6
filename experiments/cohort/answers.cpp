// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/answers.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "gap/simd/exact_cells.hpp"
#include "hip/close_zones.hpp"
#include "hip/hip_measures.hpp"
#include "hip/named_motion.hpp"
#include "limits/told_limit.hpp"
#include "rotations/volume.hpp"

namespace impinge::lab {
namespace {

std::vector<Column> volume_columns() {
  return {{"volume_free_low", "1", "share of all rotations that is free of contact, no less"},
          {"volume_free_high", "1", "no more"},
          {"volume_reach_low", "1", "share that can be reached from the neutral pose, no less"},
          {"volume_reach_high", "1", "no more"}};
}

std::vector<Cell> volume_cells(const Member& member) {
  if (!member.volume) return std::vector<Cell>(volume_columns().size());
  VolumeSettings settings;
  settings.threads = 1;  // shards run side by side
  const VolumeShares shares = MotionVolume(CellTest(member.meshes), settings).shares();
  return {shares.low(), shares.high(), shares.reached(), shares.within_reach()};
}

template <class T>
void append(std::vector<T>& list, std::vector<T> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

const std::vector<Column>& femur_columns() {
  static const std::vector<Column> columns = [] {
    std::vector<Column> list{{"measured_head_radius", "mm", "of the sphere that fits the head"},
                             {"measured_head_neck_offset", "mm", "head radius minus neck radius"},
                             {"measured_neck_shaft_angle", "deg", "CCD"},
                             {"measured_femoral_torsion", "deg", "anteversion of the neck"}};
    for (std::size_t h = 0; h < kClockHours; ++h) {
      const std::string hour = std::to_string(h == 0 ? 12 : h);
      list.push_back({"measured_alpha_" + hour, "deg", "alpha angle at " + hour + " o'clock"});
    }
    return list;
  }();
  return columns;
}

const std::vector<Column>& socket_columns() {
  static const std::vector<Column> columns{
      {"measured_joint_space", "mm", "radius of the socket minus that of the head"},
      {"measured_inclination", "deg", "of the axis of the opening"},
      {"measured_version", "deg", "of the axis of the opening"},
      {"measured_half_opening", "deg", "from the pole of the socket to its rim"},
      {"measured_lateral_centre_edge", "deg", "from the vertical to the rim, laterally"}};
  return columns;
}

Cell shape_cell(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

void add_femur(const FemurMeasures& femur, std::vector<Cell>& cells) {
  cells.emplace_back(femur.head.radius);
  cells.emplace_back(femur.head_neck_offset);
  cells.push_back(shape_cell(femur.neck_shaft_angle));
  cells.push_back(shape_cell(femur.femoral_torsion));
  for (const double alpha : femur.alpha) cells.emplace_back(alpha);
}

void add_socket(const AcetabulumMeasures& socket, double head_radius, std::vector<Cell>& cells) {
  cells.emplace_back(socket.socket.radius - head_radius);
  cells.emplace_back(socket.inclination);
  cells.emplace_back(socket.version);
  cells.emplace_back(socket.half_opening);
  cells.push_back(shape_cell(socket.lateral_centre_edge));
}

// A hip that turns.
class TurningHip {
 public:
  TurningHip(const BallSocketPair& meshes, const std::optional<Side>& side)
      : side_(side), dial_(clock_face(meshes.socket)), limits_(meshes) {}

  // Is the motion known even if the side is not?
  bool knows(const NamedMotion& motion) const {
    return side_ || motion_name(motion.growing).angle == &Motion::flexion;
  }
  JointTurn turn(const NamedMotion& motion) const {
    return joint_turn(motion.start, motion_name(motion.growing), side_);
  }
  TurnLimit limit(const NamedMotion& motion) const {
    return limits_.first_contact(turn(motion), largest(motion));
  }
  CentreInterval for_centres(const NamedMotion& motion, const TurnLimit& limit) const {
    return limits_.centre_interval(turn(motion), limit, largest(motion),
                                   {CentreDoubt::common, kErrorOfInput, 0.0});
  }
  const std::optional<ClockFace>& dial() const { return dial_; }
  static double largest(const NamedMotion& motion) {
    return largest_growth(motion.start, motion_name(motion.growing));
  }

 private:
  std::optional<Side> side_;
  std::optional<ClockFace> dial_;
  TurnLimits limits_;
};

// A socket whose vertices are scanned against the faces of the ball.
class ZoneScan {
 public:
  ZoneScan(const BallSocketPair& meshes, double threshold)
      : socket_(meshes.socket),
        threshold_(threshold),
        cells_(exact_cells(meshes.ball, facing_layer(Surface::ball))),
        vertices_(packed_vertices<float>(meshes.socket.vertices)),
        area_(vertex_areas(meshes.socket)),
        found_(area_.size()),
        gap_(area_.size()) {}

  // The largest zone in a pose.
  std::optional<ClockZone> largest(const ClockFace& dial, const Pose& pose) {
    scan_gaps(cells_, vertices_, pose, Surface::socket, found_);
    std::copy(found_.begin(), found_.end(), gap_.begin());
    const std::vector<ClockZone> zones = close_zones(dial, {socket_.vertices, gap_, area_}, threshold_);
    return zones.empty() ? std::nullopt : std::optional(zones.front());
  }

 private:
  const TriangleMesh& socket_;
  double threshold_;
  ExactCells cells_;
  PackedVertices<float> vertices_;
  std::vector<double> area_;
  std::vector<float> found_;
  std::vector<double> gap_;
};

Pose pose_at(const JointTurn& turn, double angle_deg) {
  const Eigen::AngleAxisd grown(angle_deg * kDegree, turn.axis);
  return {turn.outer * grown.toRotationMatrix() * turn.inner, Vec3::Zero()};
}

void add_limit(const TurningHip& hip, const TurnLimit& limit, const CentreInterval& any,
               std::vector<Cell>& cells) {
  cells.emplace_back(name(limit.state));
  cells.emplace_back(limit.low_deg);
  cells.emplace_back(any.low_deg);
  cells.push_back(any.limited ? Cell(any.high_deg) : Cell());
  const bool placed = limit.contact && hip.dial();
  cells.push_back(placed ? Cell(hip.dial()->hours(limit.contact->place)) : Cell());
}

void add_zone(const std::optional<ClockZone>& zone, std::vector<Cell>& cells) {
  if (zone)
    cells.insert(cells.end(), {Cell(zone->from), Cell(zone->to), Cell(zone->area)});
  else
    cells.resize(cells.size() + 3);
}

}  // namespace

std::vector<Column> answer_columns(const Study& study) {
  const CohortQuestions& asked = study.questions;
  std::vector<Column> columns;
  std::vector<Column> fine;
  if (asked.limits) {
    append(columns, limit_columns(asked));
    append(fine, plain_limit_columns());
  }
  if (asked.morphology) {
    append(columns, shape_columns());
    append(fine, shape_columns());
  }
  if (asked.volume) append(columns, volume_columns());
  if (study.check_every == 0) return columns;
  for (Column& column : fine) column.name = kFine + column.name;
  append(columns, std::move(fine));
  return columns;
}

std::vector<Cell> answers(const Study& study, const Member& member) {
  const CohortQuestions& asked = study.questions;
  std::vector<Cell> cells;
  if (asked.limits) append(cells, limit_cells(asked, member.meshes, member.side));
  if (asked.morphology) append(cells, shape_cells(member.meshes, member.side));
  if (asked.volume) append(cells, volume_cells(member));
  if (member.fine) {
    if (asked.limits) append(cells, plain_limit_cells(*member.fine, member.side));
    if (asked.morphology) append(cells, shape_cells(*member.fine, member.side));
  }
  cells.resize(answer_columns(study).size());
  return cells;
}

std::vector<Column> shape_columns() {
  std::vector<Column> columns = femur_columns();
  columns.insert(columns.end(), socket_columns().begin(), socket_columns().end());
  return columns;
}

std::vector<Cell> shape_cells(const BallSocketPair& meshes, const std::optional<Side>& side) {
  std::vector<Cell> cells;
  const std::size_t all = femur_columns().size() + socket_columns().size();
  if (side) {
    try {
      const FemurMeasures femur = measure_femur(meshes.ball, *side);
      add_femur(femur, cells);
      add_socket(measure_acetabulum(meshes.socket, femur.head, *side), femur.head.radius, cells);
    } catch (const std::invalid_argument&) {  // without a neck or a rim the cells from here are empty
    }
  }
  cells.resize(all);
  return cells;
}

std::vector<Column> limit_columns(const CohortQuestions& asked) {
  std::vector<Column> columns;
  for (const NamedMotion& motion : named_motions()) {
    const std::string m(motion.name);
    columns.insert(
        columns.end(),
        {{m + "_state", "", "how the search for the limit ended"},
         {m + "_deg", "deg", "no contact up to here; a limit if M_state is limited"},
         {m + "_low_deg", "deg", "the same for every centre within 0.5 mm"},
         {m + "_high_deg", "deg", "contact by here for every such centre; empty where that is not known"},
         {m + "_clock", "h", "where they touch, on the dial of the socket"}});
    if (!asked.zones) continue;
    columns.insert(columns.end(), {{m + "_zone_from", "h", "where the largest close zone begins"},
                                   {m + "_zone_to", "h", "where it ends, clockwise"},
                                   {m + "_zone_mm2", "mm^2", "its area on the socket"}});
  }
  return columns;
}

std::vector<Cell> limit_cells(const CohortQuestions& asked, const BallSocketPair& meshes,
                              const std::optional<Side>& side) {
  const TurningHip hip(meshes, side);
  std::optional<ZoneScan> zones;
  if (asked.zones && hip.dial()) zones.emplace(meshes, asked.zone_gap_mm);
  std::vector<Cell> cells;
  for (const NamedMotion& motion : named_motions()) {
    if (!hip.knows(motion)) {
      cells.resize(cells.size() + (asked.zones ? 8 : 5));
      continue;
    }
    const TurnLimit limit = hip.limit(motion);
    add_limit(hip, limit, hip.for_centres(motion, limit), cells);
    if (!asked.zones) continue;
    const Pose end = pose_at(hip.turn(motion), limit.low_deg);
    add_zone(zones ? zones->largest(*hip.dial(), end) : std::nullopt, cells);
  }
  return cells;
}

std::vector<Column> plain_limit_columns() {
  std::vector<Column> columns;
  for (const NamedMotion& motion : named_motions())
    columns.push_back({std::string(motion.name) + "_deg", "deg", "no contact up to here"});
  return columns;
}

std::vector<Cell> plain_limit_cells(const BallSocketPair& meshes, const std::optional<Side>& side) {
  const TurningHip hip(meshes, side);
  std::vector<Cell> cells;
  for (const NamedMotion& motion : named_motions())
    cells.push_back(hip.knows(motion) ? Cell(hip.limit(motion).low_deg) : Cell());
  return cells;
}

}  // namespace impinge::lab
