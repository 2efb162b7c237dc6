// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a joint from files, arrays or parameters.
#include <algorithm>
#include <array>
#include <concepts>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <variant>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "joint/cartilage_file.hpp"
#include "joint/landmark_file.hpp"
#include "joint/rest_contact.hpp"
#include "mesh/declared_axes.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_pieces.hpp"
#include "mesh/raw_mesh.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"

namespace impinge::python {
namespace {

using OptionalPoint = std::optional<std::array<double, 3>>;

// Landmarks: a file, or points by their labels.
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

// What is known of a joint besides its meshes.
struct Placed {
  std::optional<std::string> side;
  std::string axes;
  OptionalPoint centre;
  std::optional<Marked> landmarks;
  std::optional<double> overlap_mm = 0.0;  // none: the least for which nothing touches as scanned
  std::vector<std::string> said{};         // about pieces that were left out
  std::function<CartilageMap(const Vec3& centre)> cartilage{};
};

SharedJoint joint_of(JointInput input, const Placed& placed) {
  input.axes = placed.axes;
  if (placed.side) input.side = parse_side(*placed.side);
  if (placed.centre) input.centre = Vec3((*placed.centre)[0], (*placed.centre)[1], (*placed.centre)[2]);
  input.wording = {"with centre=(x, y, z)", "ball and socket",
                   "axes= first (3D Slicer and DICOM have LPS), then side=", "keep=\"largest\""};
  const std::optional<Side> side = input.side;
  const auto* const dict = placed.landmarks ? std::get_if<py::dict>(&*placed.landmarks) : nullptr;
  const Landmarks points = dict != nullptr ? points_of(*dict) : Landmarks{};
  const auto made = [&](double overlap_mm) {
    input.overlap_mm = overlap_mm;
    Joint joint = assemble_joint(input);
    require_mm(joint, input.ball.name);
    if (placed.cartilage) joint.cartilage = placed.cartilage(joint.centre);
    if (dict != nullptr)
      use_landmarks(points, "landmarks", side, joint);
    else if (placed.landmarks)
      use_landmarks(std::get<std::filesystem::path>(*placed.landmarks), side, joint);
    joint.warnings.insert(joint.warnings.end(), placed.said.begin(), placed.said.end());
    return Session(std::move(joint), side, placed.axes);
  };
  const py::gil_scoped_release released;
  input_to_joint(input.axes);
  return std::make_shared<PoseJoint>(
      placed.overlap_mm ? made(*placed.overlap_mm) : without_rest_contact(made, "ignore_rest_contact"),
      JointNames{input.ball.name, input.socket.name, input.ball.part_names, input.socket.part_names});
}

// Landmarks as points. A file is read here, since the joint may be made again on another machine.
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

py::tuple state_of(const NamedMesh& bone) {
  py::list parts;
  for (const MeshPart& part : bone.parts)
    parts.append(py::make_tuple(part.name, part.first_vertex, part.first_face, part.of_main));
  const py::tuple mesh =
      py::make_tuple(array_of<double>(bone.mesh.vertices), array_of<std::uint32_t>(bone.mesh.faces));
  return py::make_tuple(bone.name, mesh, parts, bone.part_names);
}

// Makes a joint that remembers what it was made of.
SharedJoint joint_of_meshes(const JointInput& input, const Placed& placed) {
  SharedJoint made = joint_of(input, placed);
  const Joint& joint = made->joint().joint;
  py::object cartilage = py::none();
  if (const auto& map = joint.cartilage)
    cartilage = py::make_tuple(array_of<double>(map->directions), map->thickness);
  made->made_of =
      py::make_tuple(state_of(input.ball), state_of(input.socket), placed.side, placed.axes, placed.centre,
                     as_dict(placed.landmarks, placed.axes), joint.overlap_mm, placed.said, cartilage);
  return made;
}

using MeshArrays = std::pair<Doubles, Indices>;
using File = std::filesystem::path;
using GivenMesh = std::variant<File, MeshArrays>;

TriangleMesh mesh_of_arrays(const std::string& name, const MeshArrays& arrays) {
  const auto& [vertices, faces] = arrays;
  for (const py::array& array : {py::array(vertices), py::array(faces)}) {
    if (array.ndim() != 2 || array.shape(1) != 3)
      throw std::invalid_argument(name + ": give vertices and faces as two arrays of three columns");
  }
  if (faces.shape(0) == 0)
    throw std::invalid_argument(name +
                                ": has no faces; give a row with the places of three vertices for each");
  return mesh_of(name, {{vertices.data(), static_cast<std::size_t>(vertices.size())},
                        {faces.data(), static_cast<std::size_t>(faces.size())}});
}

// Reads a mesh, with "all" its pieces or the "largest", and says what was left out. `name` is for arrays.
TriangleMesh mesh_of_given(const std::string& name, const GivenMesh& given, const std::string& keep,
                           std::vector<std::string>& said) {
  if (keep != "all" && keep != "largest")
    throw std::invalid_argument("keep: '" + keep + "' is no choice of pieces; give all or largest");
  const auto* const file = std::get_if<File>(&given);
  const auto read = [&] {
    const py::gil_scoped_release released;
    return read_mesh(*file);
  };
  TriangleMesh mesh = file != nullptr ? read() : mesh_of_arrays(name, std::get<MeshArrays>(given));
  const std::string left_out = keep == "all" ? "" : keep_largest_piece(mesh);
  if (!left_out.empty()) said.push_back((file != nullptr ? file->string() : name) + ": " + left_out);
  return mesh;
}

// Bone beside the ball or socket. Answers name it by its file without the ending, or by the dict's key.
std::vector<std::pair<std::string, GivenMesh>> parts_of(const char* keyword, const py::object& given) {
  std::vector<std::pair<std::string, GivenMesh>> parts;
  const auto add_file = [&parts](const File& file) { parts.emplace_back(file.stem().string(), file); };
  try {
    if (given.is_none()) return parts;
    if (py::isinstance<py::dict>(given)) {
      for (const auto& [name, mesh] : given.cast<py::dict>())
        parts.emplace_back(name.cast<std::string>(), mesh.cast<GivenMesh>());
    } else {
      const auto files = given.cast<std::variant<File, std::vector<File>>>();
      if (const auto* const one = std::get_if<File>(&files))
        add_file(*one);
      else
        for (const File& file : std::get<1>(files)) add_file(file);
    }
  } catch (const py::cast_error&) {
    throw std::invalid_argument(std::string(keyword) +
                                ": is no bone; give a file, a list of files, or a dict of names, each with a "
                                "file or with (vertices, faces)");
  }
  return parts;
}

NamedMesh bone_of(const std::string& name, const GivenMesh& main, const char* keyword,
                  const py::object& beside, const std::string& keep, std::vector<std::string>& said,
                  std::vector<File>& files) {
  const auto called = [](const std::string& key, const GivenMesh& given) {
    const auto* const file = std::get_if<File>(&given);
    return file != nullptr ? file->string() : key;
  };
  const auto add_file = [&files](const GivenMesh& given) {
    if (const auto* const file = std::get_if<File>(&given)) files.push_back(*file);
  };
  NamedMesh bone{called(name, main), mesh_of_given(name, main, keep, said)};
  add_file(main);
  for (const auto& [key, given] : parts_of(keyword, beside)) {
    append_part(bone.mesh, bone.parts, key, mesh_of_given(key, given, keep, said));
    bone.part_names.push_back(called(key, given));
    add_file(given);
  }
  return bone;
}

// The thickness of cartilage from a file, or from rows of x, y, z and thickness.
std::function<CartilageMap(const Vec3&)> cartilage_of(
    const std::optional<std::variant<File, Doubles>>& given) {
  if (!given) return {};
  if (const auto* const file = std::get_if<File>(&*given))
    return [file = *file](const Vec3& centre) { return read_cartilage(file, centre); };
  const auto rows = std::get<Doubles>(*given);
  if (rows.ndim() != 2 || rows.shape(1) != 4 || rows.shape(0) == 0)
    throw std::invalid_argument(
        "cartilage_map: give a file, or an array of shape (n, 4): x, y, z and thickness in mm");
  std::vector<std::array<double, 4>> points(static_cast<std::size_t>(rows.shape(0)));
  std::copy_n(rows.data(), rows.size(), points.front().data());
  return [points](const Vec3& centre) {
    CartilageMap map;
    for (const auto& point : points) {
      try {
        add_cartilage(point, centre, map);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("cartilage_map: row " + std::to_string(&point - points.data()) + " " +
                                    error.what() + "; give x, y, z and thickness in mm");
      }
    }
    return map;
  };
}

// Makes a joint from two files, or from two pairs of arrays.
template <class Given>
SharedJoint joint_of_given(const Given& ball, const Given& socket, const std::optional<std::string>& side,
                           const std::optional<std::string>& axes, const OptionalPoint& centre,
                           const std::optional<Marked>& landmarks, const std::string& keep, double overlap_mm,
                           const py::object& ball_part, const py::object& socket_part,
                           const std::optional<std::variant<File, Doubles>>& cartilage_map,
                           bool ignore_rest_contact) {
  if (!(overlap_mm >= 0.0 && overlap_mm < std::numeric_limits<double>::infinity()))
    throw std::invalid_argument("overlap_mm: is no length; give a number of mm, 0 or more");
  if (ignore_rest_contact && overlap_mm > 0.0)
    throw std::invalid_argument("overlap_mm: ignore_rest_contact finds it; give one of them");
  JointInput input;
  Placed placed{side, axes.value_or("RAS"), centre, landmarks};
  std::vector<File> files;
  input.ball = bone_of("ball", ball, "ball_part", ball_part, keep, placed.said, files);
  input.socket = bone_of("socket", socket, "socket_part", socket_part, keep, placed.said, files);
  placed.axes = agreed_axes_of(files, axes, "axes=").code;
  placed.cartilage = cartilage_of(cartilage_map);
  placed.overlap_mm = ignore_rest_contact ? std::nullopt : std::optional(overlap_mm);
  SharedJoint joint = joint_of_meshes(input, placed);
  for (const std::string& line : joint->joint().joint.warnings) warn(line);  // a user's meshes may be wrong
  return joint;
}

// A parameter as text, as on the command line.
std::string setting_of(const std::string& name, const py::handle& value) {
  const py::str text =
      py::isinstance<py::str>(value) ? py::str(value) : py::str(py::float_(value.cast<double>()));
  return name + "=" + text.cast<std::string>();
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

NamedMesh bone_of_state(const py::tuple& state) {
  NamedMesh bone{
      state[0].cast<std::string>(), mesh_of_state(state[1]), {}, state[3].cast<std::vector<std::string>>()};
  for (const py::handle part : py::list(state[2])) {
    const auto [name, vertex, face, of_main] =
        part.cast<std::tuple<std::string, std::size_t, std::size_t, bool>>();
    bone.parts.push_back({name, vertex, face, of_main});
  }
  return bone;
}

CartilageMap cartilage_of_state(const py::tuple& state) {
  const Doubles given = state[0].cast<Doubles>();
  const auto directions = python::points_of(given);
  return {{directions.begin(), directions.end()}, state[1].cast<std::vector<double>>()};
}

// Makes a joint again; warnings of the first time are not repeated.
SharedJoint made_again(const py::tuple& state) {
  if (state.size() == 3)
    return joint_of_hip(state[0].cast<std::string>(), state[1].cast<std::size_t>(), py::kwargs(state[2]));
  JointInput input;
  input.ball = bone_of_state(state[0]);
  input.socket = bone_of_state(state[1]);
  Placed placed{state[2].cast<std::optional<std::string>>(),
                state[3].cast<std::string>(),
                state[4].cast<OptionalPoint>(),
                state[5].cast<std::optional<Marked>>(),
                state[6].cast<double>(),
                state[7].cast<std::vector<std::string>>()};
  if (!state[8].is_none())
    placed.cartilage = [map = cartilage_of_state(state[8])](const Vec3& /*centre*/) { return map; };
  return joint_of_meshes(input, placed);
}

template <class Given>
void def_making(JointClass& joint, const char* name, const py::object& axes, const char* text) {
  const auto none = py::none();
  const std::string doc = name + std::string("(ball, socket, *, side=None, axes=") +
                          py::repr(axes).cast<std::string>() +
                          ", centre=None, landmarks=None, keep='all', overlap_mm=0.0, ball_part=None, "
                          "socket_part=None, cartilage_map=None, ignore_rest_contact=False)\n--\n\n" +
                          text;
  joint.def_static(name, &joint_of_given<Given>, py::arg("ball"), py::arg("socket"), py::kw_only(),
                   py::arg("side") = none, py::arg("axes") = axes, py::arg("centre") = none,
                   py::arg("landmarks") = none, py::arg("keep") = "all", py::arg("overlap_mm") = 0.0,
                   py::arg("ball_part") = none, py::arg("socket_part") = none,
                   py::arg("cartilage_map") = none, py::arg("ignore_rest_contact") = false, doc.c_str());
}

}  // namespace

void bind_making(JointClass& joint) {
  def_making<File>(
      joint, "read", py::none(),
      "A joint of two mesh files in one frame, mm. side: left or right; axes: where +x, +y and +z "
      "point; centre: (x, y, z), fitted to the ball where it is not given; "
      "landmarks: marked points, of a file or a dict, which give the frames; keep: all, or of each mesh "
      "the largest piece; overlap_mm: along a ray, that is no contact; ball_part, socket_part: bone beside "
      "them, as files or a dict of names; cartilage_map: its thickness by place, a file or an array (n, 4), "
      "which gaps and report use alone; "
      "ignore_rest_contact: with the least overlap_mm that leaves no contact as scanned.");
  def_making<MeshArrays>(joint, "from_arrays", py::str("RAS"),
                         "The same of two pairs of vertices (n, 3) in mm and faces (m, 3).");
  joint
      .def_static("from_hip", &joint_of_hip, py::arg("preset") = "normal", py::kw_only(),
                  py::arg("faces") = kHipFaces,
                  "from_hip(preset='normal', *, faces=12000, **parameters)\n--\n\n"
                  "A hip made from parameters, each a keyword.")
      .def(py::pickle([](const PoseJoint& made) { return made.made_of; }, &made_again));
}

}  // namespace impinge::python
