// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a generated joint as meshes, for trying `scene` without a joint of one's own: the ball-and-socket
// pair with a known gap, or a hip. Trochanters and AIIS of a hip are files of their own.
//
//   make_pair [--hip NAME [--set parameter=value ...]] [--faces N] --out DIR

#include <cctype>
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
#include "hip/joint.hpp"
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
  std::vector<NamedMesh> ball_parts{};
  std::vector<NamedMesh> socket_parts{};
};

// The parts of a mesh, each called as its file is to be.
std::vector<NamedMesh> take_parts(const TriangleMesh& mesh, const std::vector<MeshPart>& parts) {
  std::vector<NamedMesh> taken;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::string name = parts[k].name;
    for (char& c : name) c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    taken.push_back({name + ".ply", part_surface(mesh, parts, k)});
  }
  return taken;
}

// Writes them, and returns what `scene` is to be told of them.
std::string write_parts(const std::filesystem::path& out, const std::vector<NamedMesh>& parts,
                        const std::string& option) {
  std::string text;
  for (const NamedMesh& part : parts) {
    write_mesh(out / part.name, part.mesh);
    text += (text.empty() ? " " + option + " " : " ") + (out / part.name).string();
  }
  return text;
}

Joint make_joint(const std::string& hip, const std::vector<std::string>& changes, std::size_t faces) {
  if (hip.empty()) return {make_ball_socket_pair(faces), "a ball in a socket"};
  HipParameters parameters = hip_preset(hip);
  for (const std::string& change : changes) set_hip_parameter(parameters, change);
  Hip made = make_hip(parameters, faces);
  const std::string side = parameters.side == Side::left ? "left" : "right";
  return {main_surfaces(made), "a " + side + " hip, axes RAS", take_parts(made.ball, made.ball_parts),
          take_parts(made.socket, made.socket_parts)};
}

int run(int argc, char** argv) {
  CLI::App app{"Writes ball.ply and socket.ply of a ball in a socket, or with --hip of a hip.", "make_pair"};
  std::size_t faces = 12000;
  std::filesystem::path out;
  std::string hip;
  std::vector<std::string> changes;
  CLI::Option* name = app.add_option("--hip", hip, "kind of hip: " + listed(hip_preset_names()));
  app.add_option("--set", changes,
                 "parameter=value of the hip, once or more; libcore/hip/hip_parameters.hpp has all")
      ->needs(name);
  app.add_option("--faces", faces,
                 "triangles of each surface: even for the ball in a socket, approximate for a hip")
      ->capture_default_str();
  app.add_option("--out", out, "folder for the two meshes")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  }
  const auto [pair, what, ball_parts, socket_parts] = make_joint(hip, changes, faces);
  require_writable_folder(out);
  write_mesh(out / "ball.ply", pair.ball);
  write_mesh(out / "socket.ply", pair.socket);
  std::cout << "wrote " << (out / "{ball.ply,socket.ply}").string() << ": " << what
            << ", the centre at the origin\n";
  const std::string parts =
      write_parts(out, ball_parts, "--ball-part") + write_parts(out, socket_parts, "--socket-part");
  if (!parts.empty()) std::cout << "bone beside it; add to scene:" << parts << "\n";
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
