// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a mesh near a direction, and the range of their radii: what is left to look at where a table
// does not decide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "table/cap_range.hpp"

namespace impinge {

/// Lists of faces by the entries of a grid on a cube whose cells are about as large as a face. O(faces)
/// memory for faces of similar size.
class FaceIndex {
 public:
  /// A face as seen from the centre.
  struct SeenFace {
    DirectionCap cap;   // holds its directions if less than a quarter turn wide
    RadiusRange range;  // holds its radii, mm
    int side = 0;       // orientation of its corners; 0 for a face that covers no direction
  };

  /// What the surface has near a direction.
  struct Neighbours {
    std::span<const std::uint32_t> faces;  // each that meets the cap once, and perhaps some that do not
    RadiusRange range;                     // of all that meet it
  };

  /// mesh in the centre frame.
  explicit FaceIndex(const TriangleMesh& mesh);

  /// Faces that may be met within reach() of the direction of x, of any length above zero. Faces whose plane
  /// holds the centre are left out.
  Neighbours near(const Vec3& x) const;

  double reach() const { return reach_; }                          // radians: about the size of a face
  const SeenFace& face(std::size_t f) const { return faces_[f]; }  // face f of the mesh
  std::size_t size() const { return faces_.size(); }               // number of faces of the mesh
  bool empty() const { return listed_.empty(); }                   // no face covers a direction
  std::size_t bytes() const;                                       // memory of the index, without the mesh

 private:
  void list_faces(const TriangleMesh& mesh);

  std::vector<SeenFace> faces_;
  CubeGnomonic grid_;
  double reach_;
  std::vector<RadiusRange> ranges_;  // of each entry
  std::vector<std::size_t> first_;   // faces of entry i: listed_[first_[i]] .. listed_[first_[i + 1] - 1]
  std::vector<std::uint32_t> listed_;
};

/// The face with these corners as the centre sees it; its range holds its radii, rounded outwards. A corner
/// in the centre has any direction.
FaceIndex::SeenFace see_face(const std::array<Vec3, 3>& corners);

}  // namespace impinge
