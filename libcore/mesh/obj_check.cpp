// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <span>

#include "files/file_error.hpp"
#include "mesh/file_checks.hpp"
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

// Reads the v and f records and writes them again in their plainest form.
class ObjScan {
 public:
  ObjScan(const fs::path& file, std::string_view bytes)
      : file_(file), line_end_missing_(bytes.back() != '\n') {
    LineScanner lines(bytes);
    while (const std::optional<std::string_view> line = lines.next()) {
      ++line_;
      split_words(line->substr(0, line->find('#')), words_);
      if (!words_.empty() && words_[0] == "v") take_vertex();
      if (!words_.empty() && words_[0] == "f") take_face();
    }
    if (polygons_ == 0)
      throw FileError(file_, "has no faces", "it is no OBJ mesh or cut short, export it again");
    check_indices();
  }

  std::size_t polygons() const { return polygons_; }
  const std::string& text() const { return text_; }

 private:
  // v x y z; what follows (weight, colour) is left out. assimp 5.2 cannot read .5 here, so it becomes 0.5.
  void take_vertex() {
    if (words_.size() < 4) throw_incomplete();
    text_ += 'v';
    for (std::string_view word : std::span(words_).subspan(1, 3)) {
      if (!to_number(word)) throw_incomplete();
      text_ += ' ';
      if (word[0] == '-') text_ += '-';
      if (word[0] == '-' || word[0] == '+') word.remove_prefix(1);
      if (word[0] == '.') text_ += '0';
      text_ += word;
    }
    text_ += '\n';
    ++vertices_;
  }

  // Corners are v, v/vt, v//vn or v/vt/vn; v counts from 1, or back from the last vertex if negative.
  void take_face() {
    if (words_.size() < 4) throw_incomplete();
    text_ += 'f';
    for (const std::string_view word : std::span(words_).subspan(1)) {
      const std::optional<std::int64_t> v = to_integer(word.substr(0, word.find('/')));
      if (!v || *v < -vertices_) throw_incomplete();
      corners_.push_back(*v < 0 ? vertices_ + *v : *v - 1);
      text_ += ' ' + std::to_string(corners_.back() + 1);
    }
    text_ += '\n';
    ++polygons_;
  }

  void check_indices() const {
    std::vector<bool> used(static_cast<std::size_t>(vertices_), false);
    for (const std::int64_t v : corners_) {
      if (v < 0 || v >= vertices_) {
        throw FileError(file_, "a face names a vertex that is not there, it is damaged", "export it again");
      }
      used[static_cast<std::size_t>(v)] = true;
    }
    if (line_end_missing_ && std::ranges::find(used, false) != used.end()) {
      throw FileError(file_, "its last line has no end and some vertices have no face, it is cut short",
                      "export or copy it again");
    }
  }

  [[noreturn]] void throw_incomplete() const {
    throw FileError(
        file_, "line " + std::to_string(line_) + " is no complete vertex or face, it is cut short or damaged",
        "export or copy it again");
  }

  const fs::path& file_;
  bool line_end_missing_;
  std::string text_;
  std::size_t line_ = 0;
  std::size_t polygons_ = 0;
  std::int64_t vertices_ = 0;
  std::vector<std::int64_t> corners_;
  std::vector<std::string_view> words_;
};

}  // namespace

MeshFileContent check_obj(const fs::path& file, std::string& bytes) {
  if (bytes.find('\0') != std::string::npos)
    throw FileError(file, "is no text, so no OBJ file", "export it again");
  join_lines(bytes);
  const ObjScan scan(file, bytes);
  bytes = scan.text();
  return {std::nullopt, scan.polygons(), std::nullopt};
}

}  // namespace impinge
