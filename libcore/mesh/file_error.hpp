// SPDX-License-Identifier: GPL-3.0-or-later
// What is thrown when a mesh file cannot be read or written.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace impinge {

// what() is one line: "FILE: what is wrong; what to do".
class MeshFileError : public std::runtime_error {
 public:
  MeshFileError(const std::filesystem::path& file, const std::string& reason, const std::string& advice);
};

}  // namespace impinge
