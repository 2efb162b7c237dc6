// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip.hpp"

#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command/answer_files.hpp"
#include "command/joint_command.hpp"
#include "command/request_options.hpp"
#include "files/file_set.hpp"
#include "hip/hip_presets.hpp"
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

// Adds a mesh as a file of this name, and returns the name.
fs::path write(const HipOptions& options, const std::string& name, const TriangleMesh& mesh, FileSet& files) {
  fs::path file = options.out / (name + '.' + std::string(word_of(options.format)));
  files.add(file, mesh_bytes(file, mesh, {.axes = "RAS"}));
  return file;
}

// Adds each part of a mesh as a file of its name. Returns the option that gives these files to a question.
std::string write_parts(const HipOptions& options, const TriangleMesh& mesh,
                        const std::vector<MeshPart>& parts, const std::string& option, FileSet& files) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::string name = parts[k].name;
    for (char& c : name) c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    text += " " + option + " " + write(options, name, part_surface(mesh, parts, k), files).string();
  }
  return text;
}

std::string write_both(const HipOptions& options, const BallSocketPair& meshes, FileSet& files) {
  const fs::path ball = write(options, "ball", meshes.ball, files);
  return ball.string() + " " + write(options, "socket", meshes.socket, files).string();
}

void make(const HipOptions& options, std::ostream& out) {
  FileSet files;
  if (options.name == kPair) {
    if (!options.changes.empty())
      throw std::invalid_argument("--set: changes a hip, and the pair is none; leave it out");
    const AnswerFolder folder(options.out);
    const std::string both = write_both(options, make_ball_socket_pair(options.faces), files);
    files.commit();
    out << "wrote               " << both << ": a ball in a socket" << std::endl;
    return;
  }
  HipParameters parameters;
  in_field("NAME", [&] { parameters = hip_preset(options.name); });
  in_field("--set", [&] {
    for (const std::string& change : options.changes) set_hip_parameter(parameters, change);
  });
  const Hip made = make_hip(parameters, options.faces);
  const AnswerFolder folder(options.out);
  const std::string both = write_both(options, main_surfaces(made), files);
  const std::string ask = " " + both + " --side " + std::string(word_of(parameters.side)) +
                          write_parts(options, made.ball, made.ball_parts, "--ball-part", files) +
                          write_parts(options, made.socket, made.socket_parts, "--socket-part", files);
  files.commit();
  out << "wrote               " << both << ": a " << word_of(parameters.side)
      << " hip, axes RAS, the centre at the origin\nask it              impinge limits" << ask << std::endl;
}

std::vector<std::string> names() {
  std::vector<std::string> all{kPair};
  for (const std::string_view name : hip_preset_names()) all.emplace_back(name);
  return all;
}

}  // namespace

void add_hip_command(CLI::App& program, const Screen& screen, std::function<void()>& work) {
  const auto options = std::make_shared<HipOptions>();
  CLI::App& app = *program.add_subcommand("hip", "A generated hip as two meshes, to try the questions on.");
  app.footer("Example: impinge hip cam --out cam_hip");
  std::string listed;
  for (const std::string& name : names()) listed += (listed.empty() ? "" : ", ") + name;
  app.add_option("NAME", options->name, listed + " [normal]")->type_name("");
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
