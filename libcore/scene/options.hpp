// SPDX-License-Identifier: GPL-3.0-or-later
// What a user asks of one joint by the options of the program `scene`.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "gap/surface.hpp"
#include "joint/pose_question.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// Asks what would have to change so that required motions are reached.
struct ChangeOptions {
  bool of_socket = false;               // the socket's orientation (orientation.csv), else a resection
  std::vector<Motion> required;         // degrees; each along its own path (change/required_motion.hpp)
  std::string text;                     // that `required` was read from
  double clearance_mm = 0.5;            // of a resection
  std::optional<double> least_neck_mm;  // of a resection: see ResectRequest
  bool least = false;                   // of a resection: the least cut of all too (swept.csv)
  Surface cut = Surface::ball;          // of a resection
  std::optional<double> most_rim_mm;    // of a resection of the socket: see ResectRequest
  double tilt_deg = 0.0;                // of an orientation: of the pelvis backwards
};

/// How finely the motion volume is worked out, and what counts as contact.
struct VolumeOptions {
  double width = 0.05;            // share of all rotations that may stay undecided
  double gap_mm = 0.0;            // gaps up to this count as contact
  double centre_within_mm = 0.0;  // the answer holds for every common centre within this distance
};

/// All options of a scene: the pose and question, the joint, and the outputs. Lengths in mm. Of
/// PoseQuestion::outputs, gaps go to ball.ply, socket.ply and gaps.csv, distances to distances.csv, the
/// others to summary.json.
struct SceneOptions : PoseQuestion {
  std::filesystem::path ball;    // mesh file
  std::filesystem::path socket;  // mesh file
  /// Meshes of bone beside the ball, in the same frame (mesh/mesh_parts.hpp).
  std::vector<std::filesystem::path> ball_parts;
  std::vector<std::filesystem::path> socket_parts;  // beside the socket
  bool keep_largest = false;                        // of each file only the largest piece
  double overlap_mm = 0.0;                          // along a ray, that is no contact (hip/joint.hpp)
  std::filesystem::path out;                        // folder that the files are written to
  std::optional<Vec3> centre;                       // mm, input frame; fitted to the ball if not given
  std::string pose = "as scanned";                  // the text that PoseQuestion::motion was read from
  std::optional<Side> side;                         // of the body; abduction and rotation need it
  std::string axes = "RAS";  // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  bool axes_given = false;   // else a header of the meshes may say other ones (mesh/declared_axes.hpp)
  std::optional<std::filesystem::path> landmarks;      // file that gives the frames (landmark_file.hpp)
  std::optional<std::filesystem::path> cartilage_map;  // instead of one thickness (cartilage_file.hpp)
  std::optional<std::filesystem::path> poses;  // file of many poses (pose_list.hpp), instead of one pose
  std::optional<std::string> path;             // or a grid of angles for parse_pose_grid(), checked
  const MotionName* limit = nullptr;    // the motion whose limit is asked for, in place of the question
  std::string motion_asked;             // as --motion has it: limit's name, one of named_motions(), or all
  bool all_motions = false;             // all of named_motions(), each from its own start
  bool measures = false;                // measures are asked for, in place of the question
  std::optional<VolumeOptions> volume;  // all rotations are asked for, in place of the question
  std::optional<ChangeOptions> change;  // what would have to change, in place of the question
  std::optional<std::filesystem::path> bones;  // every joint of this folder, instead of ball and socket
  /// File for a proof of the pose or motion (proof_file.hpp).
  std::optional<std::filesystem::path> certificate;
  bool everything = false;  // all gaps and all outputs, and nothing is left out on the way
  bool areas = false;       // impinged areas of each of many poses, too
  bool explain = false;     // print what is left out

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
