// SPDX-License-Identifier: GPL-3.0-or-later
// Reports what is wrong with a mesh, in numbers. Nothing is repaired and nothing thrown: any mesh gets a
// report.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "mesh/edges.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Edges, flips, components and duplicates are counted among the faces that have three different corners.
struct MeshReport {
  std::size_t vertices = 0;               // of the mesh, referenced or not
  std::size_t faces = 0;                  // of the mesh, valid or not
  std::size_t unreferenced_vertices = 0;  // corners of no face
  std::size_t non_finite_vertices = 0;    // with a NaN or infinite coordinate
  std::size_t invalid_faces = 0;          // with a vertex index that does not exist
  std::size_t degenerate_faces = 0;       // a corner twice, or no area (exactly, see collinear.hpp)
  std::size_t duplicate_faces = 0;        // the corners of an earlier face, in any order
  std::size_t flipped_faces = 0;          // see below
  std::size_t non_manifold_edges = 0;     // with three faces or more
  std::size_t boundary_edges = 0;         // with one face
  std::size_t components = 0;             // faces connected through vertices
  bool orientable = true;                 // false: some faces cannot agree (Moebius strip)
  std::optional<double> volume;           // signed, mm^3; closed meshes of one orientation only

  /// Does every edge have exactly two faces?
  bool closed() const;
  /// Adds the counts of another mesh that is appended to this one; there is a volume if both have one.
  MeshReport& operator+=(const MeshReport& other);
};

/// The report on a mesh. Two faces at an edge agree if they run through it in opposite directions. In each
/// part that is connected over edges with two faces, the faces of the smaller group count as flipped; a part
/// that is inside out as a whole has none, and shows as a negative volume.
MeshReport validate(const TriangleMesh& mesh);

/// One line with the sizes and, if anything is wrong, a second one that lists it. No line end after the last.
std::string describe(const MeshReport& report);

}  // namespace impinge
