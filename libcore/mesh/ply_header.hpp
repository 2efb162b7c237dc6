// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file (Turk, The PLY polygon file format, 1994).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace impinge {

struct PlyType {
  std::size_t size = 0;  // bytes
  bool floating = false;
  bool is_signed = false;
};

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count;  // of the length in front of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;  // as declared: not to be trusted
  std::vector<PlyProperty> properties;
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::string_view body;  // what follows end_header
};

// The first element or property of that name, or null.
const PlyElement* find_element(const PlyHeader& header, std::string_view name);
const PlyProperty* find_property(const PlyElement& element, std::string_view name);

// Throws FileError, naming the line that is wrong. `bytes` must outlive the result.
PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace impinge
