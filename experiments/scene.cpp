// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own joint: two meshes in, gaps out.
//
//   scene --ball FILE --socket FILE --out DIR ...      (scene --help; experiments/scene.md)
//
// Exit code 0 on success, 1 when a mesh cannot be used, 2 for a wrong option. An error is one line on stderr.

#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "files/file_bytes.hpp"
#include "files/one_line.hpp"
#include "files/stopwatch.hpp"
#include "scene/bones.hpp"
#include "scene/limit.hpp"
#include "scene/limit_table.hpp"
#include "scene/measure_table.hpp"
#include "scene/orientation.hpp"
#include "scene/poses.hpp"
#include "scene/proof_file.hpp"
#include "scene/question.hpp"
#include "scene/report.hpp"
#include "scene/resection.hpp"
#include "scene/scene_files.hpp"
#include "scene/volume.hpp"

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

std::filesystem::path without_slash(const std::filesystem::path& folder) {
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

// The nearest folder above it that is there.
std::filesystem::path existing(const std::filesystem::path& of) {
  std::error_code unreadable;
  std::filesystem::path folder = without_slash(of);
  while (!std::filesystem::exists(folder, unreadable)) folder = folder.parent_path();
  return folder;
}

// The folders above and below that were made for an answer that there is not.
void remove_empty(const std::filesystem::path& of, const std::filesystem::path& above) {
  std::error_code kept;
  std::filesystem::path folder = without_slash(of);
  while (folder != above && std::filesystem::remove(folder, kept)) folder = folder.parent_path();
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
  std::cout << describe_question(options, session.joint->joint, found);
  if (options.explain) std::cout << describe_way(found.way, found.answer.left_out);
}

void run_limit(Session& session, const SceneOptions& options) {
  Stopwatch watch;
  const LimitAnswers found = answer_limits(session, limit_request(options));
  write_if_changed(options.out / "summary.json",
                   json_text(limit_summary(options, *session.joint, found, watch.lap_ms())));
  std::cout << describe_limits(options, found);
}

void run_resection(Session& session, const SceneOptions& options) {
  Stopwatch watch;
  const ResectAnswer found = answer(session, resection_request(options));
  const SessionJoint& joint = *session.joint;
  write_resection(options, found, resection_summary(options, joint, found, watch.lap_ms()));
  std::cout << describe_resection(options, found);
}

void run_orientation(Session& session, const SceneOptions& options) {
  Stopwatch watch;
  const OrientAnswer found = answer(session, orientation_request(options));
  write_orientation(options, found, orientation_summary(options, *session.joint, found, watch.lap_ms()));
  std::cout << describe_orientation(options, found);
}

void run_motions(Session& session, const SceneOptions& options) {
  Stopwatch watch;
  const std::vector<MotionLimits> found = answer_motions(session, options);
  Table table = limit_table();
  add_limits("", found, table);
  write_if_changed(options.out / "limits.csv", to_csv(table));
  write_if_changed(options.out / "summary.json",
                   json_text(limits_summary(options, *session.joint, found, watch.lap_ms())));
  std::cout << describe_motions(found);
}

void run_measures(const Session& session, const SceneOptions& options) {
  const std::vector<MeasureRow> found = answer_measures(*session.joint);
  Table table = measure_table();
  add_measure_rows("", found, table);
  write_if_changed(options.out / "measures.csv", to_csv(table));
  write_if_changed(options.out / "summary.json", json_text(measures_summary(options, *session.joint, found)));
  std::cout << describe_measures(found);
}

void run_bones(const SceneOptions& options) {
  const nlohmann::json found = answer_bones(options, std::cerr);
  write_if_changed(options.out / "summary.json", json_text(found));
  std::cout << describe_bones(options, found);
  say_what_was_written(options);
}

void run_poses(const Session& session, const SceneOptions& options) {
  const nlohmann::json found = answer_poses(options, *session.joint, std::cerr);
  write_if_changed(options.out / "summary.json", json_text(found));
  std::cout << describe_poses(found);
  if (options.explain) std::cout << describe_way(kWayOfPoses, {});
}

// Before all else: what cannot be proven leaves no files.
void run_proof(Session& session, const SceneOptions& options) {
  const ClearanceProof found = proof_asked(session, options);
  write_if_changed(*options.certificate, proof_text(found));
  std::cout << describe_proof(options, found);
}

void run(const SceneOptions& options) {
  if (options.bones) return run_bones(options);
  Session session = load_joint(options);
  std::cout << describe_taken(options, session.joint->joint)
            << describe_frames(options, session.joint->joint);
  for (const std::string& warning : session.joint->joint.warnings)
    std::cerr << "scene: warning: " << one_line(warning) << std::endl;
  if (options.certificate) run_proof(session, options);
  if (options.volume) {
    std::cout << write_volume(options, session, std::cerr).words;
  } else if (options.many()) {
    run_poses(session, options);
  } else if (options.all_motions) {
    run_motions(session, options);
  } else if (options.limit != nullptr) {
    run_limit(session, options);
  } else if (options.change) {
    options.change->of_socket ? run_orientation(session, options) : run_resection(session, options);
  } else if (options.measures) {
    run_measures(session, options);
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
  std::filesystem::path there;
  try {
    std::string help;
    const auto parsed = parse_scene_options(argc, argv, help);
    if (!parsed) {
      std::cout << help;
      return 0;
    }
    options = *parsed;
    there = existing(options.out);
    require_writable_folder(options.out);
  } catch (const std::exception& error) {
    return fail(error, 2);
  }
  try {
    run(options);
  } catch (const std::exception& error) {
    remove_empty(options.out, there);
    return fail(error, 1);
  }
  return 0;
}
