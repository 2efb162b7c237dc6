// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh of several surfaces: the main one first, then parts of bone beside it, such as a trochanter. Which
// contacts of parts count is said in limits/body_pairs.hpp.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Where a part begins in a mesh; it ends where the next one begins.
struct MeshPart {
  std::string name;              // in words, such as "greater trochanter"
  std::size_t first_vertex = 0;  // its number in the mesh
  std::size_t first_face = 0;    // its number in the mesh
  bool of_main = false;          // it continues the main surface, as one bone: vertices between them are at
                                 // the same places. Such parts come first
};

/// Appends a part to a mesh and to its list of parts.
void append_part(TriangleMesh& mesh, std::vector<MeshPart>& parts, const std::string& name,
                 const TriangleMesh& part);

/// The mesh without its parts. Spheres, rims, axes and measures are taken from this surface.
TriangleMesh main_surface(const TriangleMesh& mesh, std::span<const MeshPart> parts);

/// The main surface with the parts that continue it, as one mesh again (weld.hpp).
TriangleMesh whole_main(const TriangleMesh& mesh, std::span<const MeshPart> parts);

/// Part k of the mesh.
TriangleMesh part_surface(const TriangleMesh& mesh, std::span<const MeshPart> parts, std::size_t k);

/// The name of a body of a mesh: none for body 0, the bone of the main surface. Other bodies are the parts
/// that do not continue it.
std::optional<std::string> body_name(std::span<const MeshPart> parts, std::size_t body);

/// The parts of both bones, each a surface of its own, mm.
struct BoneParts {
  std::vector<TriangleMesh> ball;              // beside the ball
  std::vector<TriangleMesh> socket;            // beside the socket
  std::optional<TriangleMesh> whole_ball{};    // the bone of the ball, if that is more than the ball
  std::optional<TriangleMesh> whole_socket{};  // the bone of the socket, if that is more than the socket
};
/// All parts of a mesh that do not belong to the main bone.
std::vector<TriangleMesh> part_surfaces(const TriangleMesh& mesh, std::span<const MeshPart> parts);
struct MeshWithParts {
  const TriangleMesh& mesh;
  std::span<const MeshPart> parts;
};
BoneParts bone_parts(const MeshWithParts& ball, const MeshWithParts& socket);

}  // namespace impinge
