// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: for any command line, parse_scene_options() returns options that are in their ranges, a help
// text, or throws OptionError with one line that names an option. Words are parted by
// NUL.
#include <cmath>
#include <vector>

#include "fuzz/require.hpp"
#include "hip/anatomy.hpp"
#include "scene/options.hpp"

namespace {

using namespace impinge;
using test::require;

// What is asked about, and what is written of it, go together.
void require_consistent_question(const SceneOptions& options) {
  const PoseOutputs& outputs = options.outputs;
  const bool any = outputs.gaps || outputs.bounds || outputs.distances || outputs.verdicts;
  require(any == (options.question == Question::all_gaps), "all gaps have outputs, other questions none");
  require(options.limit == nullptr || !any, "a limit has no outputs of tables");
  require(options.limit == nullptr || largest_growth(options.motion, *options.limit) > 0.0,
          "a motion has room");
  require(options.scan_ball || options.scan_socket, "a surface is looked up");
  const bool both = options.scan_ball && options.scan_socket;
  require(both || !(outputs.bounds || outputs.distances || outputs.verdicts),
          "comparisons need both surfaces");
  const bool all = both && outputs.gaps && outputs.bounds && outputs.distances && outputs.verdicts;
  require(all || !options.everything, "everything is everything");
}

void require_in_range(const SceneOptions& options) {
  require(!options.ball.empty() && !options.socket.empty() && !options.out.empty(), "files have names");
  require(!options.centre || options.centre->allFinite(), "a centre is finite");
  require(!options.precision_deg || (*options.precision_deg > 0.0 && *options.precision_deg <= 180.0),
          "a precision is an angle");
  require(!options.max_error_mm || (*options.max_error_mm > 0.0 && std::isfinite(*options.max_error_mm)),
          "an error is above 0");
  require(options.cartilage_mm >= 0.0 && std::isfinite(options.cartilage_mm), "a thickness is 0 or more");
  require(!options.change || (options.change->clearance_mm > 0.0 && !options.change->required.empty()),
          "a change has motions and a clearance");
  require_consistent_question(options);
  const Eigen::Matrix3d turn = joint_rotation(options.motion, options.side) * input_to_joint(options.axes);
  require((turn * turn.transpose()).isIdentity(1e-12), "a pose is a rotation");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);  // ends with a NUL of its own
  std::vector<const char*> words{"scene"};
  for (std::size_t i = 0; i < text.size();
       i = text.find('\0', i) == text.npos ? text.size() : text.find('\0', i) + 1)
    words.push_back(text.data() + i);
  std::string help;
  try {
    const auto options = parse_scene_options(static_cast<int>(words.size()), words.data(), help);
    if (options) {
      require_in_range(*options);
    } else {
      require(help.find("--ball") != std::string::npos, "help names the options", help);
    }
  } catch (const OptionError& error) {
    test::require_one_line(error.what());
    require(std::string(error.what()).find("--") != std::string::npos, "an option is named", error.what());
  }
  return 0;
}
