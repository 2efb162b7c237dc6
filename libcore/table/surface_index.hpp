// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the faces and edges of a surface that a small cap of directions can meet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/edges.hpp"
#include "table/direction_index.hpp"
#include "table/layer.hpp"
#include "table/surface_kink.hpp"
#include "table/surface_plane.hpp"

namespace impinge {

class SurfaceIndex {
 public:
  /// `mesh` is in the centre frame. `reach` is the largest radius of caps that will be asked for, radians.
  SurfaceIndex(const TriangleMesh& mesh, Layer layer, double reach);

  /// Radius of the layer along unit u, mm; kNoSurface if it is not met.
  double radius(const Vec3& u) const;

  /// Finds all faces that meet the cap or have a kink that does, and perhaps others. cap.radius <= reach().
  void faces_near(const DirectionCap& cap, std::vector<std::uint32_t>& found) const;
  /// Numbers of the kinks of a face, for kink(). Each edge is listed at one of its faces only.
  std::span<const std::uint32_t> kinks_of(std::uint32_t face) const { return kinks_of_face_[face]; }
  /// Faces that share directions with this one, so that a layer may change between them away from edges.
  std::span<const std::uint32_t> overlaps_of(std::uint32_t face) const { return overlaps_of_face_[face]; }

  const SurfacePlane& plane(std::uint32_t face) const { return planes_[face]; }  // face `face` of the mesh
  const SurfaceKink& kink(std::uint32_t kink) const { return kinks_[kink]; }     // edge `kink`
  double reach() const { return reach_; }  // largest radius of caps, radians

 private:
  /// Faces by the entry of a cube map that is nearest to a direction: all within `reach` of the direction.
  struct Level {
    DirectionIndex bins;
    double reach;
  };
  const Level& level_for(double angle) const;
  Level make_level(double reach) const;
  void find_planes(const TriangleMesh& mesh);
  void find_levels();
  Vec3 largest_jump(std::span<const HalfEdge> sides) const;
  void find_kinks(const TriangleMesh& mesh);
  void find_overlaps();

  Layer layer_;
  double reach_;
  std::vector<SurfacePlane> planes_;
  std::vector<SurfaceKink> kinks_;
  std::vector<Level> levels_;  // from coarse to fine
  Lists kinks_of_face_;        // each kink at one of its faces
  Lists overlaps_of_face_;
};

}  // namespace impinge
