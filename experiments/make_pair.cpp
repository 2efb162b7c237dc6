// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a generated joint as meshes, for trying `scene` without a joint of one's own: the ball-and-socket
// pair with a known gap, or a hip.
//
//   make_pair [--hip NAME [--set parameter=value ...]] [--faces N] --out DIR

#include <exception>
#include <iostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "files/file_bytes.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"

namespace {

using namespace impinge;

std::string listed(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

struct Joint {
  BallSocketPair meshes;
  std::string what;  // as the user is told
};

Joint make_joint(const std::string& hip, const std::vector<std::string>& changes, std::size_t faces) {
  if (hip.empty()) return {make_ball_socket_pair(faces), "a ball in a socket"};
  HipParameters parameters = hip_preset(hip);
  for (const std::string& change : changes) set_hip_parameter(parameters, change);
  Hip made = make_hip(parameters, faces);
  const std::string side = parameters.side == Side::left ? "left" : "right";
  return {{std::move(made.ball), std::move(made.socket)}, "a " + side + " hip, axes RAS"};
}

int run(int argc, char** argv) {
  CLI::App app{"Writes ball.ply and socket.ply of the generated joint.", "make_pair"};
  std::size_t faces = 12000;
  std::filesystem::path out;
  std::string hip;
  std::vector<std::string> changes;
  CLI::Option* name = app.add_option("--hip", hip, "a hip instead: " + listed(hip_preset_names()));
  app.add_option("--set", changes,
                 "parameter=value of the hip, once or more; libcore/hip/hip_parameters.hpp has all")
      ->needs(name);
  app.add_option("--faces", faces,
                 "triangles of each surface; of the pair an even number, of a hip about so many")
      ->capture_default_str();
  app.add_option("--out", out, "folder for the two meshes")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  }
  const auto [pair, what] = make_joint(hip, changes, faces);
  require_writable_folder(out);
  write_mesh(out / "ball.ply", pair.ball);
  write_mesh(out / "socket.ply", pair.socket);
  std::cout << "wrote " << (out / "{ball.ply,socket.ply}").string() << ": " << what
            << ", the centre at the origin\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "make_pair: error: " << error.what() << std::endl;
    return 2;
  }
}
