// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own joint: two meshes in, gaps out.
//
//   scene --ball FILE --socket FILE [--centre fit|X,Y,Z] [--scheme NAME] [--precision DEG | --max-error MM]
//         [--pose "flexion=90,internal_rotation=10"] [--side left|right] [--axes RAS] [--cartilage MM] --out
//         DIR
//
// Exit code 0 on success, 1 when a mesh cannot be used, 2 for a wrong option. An error is one line on stderr.

#include <exception>
#include <iostream>
#include <new>

#include "files/file_bytes.hpp"
#include "files/one_line.hpp"
#include "scene/report.hpp"

namespace {

using namespace impinge;

int fail(const std::exception& error, int code) {
  const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  const char* what =
      memory ? "there is not enough memory; choose a coarser --precision or smaller meshes" : error.what();
  std::cerr << "scene: error: " << one_line(what) << std::endl;
  return code;
}

void run(const SceneOptions& options) {
  const Joint joint = load_joint(options);
  for (const std::string& warning : joint.warnings)
    std::cerr << "scene: warning: " << one_line(warning) << std::endl;
  const Measurement measurement = measure(joint, options);
  const nlohmann::json report = summary(options, joint, measurement);
  write_scene(options, joint, measurement, report);
  std::cout << describe_scene(report) << "wrote               " << options.out.string()
            << "/{ball.ply,socket.ply,gaps.csv,distances.csv,summary.json}" << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  SceneOptions options;
  try {
    std::string help;
    const auto parsed = parse_scene_options(argc, argv, help);
    if (!parsed) {
      std::cout << help;
      return 0;
    }
    options = *parsed;
    require_writable_folder(options.out);
  } catch (const std::exception& error) {
    return fail(error, 2);
  }
  try {
    run(options);
  } catch (const std::exception& error) {
    return fail(error, 1);
  }
  return 0;
}
