// SPDX-License-Identifier: GPL-3.0-or-later
// The triangle mesh: plain data, indices into a list of points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sphere/triangle_cone.hpp"

namespace impinge {

using VertexIndex = std::uint32_t;  // index into the vertices of a mesh

/// The corners of a face, counter-clockwise as seen from outside.
using Face = std::array<VertexIndex, 3>;

/// Points in millimetres. Nothing is promised about closedness, orientation or duplicates; see
/// validation.hpp.
struct TriangleMesh {
  std::vector<Vec3> vertices;  // mm
  std::vector<Face> faces;     // their corners are indices into `vertices`
};

/// Corner k (0, 1 or 2) of a face, mm.
inline const Vec3& corner(const TriangleMesh& mesh, const Face& face, std::size_t k) {
  return mesh.vertices[face[k]];
}

/// All three corners of a face, mm.
inline std::array<Vec3, 3> corners_of(const TriangleMesh& mesh, const Face& face) {
  return {corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)};
}

/// A face of a mesh in the centre frame, as the centre sees it.
inline TriangleCone cone_of(const TriangleMesh& mesh, const Face& face) {
  return {corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)};
}

/// Vector along the outward normal whose length is twice the area of the face (mm^2).
Vec3 area_vector(const TriangleMesh& mesh, const Face& face);

/// The area that belongs to each vertex: a third of the area of its faces (mm^2).
std::vector<double> vertex_areas(const TriangleMesh& mesh);

/// The same mesh with `centre` as origin (input frame to centre frame).
TriangleMesh relative_to(TriangleMesh mesh, const Vec3& centre);

/// matrix x for each point x.
std::vector<Vec3> mapped(const Eigen::Matrix3d& matrix, const std::vector<Vec3>& points);

}  // namespace impinge
