// SPDX-License-Identifier: GPL-3.0-or-later
// The questions as methods, with those arrays that are not JSON.
#include <algorithm>
#include <filesystem>
#include <limits>

#include <pybind11/stl/filesystem.h>

#include "files/file_bytes.hpp"
#include "files/file_set.hpp"
#include "joint/gaps.hpp"
#include "joint/joint_document.hpp"
#include "joint/limits.hpp"
#include "joint/measures.hpp"
#include "joint/orient.hpp"
#include "joint/poses.hpp"
#include "joint/proof.hpp"
#include "joint/report.hpp"
#include "joint/resect.hpp"
#include "joint/volume.hpp"
#include "python/question_method.hpp"
#include "report/files.hpp"
#include "report/page.hpp"

namespace impinge::python {
namespace {

// Adds the mesh of resected_ball.ply or resected_socket.ply.
void add_mesh(PoseJoint& /*joint*/, const ResectAnswer& cut, py::dict& found) {
  found["vertices"] = array_of<double>(cut.mesh.vertices);
  found["faces"] = array_of<std::uint32_t>(cut.mesh.faces);
  found["depth"] = array_of<double>(cut.depth);
}

// Adds the numbers of gaps.csv and distances.csv.
void add_vertices(PoseJoint& /*joint*/, const GapsAnswer& answer, py::dict& found) {
  for (const char* key : {"gap", "bound", "distance"}) found[key] = py::dict();
  for (const Surface surface : kSurfaces) {
    const SurfaceAnswer& of = answer.of(surface);
    const py::str name(std::string(impinge::name(surface)));
    const auto add = [&](const char* key, const auto& values) {
      if (!values.empty()) found[key][name] = array_of<double>(values);
    };
    add("gap", of.gap);
    add("bound", of.bound);
    static_assert(sizeof(DistanceBracket) == 2 * sizeof(double));
    add("distance", of.distance);
  }
}

// The rows of poses.csv, besides the document.
struct PosesRows : PosesAnswer {
  std::vector<PoseRow> rows;
  PoseList list;
};

PosesRows rows_of(const SessionJoint& joint, const PosesRequest& request) {
  PosesRows found;
  InterruptWatch watch;
  found.list = list_of(request, joint);
  const PoseSeries series(joint, request);
  if (request.asks(PosesOutput::touch)) found.touching = found.unknown = 0;
  if (const std::string doubt = doubt_of(request, joint, found.list); !doubt.empty()) found.doubt = doubt;
  for (std::size_t k = 0; k < found.list.size(); ++k) {
    PoseRow row{.pose = k + 1, .tracked = found.list.tracked(k)};
    if (row.tracked) row = series.answer(pose_in(joint, found.list, k));
    row.pose = k + 1;
    add_row(row, found);
    found.rows.push_back(std::move(row));
    watch.look();
  }
  return found;
}

PosesRows ask_poses(PoseJoint& joint, const PosesRequest& request) {
  return joint.alone([&](const SessionJoint& of) { return rows_of(of, request); });
}

void add_rows(PoseJoint& /*joint*/, const PosesRows& answer, py::dict& found) {
  if (answer.doubt) warn(*answer.doubt);
  Json rows = Json::array();
  for (const PoseRow& row : answer.rows) {
    Json& one = rows.emplace_back(json_of(row));
    if (row.areas) one.update(json_of(*row.areas));
    for (std::size_t k = 0; k < answer.list.width(); ++k)
      if (const std::string& name = answer.list.columns[k].name; !name.empty())
        one[name] = json_of(answer.list.values[(row.pose - 1) * answer.list.width() + k]);
  }
  found["rows"] = object_of(rows);
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
  double shift_x_mm;
  double shift_y_mm;
  double shift_z_mm;
};

void add_cells(PoseJoint& /*joint*/, const VolumeAnswer& found, py::dict& answer) {
  std::vector<CellRow> rows;
  found.volume.for_each([&](const VolumeCell& at) {
    const VolumeRow row = volume_row(at);
    const ShiftRow shift = shift_row(at);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const int reachable = row.reachable ? (*row.reachable ? 1 : 0) : -1;
    rows.push_back({row.level, static_cast<std::int64_t>(row.cell), row.w, row.x, row.y, row.z,
                    row.radius_deg, row.share, row.free, row.blocked, static_cast<std::int8_t>(at.state),
                    static_cast<std::int8_t>(reachable), shift.shift_x_mm.value_or(kNone),
                    shift.shift_y_mm.value_or(kNone), shift.shift_z_mm.value_or(kNone)});
  });
  answer["cells"] = py::array_t<CellRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

// Looks for Ctrl-C after each batch of cells.
template <class Request>
auto ask_watched(PoseJoint& joint, const Request& request) {
  InterruptWatch watch;
  return joint.ask(
      request, VolumeSettings{.most_cells = kMostVolumeCells,
                              .reached = [&watch](std::span<const CellVerdict>, double) { watch.look(); }});
}

// Writes the folder of `impinge report`.
py::object report(PoseJoint& joint, const std::filesystem::path& out, const py::args& args,
                  const py::kwargs& named) {
  const auto request = request_of<ReportRequest>(args, named);
  Json document;
  without_lock(1, [&](std::size_t) {
    require_writable_folder(out);
    Stopwatch watch;
    const ReportAnswer found = ask_watched(joint, request);
    const JointNames& names = joint.names();
    document = document_of("report", json_of(describe(joint.joint(), names)), json_of(request),
                           json_of(found), {{"answer", watch.lap_ms()}});
    std::vector<std::filesystem::path> inputs{names.ball, names.socket};
    inputs.insert(inputs.end(), names.ball_parts.begin(), names.ball_parts.end());
    inputs.insert(inputs.end(), names.socket_parts.begin(), names.socket_parts.end());
    FileSet files;
    for (const AnswerFile& file : report_files(joint.joint(), request, found, inputs)) {
      files.add(out / file.name, file.bytes);
      document["files"].push_back(file.name);
    }
    document["files"].push_back("summary.json");
    files.add(out / "summary.json", text_of(document));
    files.commit();
  });
  if (kReportViewer.empty()) warn("report.html does not draw the bones: " + viewer_missing());
  return object_of(document["answer"]);
}

// Warns if nothing touches at the start but the gap is already below the threshold.
void warn_of_start(PoseJoint& joint, const LimitsAnswer& found, py::dict& /*answer*/) {
  const auto blocked = [&](bool by_gap) {
    return std::find_if(found.limits.begin(), found.limits.end(), [&](const LimitAnswer& limit) {
      return limit.told.limit.state == LimitState::blocked && (limit.told.threshold_mm > 0.0) == by_gap;
    });
  };
  const auto limit = blocked(true);
  if (limit == found.limits.end() || blocked(false) != found.limits.end()) return;
  std::string line;
  without_lock(1, [&](std::size_t) {
    line = joint.alone([&](SessionJoint& of) {
      return describe_threshold(
          touch_in(of, pose_of(of, limit->start)), "at the start",
          {.overlap = "", .threshold_mm = limit->told.threshold_mm, .threshold = "cartilage_mm="});
    });
  });
  warn(line);
}

void add_text(PoseJoint& /*joint*/, const CertifyAnswer& found, py::dict& answer) {
  answer["text"] = found.text;
}

}  // namespace

void bind_questions(JointClass& joint) {
  PYBIND11_NUMPY_DTYPE(SquareRow, inclination_deg, anteversion_deg, half_width_deg, leg, state);
  PYBIND11_NUMPY_DTYPE(CellRow, level, cell, w, x, y, z, radius_deg, share, free, blocked, state, reachable,
                       shift_x_mm, shift_y_mm, shift_z_mm);
  bind_question<TouchRequest, TouchAnswer>(joint, "_touch", "Do the bones touch in a pose?");
  bind_question<GapsRequest, GapsAnswer>(
      joint, "_gaps",
      "What all gaps of a pose say; `gap`, `bound` and `distance` are dicts of ball and socket, an array of "
      "the vertices each.",
      &add_vertices);
  bind_question<LimitsRequest, LimitsAnswer>(
      joint, "limits", "How far each motion goes before bones meet, and what meets what.", &warn_of_start);
  bind_question<PosesRequest, PosesRows>(
      joint, "_poses", "Contact and the smallest gap in each of many poses; `rows` are those of poses.csv.",
      &add_rows, &ask_poses);
  bind_question<VolumeRequest, VolumeAnswer>(joint, "volume",
                                             "Which share of all rotations is free, and can be reached; "
                                             "`cells` is a structured array with the columns "
                                             "of volume.csv.",
                                             &add_cells, &ask_watched<VolumeRequest>);
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
  joint.attr("_questions")["report"] = "report";
  joint.def("report", &report,
            (signature_of<ReportRequest>("report", "self, out") +
             docstring_of<ReportRequest, ReportAnswer>(
                 "Writes report.html and its numbers into the folder `out`, as `impinge report` does."))
                .c_str());
}

}  // namespace impinge::python
