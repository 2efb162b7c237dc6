// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <string>
#include <system_error>

#include "files/file_bytes.hpp"
#include "mesh/declared_axes.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_format.hpp"
#include "mesh/vtp_arrays.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

std::string head_of(const fs::path& file) {
  std::string head(kAxesHead, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

// The axes in the field SPACE.
std::optional<std::string> axes_of_vtp(const fs::path& file) {
  std::error_code unreadable;
  if (!fs::is_regular_file(file, unreadable) || fs::file_size(file, unreadable) > kMostMeshBytes)
    return std::nullopt;
  const std::string bytes = read_bytes(file);
  const VtpFile vtp(file, bytes);
  const pugi::xml_node said = vtp.poly_data().child("FieldData").find_child_by_attribute("Name", "SPACE");
  if (!said) return std::nullopt;
  std::string code;
  for (const double c : vtp.numbers(said)) {
    if (c >= 'A' && c <= 'Z') code += static_cast<char>(c);
  }
  return code == "RAS" || code == "LPS" ? std::optional(code) : std::nullopt;
}

}  // namespace

std::optional<std::string> declared_axes(const fs::path& file) {
  return mesh_format(file) == MeshFormat::vtp ? axes_of_vtp(file) : declared_axes(file, head_of(file));
}

AxesChoice agreed_axes_of(const std::vector<fs::path>& files, const std::optional<std::string>& given,
                          const std::string& option) {
  std::vector<SaidAxes> said;
  said.reserve(files.size());
  for (const fs::path& file : files) said.push_back({file, declared_axes(file)});
  return agreed_axes(said, given, option);
}

}  // namespace impinge
