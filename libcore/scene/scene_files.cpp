// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_files.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace impinge {

std::string resected_file(Surface cut) { return "resected_" + std::string(name(cut)) + ".ply"; }

std::vector<std::string> scene_files(const SceneOptions& options) {
  std::vector<std::string> files;
  if (options.many()) return {"poses.csv", "summary.json"};
  if (options.bones && options.limit == nullptr && !options.measures) return {"joints.csv", "summary.json"};
  if (options.change && options.change->of_socket) return {"orientation.csv", "orientation.json"};
  if (options.change) {
    files = {resected_file(options.change->cut), "resection.json"};
    if (options.change->least) files.emplace_back("swept.csv");
    return files;
  }
  if (options.limit != nullptr && (options.all_motions || options.bones))
    return {"limits.csv", "summary.json"};
  if (options.measures) return {"measures.csv", "summary.json"};
  if (options.volume) {
    files = {"volume.csv", "volume.json"};
    if (options.side) files.emplace_back("volume.svg");
    return files;
  }
  const bool all = options.limit == nullptr && options.question == Question::all_gaps;
  const bool gaps = all && options.outputs.gaps;
  if (gaps && options.scan_ball) files.emplace_back("ball.ply");
  if (gaps && options.scan_socket) files.emplace_back("socket.ply");
  if (gaps) files.emplace_back("gaps.csv");
  if (all && options.outputs.distances) files.emplace_back("distances.csv");
  files.emplace_back("summary.json");
  return files;
}

std::vector<std::string> every_scene_file() {
  const SceneOptions everything;
  std::vector<std::string> files = scene_files(everything);
  for (const char* name : {"poses.csv", "limits.csv", "measures.csv", "joints.csv", "resected_ball.ply",
                           "resected_socket.ply", "resection.json", "swept.csv", "orientation.csv",
                           "orientation.json", "volume.csv", "volume.json", "volume.svg"})
    files.emplace_back(name);
  return files;
}

std::vector<std::string> older_files(const SceneOptions& options) {
  std::vector<std::string> older;
  const std::vector<std::string> written = scene_files(options);
  for (const std::string& name : every_scene_file()) {
    std::error_code unreadable;  // then nothing is known of it
    if (std::ranges::find(written, name) == written.end() &&
        std::filesystem::exists(options.out / name, unreadable))
      older.push_back(name);
  }
  std::error_code unreadable;
  for (const auto& file : std::filesystem::directory_iterator(options.out, unreadable)) {
    const std::string name = file.path().filename().string();
    if ((name.starts_with("poses-") || name.starts_with("volume-")) && name.ends_with(".part"))
      older.push_back(name);
  }
  return older;
}

}  // namespace impinge
