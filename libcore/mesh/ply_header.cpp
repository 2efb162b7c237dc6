// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ply_header.hpp"

#include <algorithm>
#include <array>

#include "files/file_error.hpp"
#include "mesh/text_scan.hpp"

namespace impinge {
namespace {

using Words = std::vector<std::string_view>;

struct NamedType {
  std::string_view name;
  NumberType type;
};

constexpr std::array<NamedType, 16> kTypes{{
    {"char", {1, false, true}},
    {"int8", {1, false, true}},
    {"uchar", {1, false, false}},
    {"uint8", {1, false, false}},
    {"short", {2, false, true}},
    {"int16", {2, false, true}},
    {"ushort", {2, false, false}},
    {"uint16", {2, false, false}},
    {"int", {4, false, true}},
    {"int32", {4, false, true}},
    {"uint", {4, false, false}},
    {"uint32", {4, false, false}},
    {"float", {4, true, true}},
    {"float32", {4, true, true}},
    {"double", {8, true, true}},
    {"float64", {8, true, true}},
}};

std::optional<NumberType> to_type(std::string_view name) {
  const auto* const found = std::ranges::find(kTypes, name, &NamedType::name);
  return found == kTypes.end() ? std::nullopt : std::optional(found->type);
}

std::optional<PlyFormat> to_format(std::string_view name) {
  if (name == "ascii") return PlyFormat::ascii;
  if (name == "binary_little_endian") return PlyFormat::little_endian;
  if (name == "binary_big_endian") return PlyFormat::big_endian;
  return std::nullopt;
}

// property TYPE NAME, or property list COUNT_TYPE TYPE NAME.
std::optional<PlyProperty> to_property(const Words& words) {
  const bool list = words.size() == 5 && words[1] == "list";
  if (!list && words.size() != 3) return std::nullopt;
  const std::optional<NumberType> type = to_type(words[words.size() - 2]);
  const std::optional<NumberType> count = list ? to_type(words[2]) : std::nullopt;
  if (!type || (list && (!count || count->floating))) return std::nullopt;
  return PlyProperty{std::string(words.back()), *type, count};
}

std::optional<PlyElement> to_element(const Words& words) {
  const std::optional<std::int64_t> count = words.size() == 3 ? to_integer(words[2]) : std::nullopt;
  if (!count || *count < 0) return std::nullopt;
  return PlyElement{std::string(words[1]), *count, {}};
}

// Takes one line; false if it does not belong to a PLY header.
bool take(const Words& words, PlyHeader& header, bool& has_format) {
  if (words[0] == "comment" || words[0] == "obj_info") return true;
  if (words[0] == "format" && words.size() >= 2) {
    const std::optional<PlyFormat> format = to_format(words[1]);
    header.format = format.value_or(PlyFormat::ascii);
    has_format = format.has_value();
    return has_format;
  }
  if (words[0] == "element") {
    const std::optional<PlyElement> element = to_element(words);
    if (!element || find_element(header, element->name) != nullptr) return false;
    header.elements.push_back(*element);
    return true;
  }
  if (words[0] != "property" || header.elements.empty()) return false;
  const std::optional<PlyProperty> property = to_property(words);
  if (property) header.elements.back().properties.push_back(*property);
  return property.has_value();
}

}  // namespace

const PlyElement* find_element(const PlyHeader& header, std::string_view name) {
  const auto found = std::ranges::find(header.elements, name, &PlyElement::name);
  return found == header.elements.end() ? nullptr : &*found;
}

const PlyProperty* find_property(const PlyElement& element, std::string_view name) {
  const auto found = std::ranges::find(element.properties, name, &PlyProperty::name);
  return found == element.properties.end() ? nullptr : &*found;
}

PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view bytes) {
  LineScanner lines(bytes);
  if (lines.next() != "ply")
    throw FileError(file, "is no PLY file, its first line is not 'ply'", "export it again");
  PlyHeader header;
  bool has_format = false;
  Words words;
  while (const std::optional<std::string_view> line = lines.next()) {
    split_words(*line, words);
    if (words.empty()) continue;
    if (words[0] == "end_header") {
      if (!has_format) throw FileError(file, "its PLY header has no format line", "export it again");
      header.body = lines.rest();
      return header;
    }
    if (!take(words, header, has_format)) {
      throw FileError(file, "its PLY header has the line '" + std::string(line->substr(0, 60)) + "'",
                      "correct it or export the mesh again");
    }
  }
  throw FileError(file, "its PLY header has no end, the file is cut short", "export or copy it again");
}

}  // namespace impinge
