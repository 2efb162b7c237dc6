// SPDX-License-Identifier: GPL-3.0-or-later
// What would have to change so that motions are reached.
#include "joint/orient.hpp"
#include "joint/resect.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"
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

}  // namespace

void bind_change(JointClass& joint) {
  PYBIND11_NUMPY_DTYPE(SquareRow, inclination_deg, anteversion_deg, half_width_deg, leg, state);
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
}

}  // namespace impinge::python
