// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_set.hpp"

#include <cerrno>
#include <string>
#include <utility>

#include <unistd.h>

#include "files/file_bytes.hpp"
#include "files/temporary_file.hpp"

namespace impinge {

// One file on its way. Undoes itself unless it was kept.
class FileSet::Change {
 public:
  Change(const std::filesystem::path& file, std::string_view bytes) : part_(file) { part_.write(bytes); }
  Change(const Change&) = delete;
  Change& operator=(const Change&) = delete;

  ~Change() {
    if (replaced_ && kept_) ::rename(old().c_str(), part_.target().c_str());
    if (replaced_ && !kept_ && !was_there_) ::unlink(part_.target().c_str());
    if (!replaced_ && kept_) ::unlink(old().c_str());
  }

  // A second name for the old file. Where the file system has no second names there is no way back.
  void keep_old() {
    ::unlink(old().c_str());  // of a run that was killed
    kept_ = ::link(part_.target().c_str(), old().c_str()) == 0;
    was_there_ = kept_ || errno != ENOENT;
    const bool no_second_names = errno == EPERM || errno == EOPNOTSUPP || errno == EMLINK;
    if (was_there_ && !kept_ && !no_second_names) fail_writing(part_.target(), errno);
  }

  void replace() {
    part_.rename();
    replaced_ = true;
  }

  void keep() { replaced_ = false; }

 private:
  std::string old() const { return part_.target().string() + ".old" + std::to_string(::getpid()); }

  TemporaryFile part_;
  bool was_there_ = false;
  bool kept_ = false;
  bool replaced_ = false;
};

FileSet::FileSet() = default;
FileSet::~FileSet() = default;

void FileSet::add(const std::filesystem::path& file, std::string_view bytes) {
  if (!holds(file, bytes)) changes_.push_back(std::make_unique<Change>(file, bytes));
}

void FileSet::commit() {
  const auto changes = std::move(changes_);
  changes_.clear();
  for (const auto& change : changes) change->keep_old();
  for (const auto& change : changes) change->replace();
  for (const auto& change : changes) change->keep();
}

}  // namespace impinge
