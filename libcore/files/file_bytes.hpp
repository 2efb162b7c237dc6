// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes whole files. All functions throw FileError.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace impinge {

/// All bytes of a file. Throws if it is not a regular file, is empty, or changes while it is read.
std::string read_bytes(const std::filesystem::path& file);

/// Writes a file so that a reader finds either the old one or the whole new one: the bytes go to a temporary
/// file beside it, which is synced to the disk and then renamed. The folder must exist. Nothing is left
/// behind on failure.
void write_bytes(const std::filesystem::path& file, std::string_view bytes);

/// Is `file` a regular file with exactly these bytes? Never true for an empty file.
bool holds(const std::filesystem::path& file, std::string_view bytes);

/// As write_bytes(), but leaves a file alone that holds these bytes already, so that a build tool rebuilds
/// nothing that depends on it. Returns whether the file changed.
bool write_if_changed(const std::filesystem::path& file, std::string_view bytes);

/// Creates the folder if it is missing and checks that a file can be written in it.
void require_writable_folder(const std::filesystem::path& folder);

}  // namespace impinge
