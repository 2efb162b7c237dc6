// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command/program.hpp"
#include "command/question_command.hpp"
#include "files/file_set.hpp"
#include "files/joined.hpp"
#include "hip/hip_presets.hpp"
#include "joint/pose_list.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_format.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPair = "pair";  // a ball in a socket with a known gap

struct HipOptions {
  std::string name = "normal";
  std::vector<std::string> changes;
  std::size_t faces = 12000;
  fs::path out;
  MeshFormat format = MeshFormat::ply;
};

void make(const HipOptions& options, std::ostream& out) {
  const bool pair = options.name == kPair;
  if (pair && !options.changes.empty())
    throw std::invalid_argument("--set: changes a hip, and the pair is none; leave it out");
  HipParameters parameters;
  in_field("NAME", [&] {
    if (!pair) parameters = hip_preset(options.name);
  });
  in_field("--set", [&] {
    for (const std::string& change : options.changes) set_hip_parameter(parameters, change);
  });
  const Hip made = pair ? Hip() : make_hip(parameters, options.faces);
  const BallSocketPair meshes = pair ? make_ball_socket_pair(options.faces) : main_surfaces(made);
  const AnswerFolder folder(options.out);
  FileSet files;
  const auto write = [&](const std::string& name, const TriangleMesh& mesh) {
    const fs::path file = options.out / (name + '.' + std::string(word_of(options.format)));
    files.add(file, mesh_bytes(file, mesh, {.axes = "RAS"}));
    return " " + file.string();
  };
  std::string written = write("ball", meshes.ball);
  written += write("socket", meshes.socket);
  std::string ask = written + " --side " + std::string(word_of(parameters.side));
  const auto add_parts = [&](const char* option, const TriangleMesh& mesh,
                             const std::vector<MeshPart>& parts) {
    for (std::size_t k = 0; k < parts.size(); ++k)
      ask += option + write(plain_name(parts[k].name), part_surface(mesh, parts, k));
  };
  add_parts(" --ball-part", made.ball, made.ball_parts);
  add_parts(" --socket-part", made.socket, made.socket_parts);
  files.commit();
  out << "wrote              " << written << ": a "
      << (pair ? "ball in a socket"
               : std::string(word_of(parameters.side)) + " hip, axes RAS, the centre at the origin\n" +
                     "ask it              impinge limits" + ask)
      << std::endl;
}

}  // namespace

void add_hip_command(CLI::App& program, const Screen& screen, std::function<void()>& work) {
  const auto options = std::make_shared<HipOptions>();
  CLI::App& app = *program.add_subcommand("hip", "A generated hip as two meshes, to try the questions on.");
  app.footer("Example: impinge hip cam --out cam_hip");
  const std::string names = kPair + (", " + joined(hip_preset_names()));
  app.add_option("NAME", options->name, names + " [normal]")->type_name("");
  app.add_option("--set", options->changes,
                 "a parameter of the hip (hip/hip_parameters.hpp has all); once or more")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--faces", options->faces, "of each surface, about [12000]")
      ->type_name("N")
      ->check(in_range({20, 1e8}, true));
  app.add_option("-o,--out", options->out, "folder for the meshes")->type_name("DIR")->required();
  add_word(app, "--mesh-format", options->format, "of the meshes");
  app.parse_complete_callback(
      [options, &screen, &work] { work = [options, &screen] { make(*options, screen.out); }; });
}

}  // namespace impinge
