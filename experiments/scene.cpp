// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own joint: two meshes in, gaps out.
//
//   scene --ball FILE --socket FILE [--centre fit|X,Y,Z] [--scheme NAME] [--precision DEG | --max-error MM]
//         [--pose "flexion=90,internal_rotation=10"] [--side left|right] [--axes RAS] [--cartilage MM|FILE]
//         [--question touch|first-contact|limit|all-gaps] [--motion NAME] [--surfaces both|ball|socket]
//         [--outputs gaps,bounds,distances,verdicts] [--explain] [--everything] --out DIR
//
// Exit code 0 on success, 1 when a mesh cannot be used, 2 for a wrong option. An error is one line on stderr.

#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "files/file_bytes.hpp"
#include "files/one_line.hpp"
#include "scene/limit.hpp"
#include "scene/question.hpp"
#include "scene/report.hpp"
#include "scene/scene_files.hpp"

namespace {

using namespace impinge;

int fail(const std::exception& error, int code) {
  const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  const char* what =
      memory ? "there is not enough memory; choose a coarser --precision or smaller meshes" : error.what();
  std::cerr << "scene: error: " << one_line(what) << std::endl;
  return code;
}

// Names of files, as a person reads them.
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return names.size() > 1 ? "{" + text + "}" : text;
}

void say_what_was_written(const SceneOptions& options) {
  std::cout << "wrote               " << options.out.string() << "/" << listed(scene_files(options))
            << std::endl;
  const std::vector<std::string> older = older_files(options);
  if (older.empty()) return;
  std::cerr << "scene: warning: "
            << one_line(options.out.string() + "/" + listed(older) +
                        " is left from an earlier scene: it says nothing about this one")
            << std::endl;
}

// Writes all that was asked for and says what it found.
void run_all_gaps(const Joint& joint, const SceneOptions& options) {
  const Measurement measurement = measure(joint, options);
  const nlohmann::json report = summary(options, joint, measurement);
  write_scene(options, joint, measurement, report);
  std::cout << describe_scene(report);
  if (options.explain) std::cout << describe_way(report["way"]) << describe_left_out(report["left_out"]);
  say_what_was_written(options);
}

void run_question(const Joint& joint, const SceneOptions& options) {
  const nlohmann::json report = question_summary(options, joint, answer_question(joint, options));
  write_if_changed(options.out / "summary.json", json_text(report));
  std::cout << describe_question(report);
  if (options.explain) std::cout << describe_way(report["way"]) << describe_left_out(report["left_out"]);
  say_what_was_written(options);
}

void run_limit(const Joint& joint, const SceneOptions& options) {
  const nlohmann::json report = limit_summary(options, joint);
  write_if_changed(options.out / "summary.json", json_text(report));
  std::cout << describe_limits(report);
  say_what_was_written(options);
}

void run(const SceneOptions& options) {
  const Joint joint = load_joint(options);
  for (const std::string& warning : joint.warnings)
    std::cerr << "scene: warning: " << one_line(warning) << std::endl;
  if (options.limit != nullptr) return run_limit(joint, options);
  options.question == Question::all_gaps ? run_all_gaps(joint, options) : run_question(joint, options);
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
