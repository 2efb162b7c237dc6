// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/joint.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "files/formatted.hpp"
#include "joint/cartilage_file.hpp"
#include "joint/landmark_file.hpp"
#include "joint/scan_contact.hpp"
#include "mesh/declared_axes.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/mesh_pieces.hpp"
#include "scene/scene_files.hpp"

namespace impinge {
namespace {

// The output has fixed names; in the folder of the input it could replace it.
void require_other_folder(const SceneOptions& options) {
  std::vector<std::filesystem::path> inputs{options.ball, options.socket};
  for (const auto& more : {options.cartilage_map, options.poses, options.landmarks}) {
    if (more) inputs.push_back(*more);
  }
  inputs.insert(inputs.end(), options.ball_parts.begin(), options.ball_parts.end());
  inputs.insert(inputs.end(), options.socket_parts.begin(), options.socket_parts.end());
  for (const std::filesystem::path& input : inputs) {
    std::error_code ignored;
    if (options.certificate && std::filesystem::equivalent(input, *options.certificate, ignored)) {
      throw std::runtime_error(
          input.string() + ": would be replaced by the certificate; choose another file with --certificate");
    }
    for (const std::string& name : every_scene_file()) {
      if (std::filesystem::equivalent(input, options.out / name, ignored)) {
        throw std::runtime_error(input.string() +
                                 ": would be replaced by the output; choose another folder with --out");
      }
    }
  }
}

std::string axes_of(const SceneOptions& options) {
  const auto given = options.axes_given ? std::optional(options.axes) : std::nullopt;
  const AxesChoice choice = agreed_axes(options.ball, options.socket, given, "--axes");
  return choice.from == "assumed" ? options.axes : choice.code;
}

// A file of bone, or the largest of its pieces alone, which `said` then tells.
TriangleMesh read_file(const std::filesystem::path& file, bool keep_largest, std::vector<std::string>& said) {
  TriangleMesh mesh = read_mesh(file);
  if (!keep_largest) return mesh;
  const std::string left_out = keep_largest_piece(mesh);
  if (!left_out.empty()) said.push_back(file.string() + ": " + left_out);
  return mesh;
}

// A part is called as its file is.
NamedMesh read_bone(const std::filesystem::path& file, const std::vector<std::filesystem::path>& parts,
                    bool keep_largest, std::vector<std::string>& said) {
  NamedMesh bone{file.string(), read_file(file, keep_largest, said)};
  for (const std::filesystem::path& part : parts) {
    append_part(bone.mesh, bone.parts, part.stem().string(), read_file(part, keep_largest, said));
    bone.part_names.push_back(part.string());
  }
  return bone;
}

// A gap of this size or less counts as contact too, where one is asked about.
void warn_of_start(const SceneOptions& options, SessionJoint& joint) {
  ScanContactOptions told{.overlap = "--overlap", .threshold_mm = 0.0, .threshold = "--cartilage"};
  if (options.limit != nullptr) told.threshold_mm = options.cartilage_mm;
  if (options.volume) told = {"--overlap", options.volume->gap_mm, "--gap"};
  warn_of_contact(joint, told);
}

}  // namespace

Session load_joint(const SceneOptions& options) {
  require_other_folder(options);
  JointInput input;
  std::vector<std::string> said;
  input.ball = read_bone(options.ball, options.ball_parts, options.keep_largest, said);
  input.socket = read_bone(options.socket, options.socket_parts, options.keep_largest, said);
  input.centre = options.centre;
  input.side = options.side;
  input.axes = axes_of(options);
  input.overlap_mm = options.overlap_mm;
  Joint joint = assemble_joint(std::move(input));
  if (options.cartilage_map) joint.cartilage = read_cartilage(*options.cartilage_map, joint.centre);
  if (options.landmarks) use_landmarks(*options.landmarks, options.side, joint);
  joint.warnings.insert(joint.warnings.end(), said.begin(), said.end());
  const std::string axes = joint.axes;
  Session session(std::move(joint), options.side, axes);
  warn_of_start(options, *session.joint);
  return session;
}

std::string describe_taken(const SceneOptions& options, const Joint& joint) {
  std::string text;
  for (const Surface of : kSurfaces) {
    const bool ball = of == Surface::ball;
    const auto& taken = (ball ? joint.ball : joint.socket).taken;
    if (!taken) continue;
    text +=
        formatted("%-20s%zu of %zu faces of %s, within %.1f mm of the centre%s; the rest counts as bone\n",
                  name(of).data(), taken->faces, taken->of,
                  (ball ? options.ball : options.socket).filename().string().c_str(), taken->within_mm,
                  ball ? "" : " and looking to it");
  }
  return text;
}

std::string describe_frames(const SceneOptions& options, const Joint& joint) {
  std::string text;
  if (!options.axes_given && joint.axes != options.axes)
    text += "axes                " + joint.axes + ", as the headers of the meshes say\n";
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
