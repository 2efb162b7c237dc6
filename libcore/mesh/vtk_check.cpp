// SPDX-License-Identifier: GPL-3.0-or-later
// The legacy format of VTK: "# vtk DataFile Version x.y", a title, ASCII or BINARY (the highest byte first),
// DATASET, then sections in any order, each a word with counts and its numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "files/file_error.hpp"
#include "mesh/file_checks.hpp"
#include "mesh/number_bytes.hpp"
#include "mesh/polygon_ply.hpp"
#include "mesh/text_scan.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

struct VtkType {
  std::string_view name;
  NumberType type;
};
constexpr std::array<VtkType, 13> kVtkTypes{{{"char", {1, false, true}},
                                             {"unsigned_char", {1, false, false}},
                                             {"short", {2, false, true}},
                                             {"unsigned_short", {2, false, false}},
                                             {"int", {4, false, true}},
                                             {"unsigned_int", {4, false, false}},
                                             {"vtkidtype", {4, false, true}},
                                             {"long", {8, false, true}},
                                             {"unsigned_long", {8, false, false}},
                                             {"vtktypeint64", {8, false, true}},
                                             {"vtktypeuint64", {8, false, false}},
                                             {"float", {4, true, true}},
                                             {"double", {8, true, true}}}};

class VtkReader {
 public:
  VtkReader(const fs::path& file, std::string_view bytes) : file_(file), rest_(bytes) {}

  std::string plain() {
    read_head();
    for (std::string word = next_word(); !word.empty() && !word.ends_with("_data"); word = next_word())
      read_section(word);
    for (const Cells& cells : cells_) {
      if (!mesh_.add_cells(cells.corners, cells.ends, cells.strips)) throw_damaged("a list of faces");
    }
    return mesh_.bytes();
  }

 private:
  struct Cells {
    std::vector<double> corners;
    std::vector<double> ends;
    bool strips = false;
  };

  void read_head() {
    const std::string version = next_line();
    constexpr std::string_view kStart = "# vtk DataFile Version ";
    if (!version.starts_with(kStart))
      throw FileError(file_, "is no legacy VTK file, its first line is not '# vtk DataFile Version'",
                      "export it again, or name it .vtp if it is XML");
    later_ = version.substr(kStart.size()) >= "5";
    next_line();  // the title
    const std::string kind = next_word();
    binary_ = kind == "binary";
    if (kind != "ascii" && !binary_) throw_damaged("the word ASCII or BINARY");
    if (next_word() != "dataset") throw_damaged("the word DATASET");
    if (const std::string data = next_word(); data != "polydata") {
      throw FileError(file_, "holds " + data.substr(0, 40) + ", not POLYDATA",
                      "extract the surface, in ParaView with Extract Surface, and save it as .vtp or .vtk");
    }
  }

  void read_section(const std::string& word) {
    if (word == "points") {
      const std::size_t n = next_count(word);
      mesh_.add_points(numbers(next_word(), n > rest_.size() ? n : 3 * n, word));
    } else if (word == "polygons" || word == "triangle_strips") {
      cells_.push_back(cells(word));
    } else if (word == "vertices" || word == "lines") {
      cells(word);
    } else if (word == "field") {
      skip_field();
    } else if (word == "metadata") {
      skip_metadata();
    } else {
      throw_damaged("points or polygons");
    }
  }

  // The cells. Each has its number of corners before its corners; from version 5 on, the ends of all cells
  // come first, then all corners.
  Cells cells(const std::string& word) {
    const std::size_t n = next_count(word);
    const std::size_t size = next_count(word);
    Cells found{{}, {}, word == "triangle_strips"};
    if (later_) {
      if (next_word() != "offsets") throw_damaged("the word OFFSETS");
      found.ends = numbers(next_word(), n, word);
      if (!found.ends.empty()) found.ends.erase(found.ends.begin());
      if (next_word() != "connectivity") throw_damaged("the word CONNECTIVITY");
      found.corners = numbers(next_word(), size, word);
      return found;
    }
    const std::vector<double> listed = numbers("int", size, word);
    std::size_t i = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double length = i < listed.size() ? listed[i++] : -1.0;
      if (!(length >= 0.0 && length <= static_cast<double>(listed.size() - i))) throw_damaged(word);
      const auto begin = listed.begin() + static_cast<std::ptrdiff_t>(i);
      i += static_cast<std::size_t>(length);
      found.corners.insert(found.corners.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
      found.ends.push_back(static_cast<double>(found.corners.size()));
    }
    if (i < listed.size()) throw_damaged(word);
    return found;
  }

  void skip_field() {
    next_word();  // its name
    for (std::size_t arrays = next_count("field"); arrays > 0; --arrays) {
      if (next_word() == "metadata") {  // of the array before
        skip_metadata();
        next_word();
      }
      const std::size_t components = next_count("field");
      const std::size_t tuples = next_count("field");
      const std::string type = next_word();
      if (components > 0 && tuples > rest_.size() / components) throw_damaged("field");
      if (type == "string")
        skip_strings(components * tuples);
      else
        numbers(type, components * tuples, "field");
    }
  }

  // Skips to the next empty line.
  void skip_metadata() {
    next_line();
    while (!next_line().empty()) continue;
  }

  // Skips n strings. In binary files each has its length before it, whose first two bits say how long that
  // is.
  void skip_strings(std::size_t n) {
    next_line();
    for (; n > 0; --n) {
      if (!binary_) {
        next_line();
        continue;
      }
      const std::size_t size =
          rest_.empty() ? 0 : std::size_t{8} >> (static_cast<unsigned char>(rest_[0]) >> 6U);
      if (size == 0 || rest_.size() < size) throw_damaged("field");
      const double most = number_at(rest_, {size, false, false}, true);
      const double length = std::fmod(most, std::ldexp(1.0, static_cast<int>(8 * size) - 2));
      rest_.remove_prefix(size);
      if (length > static_cast<double>(rest_.size())) throw_damaged("field");
      rest_.remove_prefix(static_cast<std::size_t>(length));
    }
  }

  std::vector<double> numbers(const std::string& type, std::size_t n, const std::string& what) {
    const auto* const known = std::ranges::find(kVtkTypes, type, &VtkType::name);
    if (known == kVtkTypes.end() || n > rest_.size()) throw_damaged(what);
    std::vector<double> found;
    if (binary_) next_line();  // numbers begin on the next line
    if (binary_ && n > rest_.size() / known->type.size) throw_damaged(what);
    for (; n > 0; --n) {
      const std::optional<double> x = binary_ ? number_at(rest_, known->type, true) : to_number(next_word());
      if (!x) throw_damaged(what);
      found.push_back(*x);
      if (binary_) rest_.remove_prefix(known->type.size);
    }
    return found;
  }

  std::size_t next_count(const std::string& what) {
    const std::optional<std::int64_t> n = to_integer(next_word());
    if (!n || *n < 0) throw_damaged(what);
    return static_cast<std::size_t>(*n);
  }

  // The next word in lower case; empty at the end.
  std::string next_word() {
    constexpr std::string_view kWordEnds = " \t\r\n\v\f";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kWordEnds), rest_.size()));
    std::string word(rest_.substr(0, rest_.find_first_of(kWordEnds)));
    rest_.remove_prefix(word.size());
    for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return word;
  }

  // The rest of the line.
  std::string next_line() {
    LineScanner lines(rest_);
    std::string line(lines.next().value_or(""));
    rest_ = lines.rest();
    return line;
  }

  [[noreturn]] void throw_damaged(const std::string& what) const {
    throw FileError(file_, "ends within or cannot be read at " + what + ", it is cut short or damaged",
                    "export or copy it again");
  }

  const fs::path& file_;
  std::string_view rest_;
  bool binary_ = false;
  bool later_ = false;  // version 5 or later
  PolygonPly mesh_;
  std::vector<Cells> cells_;
};

}  // namespace

MeshFileContent check_vtk(const fs::path& file, std::string& bytes) {
  bytes = VtkReader(file, bytes).plain();
  return check_ply(file, bytes);
}

}  // namespace impinge
