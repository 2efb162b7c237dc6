// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/source_state.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "harness/shell.hpp"

namespace impinge::lab {
namespace {

// What a git command prints, or nothing when it fails.
std::optional<std::string> git(const std::filesystem::path& folder, const std::string& arguments) {
  const std::string command = "git -C " + shell_quoted(folder.string()) + " " + arguments + " 2>/dev/null";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    text.append(buffer.data(), count);
  }
  if (::pclose(pipe) != 0) return std::nullopt;
  return text;
}

// A note in the root of the clone, or a scene written there, changes no result.
std::optional<bool> has_changes(const std::filesystem::path& folder) {
  const auto changed = git(folder, "status --porcelain --untracked-files=no");
  const auto added =
      git(folder, "ls-files --others --exclude-standard -- libcore experiments analysis paper");
  if (!changed || !added) return std::nullopt;
  return !changed->empty() || !added->empty();
}

}  // namespace

SourceState source_state(const std::filesystem::path& folder) {
  SourceState state;
  const char* commit = std::getenv("IMPINGE_COMMIT");
  if (commit != nullptr && *commit != '\0') {
    state.commit = commit;
    if (const char* dirty = std::getenv("IMPINGE_DIRTY")) {
      const std::string_view flag = dirty;
      state.dirty = flag == "1" || flag == "yes" || flag == "true";
    }
    return state;
  }
  if (const auto head = git(folder, "rev-parse HEAD")) {
    state.commit = head->substr(0, head->find('\n'));
    state.dirty = has_changes(folder);
  }
  return state;
}

}  // namespace impinge::lab
