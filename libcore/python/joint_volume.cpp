// SPDX-License-Identifier: GPL-3.0-or-later
// All rotations of the joint.
#include "joint/volume.hpp"
#include "python/question_method.hpp"

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

void add_cells(PoseJoint& /*joint*/, const VolumeAnswer& found, py::dict& answer) {
  std::vector<CellRow> rows;
  found.volume.for_each([&](const VolumeCell& at) {
    const VolumeRow row = volume_row(at);
    const int reachable = row.reachable ? (*row.reachable ? 1 : 0) : -1;
    rows.push_back({row.level, static_cast<std::int64_t>(row.cell), row.w, row.x, row.y, row.z,
                    row.radius_deg, row.share, static_cast<std::int8_t>(at.state),
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

}  // namespace

void bind_volume(JointClass& joint) {
  PYBIND11_NUMPY_DTYPE(CellRow, level, cell, w, x, y, z, radius_deg, share, state, reachable);
  bind_question<VolumeRequest, VolumeAnswer>(joint, "volume",
                                             "Which share of all rotations is free, and can be reached; "
                                             "`cells` is a structured array with the columns "
                                             "of volume.csv.",
                                             &add_cells, &ask_watched);
}

}  // namespace impinge::python
