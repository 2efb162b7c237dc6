// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_set.hpp"

#include <cerrno>
#include <string>
#include <utility>

#include <unistd.h>

#include "files/file_bytes.hpp"

namespace impinge {

// The replacement of one file. The destructor undoes it unless keep() was called; it allocates no memory.
class FileSet::Change {
 public:
  explicit Change(std::shared_ptr<TemporaryFile> part)
      : part_(std::move(part)), old_(part_->target().string() + ".old" + std::to_string(::getpid())) {}
  Change(const Change&) = delete;
  Change& operator=(const Change&) = delete;

  ~Change() {
    if (replaced_ && kept_) ::rename(old_.c_str(), part_->target().c_str());
    if (replaced_ && !kept_ && !was_there_) ::unlink(part_->target().c_str());
    if (!replaced_ && kept_) ::unlink(old_.c_str());
  }

  // Gives the old file a second name. On a file system without hard links a replacement cannot be undone.
  void keep_old() {
    ::unlink(old_.c_str());  // a run that was killed may have left it
    kept_ = ::link(part_->target().c_str(), old_.c_str()) == 0;
    was_there_ = kept_ || errno != ENOENT;
    const bool no_second_names = errno == EPERM || errno == EOPNOTSUPP || errno == EMLINK;
    if (was_there_ && !kept_ && !no_second_names) fail_writing(part_->target(), errno);
  }

  void replace() {
    part_->rename();
    replaced_ = true;
  }

  void keep() { replaced_ = false; }

 private:
  std::shared_ptr<TemporaryFile> part_;
  std::string old_;
  bool was_there_ = false;
  bool kept_ = false;
  bool replaced_ = false;
};

FileSet::FileSet() = default;
FileSet::~FileSet() = default;

void FileSet::add(const std::filesystem::path& file, std::string_view bytes) {
  if (holds(file, bytes)) return;
  auto part = std::make_shared<TemporaryFile>(file);
  part->write(bytes);
  add(std::move(part));
}

void FileSet::add(std::shared_ptr<TemporaryFile> written) {
  changes_.push_back(std::make_unique<Change>(std::move(written)));
}

void FileSet::commit() {
  const auto changes = std::move(changes_);
  changes_.clear();
  for (const auto& change : changes) change->keep_old();
  for (const auto& change : changes) change->replace();
  for (const auto& change : changes) change->keep();
}

}  // namespace impinge
