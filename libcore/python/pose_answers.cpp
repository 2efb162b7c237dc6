// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about many poses, from arrays to arrays.
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <stdexcept>

#include <pybind11/stl.h>

#include "python/arrays.hpp"
#include "python/joint_class.hpp"

namespace impinge::python {
namespace {

using Floats = py::array_t<float>;

// The array for the gaps of a surface's vertices: the given one, or a new one.
Floats gap_array(const PoseJoint& joint, Surface of, std::size_t poses, const py::object& given) {
  const std::array<py::ssize_t, 2> shape{
      static_cast<py::ssize_t>(poses), static_cast<py::ssize_t>(joint.joint().bone(of).mesh.vertices.size())};
  if (given.is_none()) return Floats(shape);
  const bool fits = py::isinstance<Floats>(given) && py::array(given).ndim() == 2 &&
                    std::equal(shape.begin(), shape.end(), py::array(given).shape()) &&
                    (py::array(given).flags() & py::array::c_style) != 0 && py::array(given).writeable();
  if (!fits)
    throw std::invalid_argument(
        "out: give two writable float32 arrays in C order, for ball and socket; the "
        "one for the " +
        std::string(name(of)) + " has shape (" + std::to_string(shape[0]) + ", " + std::to_string(shape[1]) +
        ")");
  return Floats(given);
}

// The gaps of all poses, one row each.
struct GapRows {
  explicit GapRows(Floats& gaps)
      : first(gaps.mutable_data()), width(static_cast<std::size_t>(gaps.shape(1))) {}
  // The main surface's gaps, of `of_main` vertices.
  std::span<float> main(std::size_t pose, std::size_t of_main) const {
    return std::span<float>(first + pose * width, width).first(of_main);
  }
  // The parts behind it, and vertices that are not on it, have none.
  void leave_out(std::size_t pose, const std::vector<bool>& used, std::size_t of_main) const {
    for (std::size_t v = 0; v < width; ++v)
      if (v >= of_main || !used[v]) first[pose * width + v] = std::numeric_limits<float>::quiet_NaN();
  }
  float* first;
  std::size_t width;
};

py::tuple gaps(PoseJoint& joint, const py::object& given, const std::optional<double>& precision_deg,
               const std::optional<std::pair<py::object, py::object>>& out) {
  const std::vector<Pose> poses = poses_of(joint.joint(), given);
  Floats ball = gap_array(joint, Surface::ball, poses.size(), out ? out->first : py::none());
  Floats socket = gap_array(joint, Surface::socket, poses.size(), out ? out->second : py::none());
  const GapRows ball_gaps(ball);
  const GapRows socket_gaps(socket);
  std::array<std::vector<bool>, 2> used;
  without_lock(1, [&](std::size_t) {
    used = joint.alone([](const SessionJoint& of) { return std::array{of.ball.used, of.socket.used}; });
  });
  const auto scan_all = [&](const auto& packed) {
    without_lock(poses.size(), [&](std::size_t k) {
      scan_joint(packed, poses[k], ball_gaps.main(k, packed.ball.size()),
                 socket_gaps.main(k, packed.socket.size()));
      ball_gaps.leave_out(k, used[0], packed.ball.size());
      socket_gaps.leave_out(k, used[1], packed.socket.size());
    });
  };
  if (precision_deg)
    scan_all(joint.tables(*precision_deg));
  else
    scan_all(joint.cells());
  return py::make_tuple(ball, socket);
}

py::array touch(PoseJoint& joint, const py::object& given) {
  const std::vector<Pose> poses = poses_of(joint.joint(), given);
  const auto count = static_cast<py::ssize_t>(poses.size());
  py::array_t<bool> found(count);
  py::array_t<bool> unknown(count);
  bool* const touches = found.mutable_data();
  bool* const hangs = unknown.mutable_data();
  without_lock(poses.size(), [&](std::size_t k) {
    const Contact contact = joint.row(PosesOutput::touch, poses[k]).verdict->contact;
    touches[k] = contact == Contact::yes;
    hangs[k] = contact == Contact::unknown;
  });
  if (std::none_of(hangs, hangs + count, [](bool is) { return is; })) return found;
  return py::module_::import("numpy").attr("ma").attr("masked_array")(found, unknown);
}

// A row of the array that smallest_gap() returns.
struct SmallestRow {
  double gap_mm;
  double bound_mm;
  double clock;
  std::int64_t vertex;
  std::int64_t surface;
};

SmallestRow smallest_row(const std::optional<SmallestOfPose>& found) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!found) return {kNone, kNone, kNone, -1, -1};
  return {found->gap_mm, *found->error_bound_mm, found->hours.value_or(kNone),
          static_cast<std::int64_t>(found->vertex), found->surface == Surface::ball ? 0 : 1};
}

py::array smallest_gap(PoseJoint& joint, const py::object& given) {
  const std::vector<Pose> poses = poses_of(joint.joint(), given);
  py::array_t<SmallestRow> rows(static_cast<py::ssize_t>(poses.size()));
  SmallestRow* const row = rows.mutable_data();
  without_lock(poses.size(),
               [&](std::size_t k) { row[k] = smallest_row(joint.row(PosesOutput::gap, poses[k]).smallest); });
  return rows;
}

}  // namespace

void bind_pose_answers(JointClass& joint) {
  PYBIND11_NUMPY_DTYPE(SmallestRow, gap_mm, bound_mm, clock, vertex, surface);
  const auto none = py::none();
  joint
      .def("gaps", &gaps, py::arg("poses"), py::kw_only(), py::arg("precision_deg") = none,
           py::arg("out") = none,
           "gaps(self, poses, *, precision_deg=None, out=None)\n--\n\n"
           "Radial gaps in mm of all vertices of ball and socket, two float32 arrays of shape (poses, "
           "vertices): of the faces, or of tables of that spacing in 16 bits. NaN where the other surface is "
           "not met, and in cells of a table that it does not cover or jumps in.")
      .def("touch", &touch, py::arg("poses"),
           "touch(self, poses)\n--\n\n"
           "Do the surfaces touch or overlap, edges and all? Exact; bool, shape (poses,). Where that hangs "
           "on an "
           "opening of a mesh, it is not known, and the array is masked there.")
      .def("smallest_gap", &smallest_gap, py::arg("poses"),
           "smallest_gap(self, poses)\n--\n\n"
           "A structured array of shape (poses,): gap_mm, bound_mm (proven, on its error), clock (hours), "
           "vertex and surface (0 ball, 1 socket, -1 none).")
      .def(
          "matrices",
          [](const PoseJoint& self, const py::object& poses) {
            return matrices_of(self.joint(), poses_of(self.joint(), poses));
          },
          py::arg("poses"),
          "matrices(self, poses)\n--\n\n"
          "x' = M x of each pose in the frame of the meshes, mm; shape (poses, 4, 4).");
}

}  // namespace impinge::python
