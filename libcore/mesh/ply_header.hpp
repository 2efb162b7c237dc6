// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file (Turk, The PLY polygon file format, 1994).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/number_bytes.hpp"

namespace impinge {

/// One value or list of every item of an element.
struct PlyProperty {
  std::string name;                 // as in the file
  NumberType type;                  // of the value, or of the values of a list
  std::optional<NumberType> count;  // the type of the length before a list
};

/// A kind of items, such as vertex or face.
struct PlyElement {
  std::string name;                     // as in the file
  std::int64_t count = 0;               // as declared; may be wrong
  std::vector<PlyProperty> properties;  // of each item, in the order of their values
};

/// How the values after the header are written.
enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;  // of the body
  std::vector<PlyElement> elements;     // in the order of their items in the body
  std::string_view body;                // what follows end_header
};

/// The first element or property of that name, or null.
const PlyElement* find_element(const PlyHeader& header, std::string_view name);
const PlyProperty* find_property(const PlyElement& element, std::string_view name);

/// Parses the header of a PLY file. Throws FileError that names the line that is wrong. `bytes` must outlive
/// the result.
PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace impinge
