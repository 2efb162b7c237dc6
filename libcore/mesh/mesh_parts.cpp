// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_parts.hpp"

#include "mesh/weld.hpp"

namespace impinge {
namespace {

TriangleMesh between(const TriangleMesh& mesh, const MeshPart& from, const MeshPart& to) {
  TriangleMesh part;
  for (std::size_t v = from.first_vertex; v < to.first_vertex; ++v) part.vertices.push_back(mesh.vertices[v]);
  for (std::size_t f = from.first_face; f < to.first_face; ++f) {
    Face face = mesh.faces[f];
    for (VertexIndex& v : face) v -= static_cast<VertexIndex>(from.first_vertex);
    part.faces.push_back(face);
  }
  return part;
}

// The mesh up to where a part begins, or up to its end.
TriangleMesh up_to(const TriangleMesh& mesh, std::span<const MeshPart> parts, std::size_t k) {
  return k < parts.size() ? between(mesh, {}, parts[k]) : mesh;
}

}  // namespace

void append_part(TriangleMesh& mesh, std::vector<MeshPart>& parts, const std::string& name,
                 const TriangleMesh& part) {
  const std::size_t before = mesh.vertices.size();
  parts.push_back({name, before, mesh.faces.size()});
  mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (Face face : part.faces) {
    for (VertexIndex& v : face) v += static_cast<VertexIndex>(before);
    mesh.faces.push_back(face);
  }
}

TriangleMesh main_surface(const TriangleMesh& mesh, std::span<const MeshPart> parts) {
  return up_to(mesh, parts, 0);
}

TriangleMesh part_surface(const TriangleMesh& mesh, std::span<const MeshPart> parts, std::size_t k) {
  const MeshPart end{"", mesh.vertices.size(), mesh.faces.size()};
  return between(mesh, parts[k], k + 1 < parts.size() ? parts[k + 1] : end);
}

// The number of the first part that is not of the main bone, whose parts come first.
static std::size_t rests(std::span<const MeshPart> parts) {
  std::size_t k = 0;
  while (k < parts.size() && parts[k].of_main) ++k;
  return k;
}

std::optional<std::string> body_name(std::span<const MeshPart> parts, std::size_t body) {
  if (body == 0) return std::nullopt;
  return parts[rests(parts) + body - 1].name;
}

std::vector<TriangleMesh> part_surfaces(const TriangleMesh& mesh, std::span<const MeshPart> parts) {
  std::vector<TriangleMesh> surfaces;
  for (std::size_t k = rests(parts); k < parts.size(); ++k) surfaces.push_back(part_surface(mesh, parts, k));
  return surfaces;
}

TriangleMesh whole_main(const TriangleMesh& mesh, std::span<const MeshPart> parts) {
  const std::size_t k = rests(parts);
  return k == 0 ? main_surface(mesh, parts) : weld(up_to(mesh, parts, k));
}

static std::optional<TriangleMesh> whole_bone(const MeshWithParts& of) {
  return rests(of.parts) == 0 ? std::nullopt : std::optional(whole_main(of.mesh, of.parts));
}

BoneParts bone_parts(const MeshWithParts& ball, const MeshWithParts& socket) {
  return {part_surfaces(ball.mesh, ball.parts), part_surfaces(socket.mesh, socket.parts), whole_bone(ball),
          whole_bone(socket)};
}

}  // namespace impinge
