// SPDX-License-Identifier: GPL-3.0-or-later
// Several files that belong together: all of them are replaced, or none.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "files/temporary_file.hpp"

namespace impinge {

/// add() writes each file under a temporary name, so a full disk is noticed before any old file is touched;
/// commit() renames them into place. If one rename fails, those before it are undone: a later reader finds
/// all the old files or all the new ones. One exception: a process that is killed within commit(), between
/// two renames, leaves the first files new and the others old.
///
/// All members throw FileError. Nothing is left behind by a set that was not committed.
class FileSet {
 public:
  FileSet();
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;
  ~FileSet();

  /// Adds a file with these bytes. Its folder must exist. A file that holds these bytes already is left
  /// alone.
  void add(const std::filesystem::path& file, std::string_view bytes);

  /// Adds a file whose bytes are written already.
  void add(std::shared_ptr<TemporaryFile> written);

  /// Puts the files in place, in the order of add(). The set is then empty.
  void commit();

 private:
  class Change;
  std::vector<std::unique_ptr<Change>> changes_;
};

}  // namespace impinge
