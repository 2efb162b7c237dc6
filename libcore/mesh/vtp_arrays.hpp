// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a VTP file (VTK's XML format, PolyData), and the numbers of its arrays, however they are written.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace impinge {

/// Throws FileError if the file is cut short or not a VTP, holds another kind of data, or is compressed in
/// another way than by zlib. `bytes` must outlive it.
class VtpFile {
 public:
  VtpFile(const std::filesystem::path& file, std::string_view bytes);

  pugi::xml_node poly_data() const { return root().child("PolyData"); }

  /// The numbers of a DataArray, or the bytes of an array of strings: ascii, base64 or raw, inline or
  /// appended, in both byte orders, compressed or not. Throws FileError if they are missing or damaged.
  std::vector<double> numbers(pugi::xml_node array) const;

  [[noreturn]] void throw_damaged(const std::string& what) const;

 private:
  pugi::xml_node root() const { return document_.child("VTKFile"); }
  std::string data_of(pugi::xml_node array) const;

  std::filesystem::path file_;
  pugi::xml_document document_;
  std::string_view appended_;  // the data after the underscore
  bool big_endian_ = false;
  std::size_t header_size_ = 4;  // bytes of each number before the data
};

}  // namespace impinge
