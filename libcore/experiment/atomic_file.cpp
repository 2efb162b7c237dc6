// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace impinge {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error) {
  throw std::runtime_error(path.string() + ": " + what + ": " + std::strerror(error));
}

// A new file that removes itself unless it was renamed to its final place.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path)
      : path_(std::move(path)),
        handle_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
    if (handle_ < 0) fail(path_, "cannot be created", errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (handle_ >= 0) ::close(handle_);
    if (!renamed_) ::unlink(path_.c_str());
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(handle_, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) fail(path_, "cannot be written", errno);
      if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    if (::fsync(handle_) != 0) fail(path_, "cannot be synced to the disk", errno);
  }

  void rename_to(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) fail(target, "cannot be replaced", errno);
    renamed_ = true;
  }

 private:
  fs::path path_;
  int handle_;
  bool renamed_ = false;
};

fs::path temporary_name(const fs::path& path) { return path.string() + ".tmp" + std::to_string(::getpid()); }

}  // namespace

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, "cannot be read", errno);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool write_if_changed(const fs::path& path, std::string_view bytes) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored) && read_file(path) == bytes) return false;
  TemporaryFile file(temporary_name(path));
  file.write(bytes);
  file.rename_to(path);
  return true;
}

void require_writable_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder, "the folder cannot be created", error.value());
  TemporaryFile probe(temporary_name(folder / "probe"));
}

}  // namespace impinge
