// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/raw_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "files/file_error.hpp"
#include "mesh/collinear.hpp"
#include "mesh/weld.hpp"

namespace impinge {
namespace {

// The points and faces, not yet welded.
TriangleMesh gathered(const std::filesystem::path& file, const RawMesh& raw) {
  TriangleMesh mesh;
  const std::size_t points = raw.positions.size() / 3;
  for (std::size_t i = 0; i < points; ++i)
    mesh.vertices.emplace_back(raw.positions[3 * i], raw.positions[3 * i + 1], raw.positions[3 * i + 2]);
  const bool soup = raw.corners.empty();
  const std::size_t corners = soup ? points : raw.corners.size();
  if (raw.positions.size() % 3 != 0 || corners % 3 != 0)
    throw FileError(file, "ends within a point or a face", "export it again");
  const auto index = [&](std::size_t k) { return soup ? static_cast<VertexIndex>(k) : raw.corners[k]; };
  for (std::size_t k = 0; k < corners; k += 3) mesh.faces.push_back({index(k), index(k + 1), index(k + 2)});
  return mesh;
}

}  // namespace

void require_area(const std::filesystem::path& file, const TriangleMesh& mesh) {
  const auto flat = [&mesh](const Face& f) {
    return collinear(corner(mesh, f, 0), corner(mesh, f, 1), corner(mesh, f, 2));
  };
  if (std::ranges::all_of(mesh.faces, flat))
    throw FileError(file, "none of its faces has an area", "export the surface again");
}

TriangleMesh mesh_of(const std::filesystem::path& file, const RawMesh& raw) {
  TriangleMesh mesh = gathered(file, raw);
  if (mesh.faces.empty()) throw FileError(file, "has no faces, only points", "triangulate the surface first");
  const auto there = [&mesh](VertexIndex v) { return v < mesh.vertices.size(); };
  if (!std::ranges::all_of(mesh.faces, [&](const Face& face) { return std::ranges::all_of(face, there); }))
    throw FileError(file, "a face names a vertex that is not there, it is damaged", "export it again");
  const auto lost = std::ranges::count_if(mesh.vertices, [](const Vec3& v) { return !v.allFinite(); });
  if (lost > 0) {
    throw FileError(file,
                    std::to_string(lost) + (lost == 1 ? " vertex has" : " vertices have") +
                        " coordinates that are NaN, infinite or beyond 3e38",
                    "remove them or export the mesh again");
  }
  mesh = weld(mesh);
  require_area(file, mesh);
  return mesh;
}

}  // namespace impinge
