// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>

#include "files/file_error.hpp"
#include "mesh/file_checks.hpp"
#include "mesh/text_scan.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeader = 84;  // 80 bytes of text, then the number of triangles
constexpr std::size_t kTriangle = 50;

std::uint64_t declared_triangles(std::string_view bytes) {
  std::uint64_t n = 0;
  for (std::size_t k = kHeader; k-- > kHeader - 4;) n = n << 8U | static_cast<unsigned char>(bytes[k]);
  return n;
}

[[noreturn]] void throw_damaged(const fs::path& file, std::size_t facet) {
  throw FileError(
      file,
      "ends within or cannot be read at facet " + std::to_string(facet) + ", it is cut short or damaged",
      "export or copy it again");
}

bool same_word(std::string_view word, std::string_view lower) {
  return std::ranges::equal(
      word, lower, [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
}

// Does the line have n words, beginning with `word`, and then three numbers?
bool has_numbers(const std::vector<std::string_view>& words, std::string_view word, std::ptrdiff_t n) {
  return words.size() == static_cast<std::size_t>(n) + 3 && same_word(words[0], word) &&
         std::all_of(words.begin() + n, words.end(),
                     [](std::string_view w) { return to_number(w).has_value(); });
}

// Reads what follows "facet normal x y z": outer loop / vertex x y z, three times / endloop / endfacet.
// Appends the facet to `text`.
void take_facet(const fs::path& file, LineScanner& lines, std::size_t facet, std::string& text) {
  const auto expect = [&](bool right) {
    if (!right) throw_damaged(file, facet);
  };
  const auto starts = [&lines](std::string_view word) {
    const auto& words = lines.next_words();
    return !words.empty() && same_word(words[0], word);
  };
  text += "facet normal 0 0 0\nouter loop\n";
  expect(starts("outer"));
  for (int k = 0; k < 3; ++k) {
    const auto& words = lines.next_words();
    expect(has_numbers(words, "vertex", 1));
    text.append("vertex ").append(words[1]).append(" ").append(words[2]).append(" ").append(words[3]) += '\n';
  }
  expect(starts("endloop"));
  expect(starts("endfacet"));
  text += "endloop\nendfacet\n";
}

MeshFileContent check_ascii(const fs::path& file, std::string& bytes) {
  LineScanner lines(bytes);
  std::string text = "solid mesh\n";
  MeshFileContent content;
  bool ended = false;
  while (true) {
    const auto& words = lines.next_words();
    if (words.empty()) break;
    ended = same_word(words[0], "endsolid");
    if (has_numbers(words, "facet", 2)) {
      take_facet(file, lines, content.polygons++, text);
    } else if (!same_word(words[0], "solid") && !ended) {
      throw_damaged(file, content.polygons);
    }
  }
  if (!ended) throw FileError(file, "has no endsolid, it is cut short", "export or copy it again");
  bytes = text + "endsolid mesh\n";
  return content;
}

}  // namespace

MeshFileContent check_stl(const fs::path& file, std::string& bytes) {
  MeshFileContent content;
  const bool ascii =
      same_word(std::string_view(bytes).substr(0, 5), "solid") && bytes.find('\0') == bytes.npos;
  const bool headed = bytes.size() >= kHeader;
  const std::uint64_t declared = headed ? declared_triangles(bytes) : 0;
  const std::uint64_t size = kHeader + declared * kTriangle;
  const bool more = !ascii && declared > 0 && bytes.size() > size && (bytes.size() - size) % kTriangle != 0;
  if (headed && (bytes.size() == size || more)) {
    content.polygons = declared;
    bytes.resize(size);
  } else if (ascii) {
    content = check_ascii(file, bytes);
  } else {
    const std::string said = headed ? ", its header declares " + std::to_string(declared) + " triangles" : "";
    throw FileError(file,
                    "is neither ascii STL nor binary STL of 84 + 50 n bytes: it has " +
                        std::to_string(bytes.size()) + " bytes" + said,
                    "it may be cut short, export or copy it again");
  }
  if (content.polygons == 0) throw FileError(file, "has no faces", "export the surface again");
  return content;
}

}  // namespace impinge
