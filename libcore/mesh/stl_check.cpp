// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>

#include "mesh/file_checks.hpp"
#include "mesh/file_error.hpp"
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
  throw MeshFileError(
      file,
      "ends within or cannot be read at facet " + std::to_string(facet) + ", it is cut short or damaged",
      "export or copy it again");
}

bool is_vertex(const std::vector<std::string_view>& words) {
  return words.size() == 4 && words[0] == "vertex" &&
         std::all_of(words.begin() + 1, words.end(),
                     [](std::string_view w) { return to_number(w).has_value(); });
}

// facet normal x y z / outer loop / vertex x y z, three times / endloop / endfacet.
void check_facet(const fs::path& file, LineScanner& lines, std::size_t facet) {
  const auto expect = [&](bool right) {
    if (!right) throw_damaged(file, facet);
  };
  const auto starts = [&lines](std::string_view word) {
    const auto& words = lines.next_words();
    return !words.empty() && words[0] == word;
  };
  expect(starts("outer"));
  for (int k = 0; k < 3; ++k) expect(is_vertex(lines.next_words()));
  expect(starts("endloop"));
  expect(starts("endfacet"));
}

MeshFileContent check_ascii(const fs::path& file, std::string_view bytes) {
  LineScanner lines(bytes);
  MeshFileContent content;
  bool ended = false;
  while (true) {
    const auto& words = lines.next_words();
    if (words.empty()) break;
    if (words[0] == "facet") {
      check_facet(file, lines, content.polygons++);
    } else if (words[0] != "solid" && words[0] != "endsolid") {
      throw_damaged(file, content.polygons);
    }
    ended = words[0] == "endsolid";
  }
  if (!ended) throw MeshFileError(file, "has no endsolid, it is cut short", "export or copy it again");
  return content;
}

}  // namespace

MeshFileContent check_stl(const fs::path& file, std::string_view bytes) {
  MeshFileContent content;
  const bool ascii = bytes.starts_with("solid") && bytes.find('\0') == std::string_view::npos;
  if (bytes.size() >= kHeader && declared_triangles(bytes) * kTriangle + kHeader == bytes.size()) {
    content.polygons = declared_triangles(bytes);
  } else if (ascii) {
    content = check_ascii(file, bytes);
  } else {
    const std::string declared =
        bytes.size() < kHeader
            ? ""
            : ", its header declares " + std::to_string(declared_triangles(bytes)) + " triangles";
    throw MeshFileError(file,
                        "is neither ascii STL nor binary STL of 84 + 50 n bytes: it has " +
                            std::to_string(bytes.size()) + " bytes" + declared,
                        "it may be cut short, export or copy it again");
  }
  if (content.polygons == 0) throw MeshFileError(file, "has no faces", "export the surface again");
  return content;
}

}  // namespace impinge
