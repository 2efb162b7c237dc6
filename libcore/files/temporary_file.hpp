// SPDX-License-Identifier: GPL-3.0-or-later
// A new file beside its final place.
#pragma once

#include <filesystem>
#include <string_view>

namespace impinge {

/// Removes itself unless it was renamed. All members throw FileError, which names the final place.
class TemporaryFile {
 public:
  /// Creates it empty. The folder of the target must exist; a target that is a folder is refused.
  explicit TemporaryFile(std::filesystem::path target);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Writes all bytes and syncs them to the disk.
  void write(std::string_view bytes);
  /// Puts it in the place of the target.
  void rename();

  const std::filesystem::path& target() const { return target_; }  // its final place

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
  int handle_;
  bool renamed_ = false;
};

/// What is thrown where a file cannot be written; `error` is a value of errno.
[[noreturn]] void fail_writing(const std::filesystem::path& file, int error);

}  // namespace impinge
