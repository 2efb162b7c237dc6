// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_error.hpp"

#include <algorithm>

namespace impinge {
namespace {

std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

}  // namespace

FileError::FileError(const std::filesystem::path& file, const std::string& reason, const std::string& advice)
    : std::runtime_error(one_line(file.string() + ": " + reason + "; " + advice)) {}

}  // namespace impinge
