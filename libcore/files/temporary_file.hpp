// SPDX-License-Identifier: GPL-3.0-or-later
// A new file beside its final place.
#pragma once

#include <filesystem>
#include <string_view>

namespace impinge {

/// Removed by the destructor unless it was renamed or is kept. All members throw FileError, which names the
/// target.
class TemporaryFile {
 public:
  /// Creates an empty file. The folder of the target must exist; a target that is a folder is refused.
  explicit TemporaryFile(std::filesystem::path target);
  /// `written` is there already, and whole. It is kept, for a later run, where it is not renamed.
  TemporaryFile(std::filesystem::path target, std::filesystem::path written);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Writes all bytes and syncs them to the disk.
  void write(std::string_view bytes);
  /// Replaces the target with this file.
  void rename();

  const std::filesystem::path& target() const { return target_; }  // its final place

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
  int handle_;
  bool mine_;  // to remove
};

/// Throws the FileError for a file that cannot be written; `error` is a value of errno.
[[noreturn]] void fail_writing(const std::filesystem::path& file, int error);

}  // namespace impinge
