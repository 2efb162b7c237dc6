// SPDX-License-Identifier: GPL-3.0-or-later
// What a user asks of one joint, as the options of the program `scene` say it.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "session/pose_question.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// What is asked of the pose, of which joint, and what becomes of the answer; lengths in mm. The outputs are
/// ball.ply, socket.ply and gaps.csv for the gaps, distances.csv, and what summary.json says of the others.
struct SceneOptions : PoseQuestion {
  std::filesystem::path ball;       // mesh file
  std::filesystem::path socket;     // mesh file
  std::filesystem::path out;        // folder that the files are written to
  std::optional<Vec3> centre;       // mm, input frame; fitted to the ball if not given
  std::string pose = "as scanned";  // the text that motion was read from
  std::optional<Side> side;         // of the body; abduction and rotation need it
  std::string axes = "RAS";         // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  std::optional<std::filesystem::path> cartilage_map;  // instead of one thickness (cartilage_file.hpp)
  std::optional<std::filesystem::path> poses;  // many poses, of a file (pose_list.hpp), instead of one
  std::optional<std::string> path;             // or of a grid of angles, which is well formed
  const MotionName* limit = nullptr;  // the motion whose limit is asked for, in place of the question
  bool everything = false;            // all gaps and all outputs, and nothing is left out on the way
  bool explain = false;               // what is left out is printed

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
