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

py::tuple arrays_of(const TriangleMesh& mesh) {
  const auto rows = [](const auto& list) { return static_cast<py::ssize_t>(list.size()); };
  return py::make_tuple(
      py::array_t<double>({rows(mesh.vertices), py::ssize_t{3}}, mesh.vertices.front().data()),
      py::array_t<std::uint32_t>({rows(mesh.faces), py::ssize_t{3}}, mesh.faces.front().data()));
}

// Of a file too: a joint that is made again may be elsewhere.
std::optional<Marked> as_dict(const std::optional<Marked>& given, const std::string& axes) {
  if (!given || std::holds_alternative<py::dict>(*given)) return given;
  const Landmarks read = read_landmarks(std::get<std::filesystem::path>(*given), input_to_joint(axes));
  py::dict points;
  const auto add = [&points](const char* label, const std::optional<Vec3>& place) {
    if (place) points[label] = point_tuple(*place);
  };
  add("asis_right", read.asis_right);
  add("asis_left", read.asis_left);
  add("pubic_tubercle_right", read.pubic_tubercle_right);
  add("pubic_tubercle_left", read.pubic_tubercle_left);
  add("epicondyle_medial", read.epicondyle_medial);
  add("epicondyle_lateral", read.epicondyle_lateral);
  return points;
}

// The joint, which remembers what it was made of.
SharedJoint joint_of_meshes(const JointInput& input, const Placed& placed) {
  SharedJoint joint = joint_of(input, placed);
  joint->made_of = py::make_tuple(input.ball.name, arrays_of(input.ball.mesh), input.socket.name,
                                  arrays_of(input.socket.mesh), placed.side, placed.axes, placed.centre,
                                  as_dict(placed.landmarks, placed.axes), placed.keep, placed.overlap_mm);
  return joint;
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
  return with_warnings(joint_of_meshes(input, {side, code, centre, landmarks, keep, overlap_mm}));
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
  return with_warnings(joint_of_meshes(input, {side, axes, centre, landmarks, keep, overlap_mm}));
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
  joint->made_of = py::make_tuple(preset, faces, changes);
  return joint;
}

TriangleMesh mesh_of_state(const py::handle& state) {
  const auto [vertices, faces] = state.cast<MeshArrays>();
  const auto points = python::points_of(vertices);
  TriangleMesh mesh{{points.begin(), points.end()},
                    std::vector<Face>(static_cast<std::size_t>(faces.shape(0)))};
  std::copy_n(faces.data(), faces.size(), mesh.faces.front().data());
  return mesh;
}

// What it was told of when it was first made is not told again.
SharedJoint made_again(const py::tuple& state) {
  if (state.size() == 3)
    return joint_of_hip(state[0].cast<std::string>(), state[1].cast<std::size_t>(), py::kwargs(state[2]));
  JointInput input;
  input.ball = {state[0].cast<std::string>(), mesh_of_state(state[1])};
  input.socket = {state[2].cast<std::string>(), mesh_of_state(state[3])};
  return joint_of_meshes(input, {state[4].cast<std::optional<std::string>>(), state[5].cast<std::string>(),
                                 state[6].cast<OptionalPoint>(), state[7].cast<std::optional<Marked>>(),
                                 state[8].cast<std::string>(), state[9].cast<double>()});
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
      .def(py::pickle([](const PoseJoint& made) { return made.made_of; }, &made_again));
}

}  // namespace impinge::python
