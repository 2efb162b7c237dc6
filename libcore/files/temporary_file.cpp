// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/temporary_file.hpp"

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "files/file_error.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

fs::path require_no_folder(fs::path target) {
  std::error_code ignored;
  if (fs::is_directory(target, ignored)) throw FileError(target, "is a folder", "choose another name");
  return target;
}

}  // namespace

void fail_writing(const fs::path& file, int error) {
  throw FileError(file, "cannot be written, " + system_message(error),
                  "check that its folder exists, may be written to and has room");
}

TemporaryFile::TemporaryFile(fs::path target)
    : target_(require_no_folder(std::move(target))),
      path_(target_.string() + ".part" + std::to_string(::getpid())),
      handle_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)),
      mine_(true) {
  if (handle_ < 0) fail_writing(target_, errno);
}

TemporaryFile::TemporaryFile(fs::path target, fs::path written)
    : target_(require_no_folder(std::move(target))), path_(std::move(written)), handle_(-1), mine_(false) {}

TemporaryFile::~TemporaryFile() {
  if (handle_ >= 0) ::close(handle_);
  if (mine_) ::unlink(path_.c_str());
}

void TemporaryFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(handle_, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) fail_writing(target_, errno);
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  if (::fsync(handle_) != 0) fail_writing(target_, errno);
}

void TemporaryFile::rename() {
  if (::rename(path_.c_str(), target_.c_str()) != 0) {
    throw FileError(target_, "cannot be replaced, " + system_message(errno), "choose another name");
  }
  mine_ = false;
}

}  // namespace impinge
