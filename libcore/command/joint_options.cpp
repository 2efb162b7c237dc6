// SPDX-License-Identifier: GPL-3.0-or-later
#include "command/joint_options.hpp"

#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "command/request_options.hpp"
#include "files/finite_number.hpp"
#include "files/formatted.hpp"
#include "joint/cartilage_file.hpp"
#include "joint/landmark_file.hpp"
#include "joint/rest_contact.hpp"
#include "mesh/declared_axes.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/mesh_pieces.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

// "scan" takes the scan's smallest gap, a number is one thickness, anything else is a file.
void set_cartilage(const std::string& text, JointOptions& options) {
  options.cartilage_of_scan = text == "scan";
  if (options.cartilage_of_scan) return;
  const std::optional<double> value = finite_number(text);
  std::error_code unreadable;
  if (!value && fs::exists(text, unreadable)) {
    options.cartilage_map = text;
  } else if (value && *value >= 0.0) {
    options.cartilage_mm = *value;
  } else {
    throw CLI::ValidationError("--cartilage",
                               "'" + text +
                                   "' is no thickness and no file; give a number of mm, 0 or more, "
                                   "scan, or a CSV of x,y,z,thickness_mm");
  }
}

// Reads a file of bone. With keep_largest it keeps only the largest piece, and `said` tells of the others.
TriangleMesh read_file(const fs::path& file, bool keep_largest, std::vector<std::string>& said) {
  TriangleMesh mesh = read_mesh(file);
  if (!keep_largest) return mesh;
  const std::string left_out = keep_largest_piece(mesh);
  if (!left_out.empty()) said.push_back(file.string() + ": " + left_out);
  return mesh;
}

// A part is named after its file.
NamedMesh read_bone(const fs::path& file, const std::vector<fs::path>& parts, bool keep_largest,
                    std::vector<std::string>& said) {
  NamedMesh bone{file.string(), read_file(file, keep_largest, said)};
  for (const fs::path& part : parts) {
    append_part(bone.mesh, bone.parts, part.stem().string(), read_file(part, keep_largest, said));
    bone.part_names.push_back(part.string());
  }
  return bone;
}

std::string describe_taken(const fs::path& file, Surface of, const JointPart& part) {
  if (!part.taken) return "";
  return formatted("%-20s%zu of %zu faces of %s, within %.1f mm of the centre%s; the rest counts as bone\n",
                   name(of).data(), part.taken->faces, part.taken->of, file.filename().string().c_str(),
                   part.taken->within_mm, of == Surface::ball ? "" : " and looking to it");
}

std::vector<std::string> texts_of(const std::vector<fs::path>& files) {
  std::vector<std::string> texts;
  texts.reserve(files.size());
  for (const fs::path& file : files) texts.push_back(file.string());
  return texts;
}

}  // namespace

void use_description(const CLI::App& command, const JointDescription& said, JointOptions& options) {
  for_each_field<JointDescription>([&](const auto& field) {
    const CLI::Option* option = command.get_option_no_throw(option_name(field.name));
    if (option != nullptr && option->count() == 0)
      field.of(static_cast<JointDescription&>(options)) = field.of(said);
  });
  // Kept also where the command has no option for it, so that it can say so.
  if (command.get_option_no_throw("--cartilage") == nullptr) options.cartilage_mm = said.cartilage_mm;
}

std::function<void()> add_joint_options(CLI::App& command, JointOptions& options) {
  const auto describe = [](CLI::Option* option, const char* type) {
    return option->type_name(type)->group("The joint");
  };
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    return describe(command.add_option(name, value, text), type);
  };
  const auto read = [&](const char* name, const char* type, const char* text, const auto& use) {
    const auto used = [use, name, &options](const std::string& word) { use(word, name, options); };
    describe(command.add_option_function<std::string>(name, used, text), type);
  };
  using Text = const std::string&;
  add("--ball-part", options.ball_parts, "FILE",
      "bone beside the ball that can stop it, such as a trochanter; one or more")
      ->allow_extra_args(false);
  add("--socket-part", options.socket_parts, "FILE", "the same beside the socket; one or more")
      ->allow_extra_args(false);
  read("--side", "left|right", "of the body; abduction and rotation need it",
       [](Text word, const char* name, JointOptions& of) { read_json(word, name, {}, of.side); });
  read("--axes", "CODE",
       "where +x, +y and +z of the meshes point: R/L, A/P, S/I [as their headers say, else RAS]",
       [](Text code, const char* name, JointOptions& of) {
         in_field(name, [&] { input_to_joint(code); });
         of.axes = code;
       });
  read("--centre", "fit|X,Y,Z", "of rotation: that of the sphere that fits the ball, or a place in mm [fit]",
       [](Text text, const char* name, JointOptions& of) {
         if (text != "fit") of.centre = place_option(name, text);
       });
  add("--landmarks", options.landmarks, "FILE",
      "points of 3D Slicer (.mrk.json, .fcsv, its table), or a CSV label,x,y,z, that give the frames of "
      "pelvis and femur");
  read("--cartilage", "MM|scan|FILE",
       "thickness of both layers together in mm, for gaps, limits, report and the areas of poses; scan: the "
       "smallest gap as scanned; FILE: a CSV of x,y,z,thickness_mm, for gaps and report [none for limits, "
       "else 4]",
       [](Text text, const char* /*name*/, JointOptions& of) { set_cartilage(text, of); });
  read("--keep", "all|largest", "of each file all pieces, or the largest alone [all]",
       [](Text word, const char* name, JointOptions& of) {
         constexpr std::array<std::string_view, 2> kWords{"all", "largest"};
         of.keep_largest = place_among(word, kWords, name) == 1;
       });
  add("--overlap", options.overlap_mm, "MM",
      "depth along a ray to which the surfaces may overlap without contact [0]")
      ->check(in_range(kNotNegative))
      ->excludes(
          describe(command.add_flag("--ignore-rest-contact", options.ignore_rest_contact,
                                    "accept the contact of the scan: --overlap with the least tenth of a "
                                    "millimetre that leaves none"),
                   ""));
  add("--config", options.config, "FILE",
      "JSON with side, axes, centre, parts, landmarks, cartilage_mm of the joint");
  return [&command, &options] {
    if (options.config)
      use_description(command, read_description(*options.config, OtherKeys::refused), options);
  };
}

std::vector<fs::path> files_of(const JointOptions& options) {
  std::vector<fs::path> files{options.ball, options.socket};
  for (const auto& more : {options.landmarks, options.cartilage_map, options.config}) {
    if (more) files.push_back(*more);
  }
  files.insert(files.end(), options.ball_parts.begin(), options.ball_parts.end());
  files.insert(files.end(), options.socket_parts.begin(), options.socket_parts.end());
  return files;
}

JointNames names_of(const JointOptions& options) {
  return {options.ball.string(), options.socket.string(), texts_of(options.ball_parts),
          texts_of(options.socket_parts)};
}

Session load_joint(const JointOptions& options, const ScanContactOptions& told) {
  JointInput input;
  std::vector<std::string> said;
  input.ball = read_bone(options.ball, options.ball_parts, options.keep_largest, said);
  input.socket = read_bone(options.socket, options.socket_parts, options.keep_largest, said);
  input.centre = options.centre;
  input.side = options.side;
  std::vector<fs::path> meshes{options.ball, options.socket};
  for (const auto* parts : {&options.ball_parts, &options.socket_parts})
    meshes.insert(meshes.end(), parts->begin(), parts->end());
  input.axes = agreed_axes_of(meshes, options.axes, "--axes").code;
  input.wording.meshes = "BALL and SOCKET";
  const auto made = [&](double overlap_mm) {
    input.overlap_mm = overlap_mm;
    Joint joint = assemble_joint(input);
    require_mm(joint, input.ball.name);
    if (options.cartilage_map) joint.cartilage = read_cartilage(*options.cartilage_map, joint.centre);
    if (options.landmarks) use_landmarks(*options.landmarks, options.side, joint);
    joint.warnings.insert(joint.warnings.end(), said.begin(), said.end());
    return Session(std::move(joint), options.side, input.axes);
  };
  Session session = options.ignore_rest_contact ? without_rest_contact(made, "--ignore-rest-contact")
                                                : made(options.overlap_mm);
  warn_of_contact(*session.joint, told);
  return session;
}

std::string describe_joint(const JointOptions& options, const Joint& joint) {
  std::string text = describe_taken(options.ball, Surface::ball, joint.ball) +
                     describe_taken(options.socket, Surface::socket, joint.socket);
  if (!options.axes && joint.axes != "RAS")
    text += "axes                " + joint.axes + ", as the headers of the meshes say\n";
  if (options.ignore_rest_contact)
    text += joint.overlap_mm > 0.0
                ? formatted("rest contact        ignored: the ball is taken %g mm smaller along each ray\n",
                            joint.overlap_mm)
                : "rest contact        none: there is nothing to ignore\n";
  if (!joint.frames) return text;
  text +=
      formatted("landmarks           pelvic tilt %.1f degrees in the scan", joint.frames->pelvic_tilt_deg);
  if (const auto& scanned = joint.frames->scanned) {
    return text +
           formatted(
               ", the femur at flexion %.1f, abduction %.1f, internal rotation %.1f: angles are counted from "
               "neutral\n",
               scanned->flexion, scanned->abduction, scanned->internal_rotation);
  }
  return text + ": angles are counted from the pose of the scan\n";
}

}  // namespace impinge
