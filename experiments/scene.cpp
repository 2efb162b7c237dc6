// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own joint: two meshes in, gaps out.
//
//   scene --ball FILE --socket FILE [--centre fit|X,Y,Z] [--scheme NAME] [--precision DEG | --max-error MM]
//         [--pose "flexion=90,internal_rotation=10" | --poses FILE | --path "flexion=0..120/1"] [--side
//         left|right] [--axes RAS] [--cartilage MM|FILE]
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
#include "files/stopwatch.hpp"
#include "scene/limit.hpp"
#include "scene/poses.hpp"
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
void run_all_gaps(Session& session, const SceneOptions& options) {
  const SessionJoint& joint = *session.joint;
  const Measurement found = measure(session, options);
  write_scene(options, joint, found, summary(options, joint, found));
  std::cout << describe_scene(options, joint, found);
  if (options.explain) std::cout << describe_way(found.way, found.left_out, edge_on_faces(joint.joint));
}

void run_question(const Session& session, const SceneOptions& options) {
  const QuestionAnswer found = answer_question(*session.joint, options);
  write_if_changed(options.out / "summary.json", json_text(question_summary(options, *session.joint, found)));
  std::cout << describe_question(options, found);
  if (options.explain) std::cout << describe_way(found.answer.way, found.answer.left_out);
}

void run_limit(Session& session, const SceneOptions& options) {
  Stopwatch watch;
  const LimitAnswers found = answer_limits(session, limit_request(options));
  write_if_changed(options.out / "summary.json",
                   json_text(limit_summary(options, *session.joint, found, watch.lap_ms())));
  std::cout << describe_limits(options, found);
}

void run_poses(const Session& session, const SceneOptions& options) {
  const nlohmann::json found = answer_poses(options, *session.joint, std::cerr);
  write_if_changed(options.out / "summary.json", json_text(found));
  std::cout << describe_poses(found);
  if (options.explain) std::cout << describe_way(kWayOfPoses, {});
}

void run(const SceneOptions& options) {
  Session session = load_joint(options);
  for (const std::string& warning : session.joint->joint.warnings)
    std::cerr << "scene: warning: " << one_line(warning) << std::endl;
  if (options.many()) {
    run_poses(session, options);
  } else if (options.limit != nullptr) {
    run_limit(session, options);
  } else if (options.question == Question::all_gaps) {
    run_all_gaps(session, options);
  } else {
    run_question(session, options);
  }
  say_what_was_written(options);
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
