// SPDX-License-Identifier: GPL-3.0-or-later
// Which version of the sources a result came from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace impinge::lab {

struct SourceState {
  std::string commit = "unknown";  // full hash
  std::optional<bool> dirty;  // uncommitted changes, or new files among the sources; nothing when unknown
};

// From the environment (IMPINGE_COMMIT, IMPINGE_DIRTY: 1, yes or true mean dirty) when IMPINGE_COMMIT is set,
// else from git in the given folder, the root of the repository, else unknown. New files count only below
// libcore, experiments, analysis and paper, unless git ignores them. Never throws because of a missing git or
// repository.
SourceState source_state(const std::filesystem::path& folder);

}  // namespace impinge::lab
