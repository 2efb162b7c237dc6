// SPDX-License-Identifier: GPL-3.0-or-later
// What a user asks of one joint, as the options of the program `scene` say it.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "detection/needs.hpp"
#include "joint/motion.hpp"
#include "sphere/direction.hpp"

namespace impinge {

// What is written besides the answer to the question.
struct SceneOutputs {
  bool gaps = true;       // ball.ply, socket.ply and gaps.csv
  bool bounds = true;     // proven, of the error of every gap
  bool distances = true;  // brackets of Euclidean distances: distances.csv
  bool verdicts = true;   // exact, on vertices and surfaces; they rest on the bounds
};

struct SceneOptions {
  std::filesystem::path ball;
  std::filesystem::path socket;
  std::filesystem::path out;
  std::optional<Vec3> centre;  // mm, input frame; fitted to the ball if not given
  std::string scheme = "rsid";
  double precision_deg = 0.5;
  std::optional<double> max_error_mm;  // chooses the precision instead
  Motion motion;
  std::string pose = "as scanned";  // the text that motion was read from
  std::optional<Side> side;
  std::string axes = "RAS";
  double cartilage_mm = 4.0;                           // both layers together; the thesis' value
  std::optional<std::filesystem::path> cartilage_map;  // instead of one thickness (cartilage_file.hpp)
  Question question = Question::all_gaps;
  const MotionName* limit = nullptr;  // the motion whose limit is asked for, in place of the question
  bool scan_ball = true;              // the first scan: vertices of the ball against the socket
  bool scan_socket = true;
  SceneOutputs outputs;     // none of them with another question than all_gaps
  bool everything = false;  // all gaps and all outputs, and nothing is left out on the way
  bool explain = false;     // what is left out is printed
};

// A wrong option: what() is one line that names it and says what to do.
class OptionError : public std::invalid_argument {
 public:
  explicit OptionError(const std::string& message);
};

// Reads a command line. std::nullopt after --help, whose text is then in `help`; OptionError if it cannot be
// used.
std::optional<SceneOptions> parse_scene_options(int argc, const char* const* argv, std::string& help);

}  // namespace impinge
