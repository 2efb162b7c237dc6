// SPDX-License-Identifier: GPL-3.0-or-later
// A new file that is written beside its final place, the target, and renamed at last.
#pragma once

#include <filesystem>
#include <string_view>

namespace impinge {

/// The destructor removes the file unless it was renamed or is kept. All members throw FileError, which names
/// the target.
class TemporaryFile {
 public:
  /// Creates an empty file. The folder of the target must exist; a target that is a folder is refused.
  explicit TemporaryFile(std::filesystem::path target);
  /// Takes a file that is already written. Where it is not renamed it is kept, for a later run.
  TemporaryFile(std::filesystem::path target, std::filesystem::path written);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Writes all bytes and syncs them to the disk.
  void write(std::string_view bytes);
  /// Replaces the target with this file.
  void rename();

  const std::filesystem::path& target() const { return target_; }

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
  int handle_;
  bool mine_;  // the destructor removes it
};

/// Throws the FileError for a file that cannot be written; `error` is a value of errno.
[[noreturn]] void fail_writing(const std::filesystem::path& file, int error);

}  // namespace impinge
