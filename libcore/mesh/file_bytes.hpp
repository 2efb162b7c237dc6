// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files in and out of memory. Both functions throw MeshFileError.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace impinge {

// All bytes of a regular file that is not empty.
std::string read_bytes(const std::filesystem::path& file);

// Writes beside `file` under a temporary name (FILE.<hex>.part) and renames: whoever looks finds the old file
// or the whole new one. The folder must exist. Nothing is left behind when it fails.
void write_bytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace impinge
