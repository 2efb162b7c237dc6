// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the generated ball-and-socket pair as meshes, for trying `scene` without a joint of one's own.
//
//   make_pair --faces N --out DIR

#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "files/file_bytes.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/io.hpp"

namespace {

using namespace impinge;

int run(int argc, char** argv) {
  CLI::App app{"Writes ball.ply and socket.ply of the generated joint.", "make_pair"};
  std::size_t faces = 12000;
  std::filesystem::path out;
  app.add_option("--faces", faces, "triangles of each surface, an even number")->capture_default_str();
  app.add_option("--out", out, "folder for the two meshes")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  }
  require_writable_folder(out);
  const BallSocketPair pair = make_ball_socket_pair(faces);
  write_mesh(out / "ball.ply", pair.ball);
  write_mesh(out / "socket.ply", pair.socket);
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
