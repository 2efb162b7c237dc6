// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_bytes.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "files/file_error.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

std::string message_of(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail_writing(const fs::path& file, int error) {
  throw FileError(file, "cannot be written, " + message_of(error),
                  "check that its folder exists, may be written to and has room");
}

void require_regular_file(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) {
    throw FileError(file, "there is no such file", "check the path");
  }
  if (status.type() == fs::file_type::none) {
    throw FileError(file, "cannot be looked up, " + error.message(), "check the path");
  }
  if (fs::is_directory(status)) throw FileError(file, "is a folder", "name a file in it");
  if (!fs::is_regular_file(status)) throw FileError(file, "is not a regular file", "name a file on the disk");
}

// A new file beside its final place, which removes itself unless it was renamed there.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path target)
      : target_(std::move(target)),
        path_(target_.string() + ".part" + std::to_string(::getpid())),
        handle_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
    if (handle_ < 0) fail_writing(target_, errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    ::close(handle_);
    if (!renamed_) ::unlink(path_.c_str());
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(handle_, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) fail_writing(target_, errno);
      if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    if (::fsync(handle_) != 0) fail_writing(target_, errno);
  }

  void rename() {
    if (::rename(path_.c_str(), target_.c_str()) != 0) {
      throw FileError(target_, "cannot be replaced, " + message_of(errno), "choose another name");
    }
    renamed_ = true;
  }

 private:
  fs::path target_;
  fs::path path_;
  int handle_;
  bool renamed_ = false;
};

}  // namespace

std::string read_bytes(const fs::path& file) {
  require_regular_file(file);
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError(file, "cannot be opened, " + message_of(errno), "check its permissions");
  std::string bytes(fs::file_size(file), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in) throw FileError(file, "cannot be read to its end, " + message_of(errno), "check the disk");
  if (bytes.empty()) throw FileError(file, "is empty", "export or copy it again");
  return bytes;
}

void write_bytes(const fs::path& file, std::string_view bytes) {
  if (fs::is_directory(file)) throw FileError(file, "is a folder", "choose another name");
  TemporaryFile part(file);
  part.write(bytes);
  part.rename();
}

bool write_if_changed(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  const bool same_size = fs::is_regular_file(file, ignored) && fs::file_size(file, ignored) == bytes.size();
  if (same_size && !bytes.empty() && read_bytes(file) == bytes) return false;
  write_bytes(file, bytes);
  return true;
}

void require_writable_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw FileError(folder, "the folder cannot be created, " + error.message(), "choose another folder");
  const TemporaryFile probe(folder / "probe");
}

}  // namespace impinge
