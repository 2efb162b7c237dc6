// SPDX-License-Identifier: GPL-3.0-or-later
// From files, arrays or parameters to a joint.
#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <variant>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "joint/landmark_file.hpp"
#include "mesh/declared_axes.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_pieces.hpp"
#include "mesh/raw_mesh.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"

namespace impinge::python {
namespace {

using OptionalPoint = std::optional<std::array<double, 3>>;

// Landmarks are a file, or points by their labels.
using Marked = std::variant<std::filesystem::path, py::dict>;

Landmarks points_of(const py::dict& given) {
  Landmarks points;
  for (const auto& [label, place] : given) {
    const auto name = py::str(label).cast<std::string>();
    const Doubles numbers = Doubles::ensure(place);
    if (!numbers) PyErr_Clear();
    if (!numbers || numbers.ndim() != 1 || numbers.size() != 3)
      throw std::invalid_argument("landmarks: '" + name + "' is no place; give (x, y, z) in mm");
    try {
      add_landmark(name, Vec3(numbers.at(0), numbers.at(1), numbers.at(2)), points);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("landmarks: " + std::string(error.what()) +
                                  "; give each once, (x, y, z) in mm");
    }
  }
  return points;
}

// Of "all" and "largest"; says what it left out.
std::string keep_pieces(const std::string& keep, NamedMesh& of) {
  if (keep != "all" && keep != "largest")
    throw std::invalid_argument("keep: '" + keep + "' is no choice of pieces; give all or largest");
  const std::string left_out = keep == "all" ? "" : keep_largest_piece(of.mesh);
  return left_out.empty() ? left_out : of.name + ": " + left_out;
}

// What is known of a joint beside its meshes.
struct Placed {
  std::optional<std::string> side;
  std::string axes;
  OptionalPoint centre;
  std::optional<Marked> landmarks;
  std::string keep = "all";
  double overlap_mm = 0.0;
};

SharedJoint joint_of(JointInput input, const Placed& placed) {
  if (!(placed.overlap_mm >= 0.0 && placed.overlap_mm < std::numeric_limits<double>::infinity()))
    throw std::invalid_argument("overlap_mm: is no length; give a number of mm, 0 or more");
  input.axes = placed.axes;
  input.overlap_mm = placed.overlap_mm;
  if (placed.side) input.side = parse_side(*placed.side);
  if (placed.centre) input.centre = Vec3((*placed.centre)[0], (*placed.centre)[1], (*placed.centre)[2]);
  input.wording = {"with centre=(x, y, z)", "ball and socket",
                   "axes= first (3D Slicer and DICOM have LPS), then side=", "keep=\"largest\""};
  const std::optional<Side> side = input.side;
  const auto* const dict = placed.landmarks ? std::get_if<py::dict>(&*placed.landmarks) : nullptr;
  const Landmarks points = dict != nullptr ? points_of(*dict) : Landmarks{};
  SharedJoint joint;
  {
    const py::gil_scoped_release released;
    input_to_joint(input.axes);
    const std::array said{keep_pieces(placed.keep, input.ball), keep_pieces(placed.keep, input.socket)};
    Joint made = assemble_joint(std::move(input));
    std::ranges::copy_if(said, std::back_inserter(made.warnings),
                         [](const std::string& line) { return !line.empty(); });
    if (dict != nullptr)
      use_landmarks(points, "landmarks", side, made);
    else if (placed.landmarks)
      use_landmarks(std::get<std::filesystem::path>(*placed.landmarks), side, made);
    joint = std::make_shared<PoseJoint>(std::move(made), side, placed.axes);
  }
  return joint;
}

// Joints that a user brings may be wrong.
SharedJoint with_warnings(SharedJoint joint) {
  for (const std::string& line : joint->joint().joint.warnings) warn(line);
  return joint;
}

py::dict keywords_of(const Placed& placed) {
  return py::dict(py::arg("side") = placed.side, py::arg("axes") = placed.axes,
                  py::arg("centre") = placed.centre, py::arg("landmarks") = placed.landmarks,
                  py::arg("keep") = placed.keep, py::arg("overlap_mm") = placed.overlap_mm);
}

SharedJoint read_joint(const std::filesystem::path& ball, const std::filesystem::path& socket,
                       const std::optional<std::string>& side, const std::optional<std::string>& axes,
                       const OptionalPoint& centre, const std::optional<Marked>& landmarks,
                       const std::string& keep, double overlap_mm) {
  JointInput input;
  std::string code;
  {
    const py::gil_scoped_release released;
    input.ball = {ball.string(), read_mesh(ball)};
    input.socket = {socket.string(), read_mesh(socket)};
    code = agreed_axes(ball, socket, axes, "axes=").code;
  }
  const Placed placed{side, code, centre, landmarks, keep, overlap_mm};
  SharedJoint joint = with_warnings(joint_of(std::move(input), placed));
  joint->made_by = py::make_tuple("read", py::make_tuple(ball, socket), keywords_of(placed));
  return joint;
}

using MeshArrays = std::pair<Doubles, Indices>;

NamedMesh mesh_of_arrays(const char* name, const MeshArrays& arrays) {
  const auto& [vertices, faces] = arrays;
  for (const py::array& array : {py::array(vertices), py::array(faces)}) {
    if (array.ndim() != 2 || array.shape(1) != 3)
      throw std::invalid_argument(std::string(name) +
                                  ": give vertices and faces as two arrays of three columns");
  }
  return {name, mesh_of(name, {{vertices.data(), static_cast<std::size_t>(vertices.size())},
                               {faces.data(), static_cast<std::size_t>(faces.size())}})};
}

SharedJoint joint_of_arrays(const MeshArrays& ball, const MeshArrays& socket,
                            const std::optional<std::string>& side, const std::string& axes,
                            const OptionalPoint& centre, const std::optional<Marked>& landmarks,
                            const std::string& keep, double overlap_mm) {
  JointInput input;
  input.ball = mesh_of_arrays("ball", ball);
  input.socket = mesh_of_arrays("socket", socket);
  const Placed placed{side, axes, centre, landmarks, keep, overlap_mm};
  SharedJoint joint = with_warnings(joint_of(std::move(input), placed));
  const auto copied = [](const MeshArrays& of) {  // the caller may change them
    return py::make_tuple(of.first.attr("copy")(), of.second.attr("copy")());
  };
  joint->made_by =
      py::make_tuple("from_arrays", py::make_tuple(copied(ball), copied(socket)), keywords_of(placed));
  return joint;
}

// As the programs type it.
std::string setting_of(const std::string& name, const py::handle& value) {
  if (py::isinstance<py::str>(value)) return name + "=" + value.cast<std::string>();
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value.cast<double>()).ptr;
  return name + "=" + std::string(text, end);
}

SharedJoint joint_of_hip(const std::string& preset, std::size_t faces, const py::kwargs& changes) {
  HipParameters parameters = hip_preset(preset);
  for (const auto& [name, value] : changes)
    set_hip_parameter(parameters, setting_of(name.cast<std::string>(), value));
  Hip hip = [&] {
    const py::gil_scoped_release others;
    return make_hip(parameters, faces);
  }();
  JointInput input;
  input.ball = {"ball", std::move(hip.ball), std::move(hip.ball_parts)};
  input.socket = {"socket", std::move(hip.socket), std::move(hip.socket_parts)};
  SharedJoint joint =
      joint_of(std::move(input),
               {parameters.side == Side::left ? "left" : "right", "RAS", std::array{0.0, 0.0, 0.0}, {}});
  py::dict keywords(**changes);
  keywords["faces"] = faces;
  joint->made_by = py::make_tuple("from_hip", py::make_tuple(preset), keywords);
  return joint;
}

// By the function that made it: files are read again.
SharedJoint joint_of_state(const py::tuple& made) {
  const py::object make = py::type::of<PoseJoint>().attr(made[0].cast<py::str>());
  return make(*made[1].cast<py::tuple>(), **made[2].cast<py::dict>()).cast<SharedJoint>();
}

}  // namespace

void bind_making(JointClass& joint) {
  const auto none = py::none();
  joint
      .def_static(
          "read", &read_joint, py::arg("ball"), py::arg("socket"), py::kw_only(), py::arg("side") = none,
          py::arg("axes") = none, py::arg("centre") = none, py::arg("landmarks") = none,
          py::arg("keep") = "all", py::arg("overlap_mm") = 0.0,
          "A joint of two mesh files in one frame, mm. side: left or right; axes: where +x, +y and +z "
          "point; centre: (x, y, z), fitted to the ball where it is not given; "
          "landmarks: marked points, of a file or a dict, which give the frames; keep: all, or of each mesh "
          "the largest piece; overlap_mm: along a ray, that is no contact.")
      .def_static("from_arrays", &joint_of_arrays, py::arg("ball"), py::arg("socket"), py::kw_only(),
                  py::arg("side") = none, py::arg("axes") = "RAS", py::arg("centre") = none,
                  py::arg("landmarks") = none, py::arg("keep") = "all", py::arg("overlap_mm") = 0.0,
                  "The same of two pairs of vertices (n, 3) in mm and faces (m, 3).")
      .def_static("from_hip", &joint_of_hip, py::arg("preset") = "normal", py::kw_only(),
                  py::arg("faces") = kHipFaces, "A hip made from parameters, each a keyword.")
      .def(py::pickle([](const PoseJoint& self) { return self.made_by; }, &joint_of_state));
}

}  // namespace impinge::python
