// SPDX-License-Identifier: GPL-3.0-or-later
// What a user asks of one joint, as the options of the program `scene` say it.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "session/pose_question.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// What would have to change so that motions are reached.
struct ChangeOptions {
  bool of_socket = false;               // its orientation, to orientation.csv; else the ball's resection
  std::vector<Motion> required;         // degrees; each along its own path (motion/required_motion.hpp)
  std::string text;                     // that they were read from
  double clearance_mm = 0.5;            // of a resection
  std::optional<double> least_neck_mm;  // of a resection
  bool least = false;                   // the least cut of all too, to swept.csv
  double tilt_deg = 0.0;                // of the pelvis, of an orientation
};

/// How much of all rotations may stay undecided, and what counts as contact.
struct VolumeOptions {
  double width = 0.05;            // share of all rotations
  double gap_mm = 0.0;            // mm, as contact
  double centre_within_mm = 0.0;  // for every common centre within that
};

/// What is asked of the pose, of which joint, and what becomes of the answer; lengths in mm. The outputs are
/// ball.ply, socket.ply and gaps.csv for the gaps, distances.csv, and what summary.json says of the others.
struct SceneOptions : PoseQuestion {
  std::filesystem::path ball;    // mesh file
  std::filesystem::path socket;  // mesh file
  /// Meshes of bone beside them, in the same frame (mesh/mesh_parts.hpp).
  std::vector<std::filesystem::path> ball_parts;
  std::vector<std::filesystem::path> socket_parts;  // beside the socket
  std::filesystem::path out;                        // folder that the files are written to
  std::optional<Vec3> centre;                       // mm, input frame; fitted to the ball if not given
  std::string pose = "as scanned";                  // the text that motion was read from
  std::optional<Side> side;                         // of the body; abduction and rotation need it
  std::string axes = "RAS";  // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  bool axes_given = false;   // else a header of the meshes may say other ones (mesh/declared_axes.hpp)
  std::optional<std::filesystem::path> landmarks;      // that give the frames (scene/landmark_file.hpp)
  std::optional<std::filesystem::path> cartilage_map;  // instead of one thickness (cartilage_file.hpp)
  std::optional<std::filesystem::path> poses;  // many poses, of a file (pose_list.hpp), instead of one
  std::optional<std::string> path;             // or of a grid of angles, which is well formed
  const MotionName* limit = nullptr;    // the motion whose limit is asked for, in place of the question
  std::string motion_asked;             // as --motion has it: limit's name, one of named_motions(), or all
  bool all_motions = false;             // of named_motions(), each from its own start
  bool measures = false;                // of ball and socket are asked for, in place of the question
  std::optional<VolumeOptions> volume;  // all rotations are asked for, in place of the question
  std::optional<ChangeOptions> change;  // what would have to change, in place of the question
  std::optional<std::filesystem::path> bones;  // every joint of this folder, instead of ball and socket
  /// File for a proof of the pose or motion (proof_file.hpp).
  std::optional<std::filesystem::path> certificate;
  bool everything = false;  // all gaps and all outputs, and nothing is left out on the way
  bool areas = false;       // of many poses impinged areas too
  bool explain = false;     // what is left out is printed

  /// Are there many poses, to be answered by poses.csv (scene/poses.hpp)?
  bool many() const { return poses || path; }
};

/// A wrong option: what() is one line that names it and says what to do.
class OptionError : public std::invalid_argument {
 public:
  explicit OptionError(const std::string& message);  // message: the line
};

/// Reads a command line. std::nullopt after --help, whose text is then in `help`; OptionError if it cannot be
/// used.
std::optional<SceneOptions> parse_scene_options(int argc, const char* const* argv, std::string& help);

}  // namespace impinge
