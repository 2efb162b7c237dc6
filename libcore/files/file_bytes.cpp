// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_bytes.hpp"

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <system_error>

#include "files/file_error.hpp"
#include "files/temporary_file.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

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

constexpr std::uintmax_t kGone = static_cast<std::uintmax_t>(-1);

struct Stamp {
  std::uintmax_t bytes;  // or kGone
  fs::file_time_type time;
  bool operator==(const Stamp&) const = default;
};

Stamp stamp_of(const fs::path& file) {
  std::error_code gone;
  const std::uintmax_t bytes = fs::file_size(file, gone);
  return {bytes, fs::last_write_time(file, gone)};
}

}  // namespace

std::string read_bytes(const fs::path& file) {
  require_regular_file(file);
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError(file, "cannot be opened, " + system_message(errno), "check its permissions");
  const Stamp before = stamp_of(file);
  std::string bytes(before.bytes == kGone ? 0 : static_cast<std::size_t>(before.bytes), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in && errno != 0)
    throw FileError(file, "cannot be read to its end, " + system_message(errno), "check the disk");
  if (!in || before.bytes == kGone || before != stamp_of(file))
    throw FileError(file, "changed while it was read", "ask again when nothing writes to it");
  if (bytes.empty()) throw FileError(file, "is empty", "export or copy it again");
  return bytes;
}

void write_bytes(const fs::path& file, std::string_view bytes) {
  TemporaryFile part(file);
  part.write(bytes);
  part.rename();
}

bool holds(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  const bool same_size = fs::is_regular_file(file, ignored) && fs::file_size(file, ignored) == bytes.size();
  return same_size && !bytes.empty() && read_bytes(file) == bytes;
}

bool write_if_changed(const fs::path& file, std::string_view bytes) {
  if (holds(file, bytes)) return false;
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
