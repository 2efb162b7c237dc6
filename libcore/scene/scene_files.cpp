// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_files.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace impinge {

std::vector<std::string> scene_files(const SceneOptions& options) {
  std::vector<std::string> files;
  if (options.many()) return {"poses.csv", "summary.json"};
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
  files.emplace_back("poses.csv");
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
  return older;
}

}  // namespace impinge
