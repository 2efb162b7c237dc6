// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_error.hpp"

#include <system_error>

#include "files/one_line.hpp"

namespace impinge {

FileError::FileError(const std::filesystem::path& file, const std::string& reason, const std::string& advice)
    : std::runtime_error(one_line(file.string() + ": " + reason + "; " + advice)) {}

std::string system_message(int error) { return std::generic_category().message(error); }

}  // namespace impinge
