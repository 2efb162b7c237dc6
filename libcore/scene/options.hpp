// SPDX-License-Identifier: GPL-3.0-or-later
// What a user asks of one joint, as the options of the program `scene` say it.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "hip/motion.hpp"
#include "planning/needs.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// What is written besides the answer to the question.
struct SceneOutputs {
  bool gaps = true;       // ball.ply, socket.ply and gaps.csv
  bool bounds = true;     // proven, of the error of every gap
  bool distances = true;  // brackets of Euclidean distances: distances.csv
  bool verdicts = true;   // exact, on vertices and surfaces; they rest on the bounds
};

/// One member an option; lengths in mm, angles in degrees.
struct SceneOptions {
  std::filesystem::path ball;          // mesh file
  std::filesystem::path socket;        // mesh file
  std::filesystem::path out;           // folder that the files are written to
  std::optional<Vec3> centre;          // mm, input frame; fitted to the ball if not given
  std::string scheme = "rsid";         // name of the sampling scheme
  double precision_deg = 0.5;          // of the tables
  std::optional<double> max_error_mm;  // chooses the precision instead
  Motion motion;                       // of the femur from the pose of the scan
  std::string pose = "as scanned";     // the text that motion was read from
  std::optional<Side> side;            // of the body; abduction and rotation need it
  std::string axes = "RAS";            // where +x, +y and +z of the meshes point (hip/anatomy.hpp)
  double cartilage_mm = 4.0;           // both layers together; the thesis' value
  std::optional<std::filesystem::path> cartilage_map;  // instead of one thickness (cartilage_file.hpp)
  Question question = Question::all_gaps;              // what is asked of the pose
  const MotionName* limit = nullptr;  // the motion whose limit is asked for, in place of the question
  bool scan_ball = true;              // the first scan: vertices of the ball against the socket
  bool scan_socket = true;            // the second scan
  SceneOutputs outputs;               // none of them with another question than all_gaps
  bool everything = false;            // all gaps and all outputs, and nothing is left out on the way
  bool explain = false;               // what is left out is printed
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
