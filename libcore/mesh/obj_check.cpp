// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <span>

#include "mesh/file_checks.hpp"
#include "mesh/file_error.hpp"
#include "mesh/text_scan.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

// Joins continued lines (backslash before the line end).
void join_lines(std::string& bytes) {
  for (std::size_t i = bytes.find('\\'); i < bytes.size(); i = bytes.find('\\', i + 1)) {
    const std::size_t end = bytes.compare(i + 1, 1, "\r") == 0 ? i + 2 : i + 1;
    if (bytes.compare(end, 1, "\n") == 0) bytes.replace(i, end - i + 1, end - i + 1, ' ');
  }
}

class ObjScan {
 public:
  ObjScan(const fs::path& file, std::string& bytes) : file_(file), bytes_(bytes) {}

  std::size_t polygons() {
    for (std::size_t begin = 0; begin < bytes_.size();) {
      const std::size_t end = std::min(bytes_.find('\n', begin), bytes_.size());
      ++line_;
      take(std::span(bytes_).subspan(begin, end - begin));
      begin = end + 1;
    }
    if (polygons_ == 0)
      throw MeshFileError(file_, "has no faces", "it is no OBJ mesh or cut short, export it again");
    check_indices();
    return polygons_;
  }

 private:
  // Reads a v or f record and blanks out all else.
  void take(std::span<char> line) {
    std::fill(std::ranges::find(line, '#'), line.end(), ' ');
    split_words(std::string_view(line.data(), line.size()), words_);
    if (!words_.empty() && words_[0] == "v") {
      take_vertex();
    } else if (!words_.empty() && words_[0] == "f") {
      take_face(line);
    } else {
      std::ranges::fill(line, ' ');
    }
  }

  void take_vertex() {
    const auto numbers = std::span(words_).subspan(1);
    if (numbers.size() < 3 ||
        !std::ranges::all_of(numbers, [](auto w) { return to_number(w).has_value(); })) {
      throw_incomplete();
    }
    ++vertices_;
  }

  // Corners are v, v/vt, v//vn or v/vt/vn; v counts from 1, or back from the last vertex if negative.
  void take_face(std::span<char> line) {
    if (words_.size() < 4) throw_incomplete();
    for (const std::string_view word : std::span(words_).subspan(1)) {
      const std::size_t length = std::min(word.find('/'), word.size());
      const std::optional<std::int64_t> v = to_integer(word.substr(0, length));
      if (!v) throw_incomplete();
      corners_.push_back(*v < 0 ? vertices_ + *v : *v - 1);
      const auto from = static_cast<std::size_t>(word.data() - line.data());
      std::ranges::fill(line.subspan(from + length, word.size() - length), ' ');
    }
    ++polygons_;
  }

  void check_indices() const {
    std::vector<bool> used(static_cast<std::size_t>(vertices_), false);
    for (const std::int64_t v : corners_) {
      if (v < 0 || v >= vertices_) {
        throw MeshFileError(file_, "a face names a vertex that is not there, it is damaged",
                            "export it again");
      }
      used[static_cast<std::size_t>(v)] = true;
    }
    if (bytes_.back() != '\n' && std::ranges::find(used, false) != used.end()) {
      throw MeshFileError(file_, "its last line has no end and some vertices have no face, it is cut short",
                          "export or copy it again");
    }
  }

  [[noreturn]] void throw_incomplete() const {
    throw MeshFileError(
        file_, "line " + std::to_string(line_) + " is no complete vertex or face, it is cut short or damaged",
        "export or copy it again");
  }

  const fs::path& file_;
  std::string& bytes_;
  std::size_t line_ = 0;
  std::size_t polygons_ = 0;
  std::int64_t vertices_ = 0;
  std::vector<std::int64_t> corners_;
  std::vector<std::string_view> words_;
};

}  // namespace

MeshFileContent check_obj(const fs::path& file, std::string& bytes) {
  if (bytes.find('\0') != std::string::npos)
    throw MeshFileError(file, "is no text, so no OBJ file", "export it again");
  join_lines(bytes);
  return {std::nullopt, ObjScan(file, bytes).polygons()};
}

}  // namespace impinge
