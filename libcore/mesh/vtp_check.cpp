// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/file_checks.hpp"
#include "mesh/polygon_ply.hpp"
#include "mesh/vtp_arrays.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

std::size_t declared_count(pugi::xml_node piece, const char* name) {
  return static_cast<std::size_t>(piece.attribute(name).as_ullong());
}

void add_cells(const VtpFile& vtp, pugi::xml_node piece, const char* kind, PolygonPly& mesh) {
  const std::size_t declared = declared_count(piece, (std::string("NumberOf") + kind).c_str());
  if (declared == 0) return;
  const auto numbers = [&](const char* name) {
    return vtp.numbers(piece.child(kind).find_child_by_attribute("Name", name));
  };
  const std::vector<double> ends = numbers("offsets");
  const bool whole = ends.size() == declared &&
                     mesh.add_cells(numbers("connectivity"), ends, kind == std::string_view("Strips"));
  if (!whole) vtp.throw_damaged("not all of its " + std::to_string(declared) + ' ' + kind + " are there");
}

}  // namespace

MeshFileContent check_vtp(const fs::path& file, std::string& bytes) {
  PolygonPly mesh;
  const VtpFile vtp(file, bytes);
  for (const pugi::xml_node piece : vtp.poly_data().children("Piece")) {
    const std::size_t declared = declared_count(piece, "NumberOfPoints");
    if (declared == 0) continue;
    const std::vector<double> points = vtp.numbers(piece.child("Points").child("DataArray"));
    if (points.size() % 3 != 0 || points.size() / 3 != declared)
      vtp.throw_damaged("not all of its " + std::to_string(declared) + " points are there");
    mesh.add_points(points);
    add_cells(vtp, piece, "Polys", mesh);
    add_cells(vtp, piece, "Strips", mesh);
  }
  bytes = mesh.bytes();
  return check_ply(file, bytes);
}

}  // namespace impinge
