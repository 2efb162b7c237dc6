// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/shape_answers.hpp"

#include <stdexcept>
#include <string>

#include "hip/hip_measures.hpp"

namespace impinge::lab {
namespace {

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

}  // namespace

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
    } catch (
        const std::invalid_argument&) {  // a scan without a neck, a socket without a rim: empty from here
    }
  }
  cells.resize(all);
  return cells;
}

}  // namespace impinge::lab
