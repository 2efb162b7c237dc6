// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "files/file_error.hpp"
#include "mesh/file_checks.hpp"
#include "mesh/text_scan.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string_view>;

std::string without_comments(std::string bytes) {
  bool comment = false;
  for (char& c : bytes) {
    comment = c != '\n' && (comment || c == '#');
    if (comment) c = ' ';
  }
  return bytes;
}

// Appends words 0..n-1 as one line.
void append_line(std::string& text, const Words& words, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) text.append(words[k]).push_back(k + 1 < n ? ' ' : '\n');
}

[[noreturn]] void throw_damaged(const fs::path& file, const char* what, std::int64_t i, std::int64_t n) {
  throw FileError(file,
                  std::string("ends within or cannot be read at ") + what + ' ' + std::to_string(i) +
                      " of the " + std::to_string(n) + " declared, it is cut short or damaged",
                  "export or copy it again");
}

// Are the first n words there, and numbers?
bool has_numbers(const Words& words, std::size_t n) {
  return words.size() >= n && std::all_of(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(n),
                                          [](std::string_view w) { return to_number(w).has_value(); });
}

// Numbers of vertices, faces and edges; on the line of the keyword or on the next.
std::array<std::int64_t, 3> counts(const fs::path& file, LineScanner& lines) {
  Words words = lines.next_words();
  constexpr std::array<std::string_view, 5> kKeywords{"OFF", "COFF", "NOFF", "CNOFF", "STOFF"};
  if (words.empty() || std::ranges::find(kKeywords, words[0]) == kKeywords.end()) {
    throw FileError(file, "is no OFF file, it does not begin with OFF", "export it again");
  }
  words.erase(words.begin());
  if (words.empty()) words = lines.next_words();
  std::array<std::int64_t, 3> n{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<std::int64_t> count = k < words.size() ? to_integer(words[k]) : std::nullopt;
    if (!count || *count < 0) {
      throw FileError(file, "has no counts of vertices, faces and edges behind OFF (binary OFF is not read)",
                      "export it again, as text");
    }
    n[k] = *count;
  }
  return n;
}

// Are all corners there, and are they integers?
bool is_face(const Words& words) {
  const std::optional<std::int64_t> n = words.empty() ? std::nullopt : to_integer(words[0]);
  if (!n || *n < 0 || static_cast<std::size_t>(*n) >= words.size()) return false;
  return std::all_of(words.begin() + 1, words.begin() + 1 + *n,
                     [](std::string_view word) { return to_integer(word).has_value(); });
}

void check_corners(const fs::path& file, const Words& words, std::int64_t face, std::int64_t vertices) {
  for (std::int64_t k = 1; k <= *to_integer(words[0]); ++k) {
    const std::int64_t v = *to_integer(words[static_cast<std::size_t>(k)]);
    if (v >= 0 && v < vertices) continue;
    throw FileError(file, "face " + std::to_string(face) + " names a vertex that is not there, it is damaged",
                    "export it again");
  }
}

}  // namespace

MeshFileContent check_off(const fs::path& file, std::string& bytes) {
  const std::string input = without_comments(std::move(bytes));
  LineScanner lines(input);
  const auto [vertices, faces, edges] = counts(file, lines);
  MeshFileContent content{static_cast<std::size_t>(vertices), 0, MeshFileSums{}};
  bytes = "OFF\n" + std::to_string(vertices) + ' ' + std::to_string(faces) + " 0\n";
  for (std::int64_t i = 0; i < vertices; ++i) {
    const Words& words = lines.next_words();
    if (!has_numbers(words, 3)) throw_damaged(file, "vertex", i, vertices);
    for (std::size_t k = 0; k < 3; ++k) content.sums->coordinates += std::abs(*to_number(words[k]));
    append_line(bytes, words, 3);
  }
  for (std::int64_t i = 0; i < faces; ++i) {
    const Words& words = lines.next_words();
    if (!is_face(words)) throw_damaged(file, "face", i, faces);
    check_corners(file, words, i, vertices);
    const auto corners = static_cast<std::size_t>(*to_integer(words[0]));
    append_line(bytes, words, 1 + corners);
    if (corners < 3) continue;
    ++content.polygons;
    for (std::size_t k = 1; k <= corners; ++k) content.sums->corners += *to_number(words[k]);
  }
  if (content.polygons == 0) {
    throw FileError(file, "has no faces, only points", "triangulate the surface first");
  }
  return content;
}

}  // namespace impinge
