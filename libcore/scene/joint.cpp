// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/joint.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "mesh/io.hpp"
#include "scene/cartilage_file.hpp"
#include "scene/scene_files.hpp"

namespace impinge {
namespace {

// The output has fixed names; in the folder of the input it could replace it.
void require_other_folder(const SceneOptions& options) {
  std::vector<std::filesystem::path> inputs{options.ball, options.socket};
  for (const auto& more : {options.cartilage_map, options.poses}) {
    if (more) inputs.push_back(*more);
  }
  for (const std::filesystem::path& input : inputs) {
    for (const std::string& name : every_scene_file()) {
      std::error_code ignored;
      if (std::filesystem::equivalent(input, options.out / name, ignored)) {
        throw std::runtime_error(input.string() +
                                 ": would be replaced by the output; choose another folder with --out");
      }
    }
  }
}

}  // namespace

Session load_joint(const SceneOptions& options) {
  require_other_folder(options);
  JointInput input;
  input.ball = {options.ball.string(), read_mesh(options.ball)};
  input.socket = {options.socket.string(), read_mesh(options.socket)};
  input.centre = options.centre;
  input.side = options.side;
  input.axes = options.axes;
  Joint joint = assemble_joint(std::move(input));
  if (options.cartilage_map) joint.cartilage = read_cartilage(*options.cartilage_map, joint.centre);
  return {std::move(joint), options.side, options.axes};
}

}  // namespace impinge
