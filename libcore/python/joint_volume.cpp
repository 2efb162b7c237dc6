// SPDX-License-Identifier: GPL-3.0-or-later
// All rotations of the joint.
#include <cmath>
#include <stdexcept>
#include <string>

#include <pybind11/stl.h>

#include "joint/volume.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"

namespace impinge::python {
namespace {

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
  std::int8_t state;
  std::int8_t reachable;
};

std::vector<CellRow> rows_of(const MotionVolume& volume) {
  std::vector<CellRow> rows;
  volume.for_each([&](const VolumeCell& at) {
    const Quaternion4 q = centre(at.cell);
    const int reachable = at.reachable ? 1 : at.within_reach ? -1 : 0;
    rows.push_back({at.cell.level, static_cast<std::int64_t>(at.cell.number), q[0], q[1], q[2], q[3],
                    angular_radius(at.cell) / kDegree, share(at.cell), static_cast<std::int8_t>(at.state),
                    static_cast<std::int8_t>(reachable)});
  });
  return rows;
}

py::dict stop_dict(const VolumeStop& stop) {
  py::dict row;
  row["motion"] = std::string(stop.motion->name);
  row["low_deg"] = stop.limit.low_deg;
  row["high_deg"] = stop.limit.high_deg;
  row["clock"] = stop.hours;
  row["ball_direction"] = stop.on_ball ? py::object(point_tuple(*stop.on_ball)) : py::none();
  return row;
}

// With the names of volume.json.
py::dict volume_dict(const VolumeAnswer& answer, const std::vector<CellRow>& rows) {
  const VolumeShares& shares = answer.volume.shares();
  py::dict found;
  found["share_low"] = shares.low();
  found["share_high"] = shares.high();
  found["reachable_low"] = shares.reached();
  found["reachable_high"] = shares.within_reach();
  found["neutral_blocked"] = shares.reachable_high == 0.0;
  found["unknown"] = shares.unknown;
  found["open"] = shares.open;
  found["cells_asked"] = shares.cells;
  py::list motions;
  for (const VolumeStop& stop : answer.stops) motions.append(stop_dict(stop));
  found["motions"] = motions;
  found["cells"] = py::array_t<CellRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
  return found;
}

void require_length(const char* name, double value) {
  if (!(value >= 0.0 && std::isfinite(value)))
    throw std::invalid_argument(std::string(name) + ": is no length; give a number of mm, 0 or more");
}

py::dict volume(const PoseJoint& joint, double width, double gap_mm, double centre_within_mm) {
  if (!(width > 0.0 && width < 1.0))
    throw std::invalid_argument("width: is no share; give a number above 0 and below 1, as 0.01");
  require_length("gap_mm", gap_mm);
  require_length("centre_within_mm", centre_within_mm);
  std::optional<VolumeAnswer> answer;
  std::vector<CellRow> rows;
  {
    const py::gil_scoped_release released;
    InterruptWatch watch;
    VolumeRequest request;
    request.question = {gap_mm, centre_within_mm};
    request.settings.width = width;
    request.settings.most_cells = kMostVolumeCells;
    request.settings.reached = [&watch](std::span<const CellVerdict>, double) { watch.look(); };
    answer = answer_volume(joint.joint(), request);
    rows = rows_of(answer->volume);
  }
  return volume_dict(*answer, rows);
}

}  // namespace

void bind_volume(JointClass& joint) {
  PYBIND11_NUMPY_DTYPE(CellRow, level, cell, w, x, y, z, radius_deg, share, state, reachable);
  joint.def("volume", &volume, py::kw_only(), py::arg("width") = 0.05, py::arg("gap_mm") = 0.0,
            py::arg("centre_within_mm") = 0.0,
            "Which share of all rotations is free, and can be reached: a dict with the names of volume.json, "
            "and `cells`, a structured array with those of volume.csv.");
}

}  // namespace impinge::python
