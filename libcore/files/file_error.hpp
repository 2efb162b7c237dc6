// SPDX-License-Identifier: GPL-3.0-or-later
// The exception for a file that cannot be read or written.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace impinge {

/// what() is one line: "FILE: what is wrong; what to do".
class FileError : public std::runtime_error {
 public:
  /// `reason` says what is wrong, `advice` what to do.
  FileError(const std::filesystem::path& file, const std::string& reason, const std::string& advice);
};

/// The operating system's message for a value of errno.
std::string system_message(int error);

}  // namespace impinge
