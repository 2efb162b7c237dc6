// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 of results and programs, by OpenSSL.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace impinge::lab {

// 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

// The same for the bytes of a file. Throws std::runtime_error when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace impinge::lab
