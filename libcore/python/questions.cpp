// SPDX-License-Identifier: GPL-3.0-or-later
// The questions as methods, with the arrays that are no JSON.
#include <algorithm>

#include "joint/gaps.hpp"
#include "joint/limits.hpp"
#include "joint/measures.hpp"
#include "joint/orient.hpp"
#include "joint/proof.hpp"
#include "joint/resect.hpp"
#include "joint/volume.hpp"
#include "python/question_method.hpp"

namespace impinge::python {
namespace {

// Of resected_ball.ply or resected_socket.ply.
void add_mesh(PoseJoint& /*joint*/, const ResectAnswer& cut, py::dict& found) {
  const auto rows = [](const auto& list) { return static_cast<py::ssize_t>(list.size()); };
  const auto& [vertices, faces] = std::tie(cut.mesh.vertices, cut.mesh.faces);
  found["vertices"] = py::array_t<double>({rows(vertices), py::ssize_t{3}}, vertices.front().data());
  found["faces"] = py::array_t<std::uint32_t>({rows(faces), py::ssize_t{3}}, faces.front().data());
  found["depth"] = py::array_t<double>(rows(cut.depth), cut.depth.data());
}

// A row of orientation.csv.
struct SquareRow {
  double inclination_deg;
  double anteversion_deg;
  double half_width_deg;
  std::int64_t leg;
  std::int64_t state;
};

void add_squares(PoseJoint& /*joint*/, const OrientAnswer& answer, py::dict& found) {
  std::vector<SquareRow> rows;
  for (const OrientationCell& cell : answer.cells)
    rows.push_back({cell.middle.inclination_deg, cell.middle.anteversion_deg, cell.half_deg,
                    cell.leg ? static_cast<std::int64_t>(*cell.leg) : -1,
                    static_cast<std::int64_t>(cell.state)});
  found["squares"] = py::array_t<SquareRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

// A row of volume.csv.
struct CellRow {
  std::int64_t level;
  std::int64_t cell;
  double w;
  double x;
  double y;
  double z;
  double radius_deg;
  double share;
  double free;
  double blocked;
  std::int8_t state;
  std::int8_t reachable;
};

void add_cells(PoseJoint& /*joint*/, const VolumeAnswer& found, py::dict& answer) {
  std::vector<CellRow> rows;
  found.volume.for_each([&](const VolumeCell& at) {
    const VolumeRow row = volume_row(at);
    const int reachable = row.reachable ? (*row.reachable ? 1 : 0) : -1;
    rows.push_back({row.level, static_cast<std::int64_t>(row.cell), row.w, row.x, row.y, row.z,
                    row.radius_deg, row.share, row.free, row.blocked, static_cast<std::int8_t>(at.state),
                    static_cast<std::int8_t>(reachable)});
  });
  answer["cells"] = py::array_t<CellRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

// Looks for Ctrl-C after each batch of cells.
VolumeAnswer ask_watched(PoseJoint& joint, const VolumeRequest& request) {
  InterruptWatch watch;
  return joint.ask(
      request, VolumeSettings{.most_cells = kMostVolumeCells,
                              .reached = [&watch](std::span<const CellVerdict>, double) { watch.look(); }});
}

// A gap that is there from the start, where nothing touches, is worth a word.
void warn_of_start(PoseJoint& joint, const LimitsAnswer& found, py::dict& /*answer*/) {
  const auto blocked = [&](bool by_gap) {
    return std::find_if(found.limits.begin(), found.limits.end(), [&](const LimitAnswer& limit) {
      return limit.told.limit.state == LimitState::blocked && (limit.told.threshold_mm > 0.0) == by_gap;
    });
  };
  const auto limit = blocked(true);
  if (limit == found.limits.end() || blocked(false) != found.limits.end()) return;
  SessionJoint& of = joint.joint();
  warn(describe_threshold(
      touch_in(of, pose_of(of, limit->start)), "at the start",
      {.overlap = "", .threshold_mm = limit->told.threshold_mm, .threshold = "cartilage_mm="}));
}

void add_text(PoseJoint& /*joint*/, const CertifyAnswer& found, py::dict& answer) {
  answer["text"] = found.text;
}

}  // namespace

void bind_questions(JointClass& joint) {
  PYBIND11_NUMPY_DTYPE(SquareRow, inclination_deg, anteversion_deg, half_width_deg, leg, state);
  PYBIND11_NUMPY_DTYPE(CellRow, level, cell, w, x, y, z, radius_deg, share, free, blocked, state, reachable);
  bind_question<TouchRequest, TouchAnswer>(joint, "_touch", "Do the bones touch in a pose?");
  bind_question<GapsRequest, GapsAnswer>(joint, "_gaps", "What all gaps of a pose say.");
  bind_question<LimitsRequest, LimitsAnswer>(
      joint, "limits", "How far each motion goes before bones meet, and what meets what.", &warn_of_start);
  bind_question<VolumeRequest, VolumeAnswer>(joint, "volume",
                                             "Which share of all rotations is free, and can be reached; "
                                             "`cells` is a structured array with the columns "
                                             "of volume.csv.",
                                             &add_cells, &ask_watched);
  bind_question<ResectRequest, ResectAnswer>(
      joint, "resect",
      "The bone that would have to go so that motions are reached, and the cut mesh as `vertices`, `faces` "
      "and `depth`. Nothing here may guide a treatment.",
      &add_mesh);
  bind_question<OrientRequest, OrientAnswer>(
      joint, "orient",
      "In which orientations of the socket motions are free; `squares` is a structured array, a row a square "
      "of the map. Nothing here may guide a treatment.",
      &add_squares);
  bind_question<MeasureRequest, MeasureAnswer>(
      joint, "measure",
      "The measures of both surfaces with their uncertainty, each beside what is published of it.");
  bind_question<CertifyRequest, CertifyAnswer>(
      joint, "certify",
      "A proof that a pose, or the way to the limit of a motion, is without contact, or that bodies touch in "
      "the pose; `text` is the "
      "certificate, which experiments/check_certificate.py checks.",
      &add_text);
}

}  // namespace impinge::python
