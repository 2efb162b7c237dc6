// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files in and out of memory. All functions throw FileError.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace impinge {

/// All bytes of a regular file that is not empty and does not change meanwhile.
std::string read_bytes(const std::filesystem::path& file);

/// Writes beside `file` under a temporary name, syncs to the disk and renames: a reader finds either the old
/// file or the whole new one. The folder must exist. Nothing is left behind on failure.
void write_bytes(const std::filesystem::path& file, std::string_view bytes);

/// Is `file` a regular file with exactly these bytes? Never true for an empty file.
bool holds(const std::filesystem::path& file, std::string_view bytes);

/// As write_bytes(), but a file that holds these bytes already keeps its time stamp, so that a build tool
/// rebuilds nothing that depends on it. Returns whether the file changed.
bool write_if_changed(const std::filesystem::path& file, std::string_view bytes);

/// Creates the folder if it is missing and checks that a file can be written in it.
void require_writable_folder(const std::filesystem::path& folder);

}  // namespace impinge
