// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/file_bytes.hpp"

#include <cerrno>
#include <fstream>
#include <random>
#include <sstream>
#include <system_error>

#include "mesh/file_error.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

std::string last_error() { return std::generic_category().message(errno); }

void require_regular_file(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) {
    throw MeshFileError(file, "there is no such file", "check the path");
  }
  if (status.type() == fs::file_type::none) {
    throw MeshFileError(file, "cannot be looked up, " + error.message(), "check the path");
  }
  if (fs::is_directory(status)) throw MeshFileError(file, "is a folder", "name a mesh file in it");
  if (!fs::is_regular_file(status)) throw MeshFileError(file, "is not a regular file", "name a mesh file");
}

fs::path temporary_beside(const fs::path& file) {
  std::random_device random;
  std::ostringstream suffix;
  suffix << '.' << std::hex << random() << random() << ".part";
  fs::path part = file;
  part += suffix.str();
  return part;
}

// Removes the file unless it was released.
struct Scratch {
  fs::path path;
  explicit Scratch(fs::path p) : path(std::move(p)) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    if (!path.empty()) fs::remove(path, ignored);
  }
};

}  // namespace

std::string read_bytes(const fs::path& file) {
  require_regular_file(file);
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw MeshFileError(file, "cannot be opened, " + last_error(), "check its permissions");
  std::string bytes(fs::file_size(file), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in) throw MeshFileError(file, "cannot be read to its end, " + last_error(), "check the disk");
  if (bytes.empty()) throw MeshFileError(file, "is empty", "export or copy it again");
  return bytes;
}

void write_bytes(const fs::path& file, std::string_view bytes) {
  if (fs::is_directory(file)) throw MeshFileError(file, "is a folder", "choose another name");
  Scratch part(temporary_beside(file));
  errno = 0;
  std::ofstream out(part.path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    throw MeshFileError(file, "cannot be written, " + last_error(),
                        "check that its folder exists, may be written to and has room");
  }
  std::error_code error;
  fs::rename(part.path, file, error);
  if (error) throw MeshFileError(file, "cannot be replaced, " + error.message(), "choose another name");
  part.path.clear();
}

}  // namespace impinge
