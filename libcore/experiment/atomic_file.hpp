// SPDX-License-Identifier: GPL-3.0-or-later
// Writing a result file so that a reader sees the old bytes or the new ones, never half of either.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace impinge {

// All bytes of a file. Throws std::runtime_error with the path when it cannot be read.
std::string read_file(const std::filesystem::path& path);

// Writes to a temporary name in the same folder, syncs it to the disk and renames it. A file that holds these
// bytes already keeps its time stamp, so that a build graph with restat stops there. True when the file
// changed. Throws std::runtime_error with path and reason; the temporary file does not stay behind.
bool write_if_changed(const std::filesystem::path& path, std::string_view bytes);

// Creates the folder when it is missing and proves that a file can be written in it. Throws
// std::runtime_error with path and reason.
void require_writable_folder(const std::filesystem::path& folder);

}  // namespace impinge
