// SPDX-License-Identifier: GPL-3.0-or-later
// The faces and edges of a surface that a small cap of directions can meet, and what bends it there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sampling/layer.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"

namespace impinge {

// The plane q . x = 1 of a face as the centre sees it: r(u) = 1 / (q . u) along unit u.
struct SurfacePlane {
  TriangleCone cone;             // the face itself
  Vec3 inverse = Vec3::Zero();   // q, 1/mm
  double distance = 0.0;         // of the plane from the centre, 1 / |q|, mm
  double slope = 0.0;            // largest tan psi over the face; infinite for a face that is seen edge-on
  double least_radius = 0.0;     // over the face, mm
  double largest_radius = 0.0;   // over the face, mm
  double condition = 0.0;        // relative error of r that one rounding of the plane makes
  std::array<Vec3, 3> inward{};  // unit normals of the planes through the centre and an edge
  Vec3 middle = Vec3::Zero();    // a direction inside
  double chord = 0.0;            // longest from there to a direction of the face
};

// An edge of two or more faces: the inverse radius q . u is continuous across it, its slope jumps by that of
// q. Only edges between faces that lie on opposite sides of it; the others are jump edges (rim.hpp).
struct SurfaceKink {
  Vec3 across;            // unit normal of the plane through the centre and the edge
  Vec3 from;              // unit vectors to its ends
  Vec3 to;                // unit vector to the other end
  Vec3 jump;              // difference of q, 1/mm
  double least_radius;    // along the edge, mm
  double largest_radius;  // likewise
};

// A cap: all directions within `angle` radians of the unit vector `axis`.
struct Cap {
  Vec3 axis;     // the middle
  double angle;  // from the middle to the border
};

class SurfaceIndex {
 public:
  // mesh in the centre frame. `reach` is the largest angle of caps that will be asked for, radians.
  SurfaceIndex(const TriangleMesh& mesh, Layer layer, double reach);

  // Radius of the layer along unit u, mm; kNoSurface where it is not met.
  double radius(const Vec3& u) const;

  // Faces that may meet a cap, and edges. Not fewer than do; cap.angle <= reach.
  void faces_near(const Cap& cap, std::vector<std::uint32_t>& found) const;
  std::span<const std::uint32_t> kinks_of(std::uint32_t face) const;  // edges of a face, which kink() has
  // Faces that share directions with this one, so that a layer may change between them off their edges.
  std::span<const std::uint32_t> overlaps_of(std::uint32_t face) const;

  const SurfacePlane& plane(std::uint32_t face) const { return planes_[face]; }  // face `face` of the mesh
  const SurfaceKink& kink(std::uint32_t kink) const { return kinks_[kink]; }     // edge `kink`
  double reach() const { return reach_; }  // largest angle of a cap that may be asked for, radians

 private:
  // Lists of numbers, one after the other.
  struct Lists {
    std::vector<std::size_t> first{0};
    std::vector<std::uint32_t> value;
    std::span<const std::uint32_t> operator[](std::size_t k) const {
      return std::span(value).subspan(first[k], first[k + 1] - first[k]);
    }
  };
  static Lists gather(std::size_t count, const std::vector<std::array<std::uint32_t, 2>>& pairs);

  // Faces by the entry of a cube map that is nearest to a direction: all within `reach` of the direction.
  struct Level {
    CubeGnomonic bins;
    double reach;
    Lists faces;
    std::span<const std::uint32_t> near(const Vec3& u) const;
  };
  const Level& level_for(double angle) const;
  Level make_level(double reach) const;
  void find_planes(const TriangleMesh& mesh);
  void find_levels();
  void find_kinks(const TriangleMesh& mesh);
  void find_overlaps();

  Layer layer_;
  double reach_;
  std::vector<SurfacePlane> planes_;
  std::vector<SurfaceKink> kinks_;
  std::vector<Level> levels_;  // ever finer
  Lists kinks_of_face_;        // each kink at one of its faces
  Lists overlaps_of_face_;
};

// May the edge meet the cap?
bool meets(const SurfaceKink& kink, const Cap& cap);

// Largest and least radius of a plane within a cap and the face's own limits, mm, and its largest tan psi
// there. infinite slope where the cap may see the plane edge-on.
struct PlaneRange {
  double least;    // mm
  double largest;  // mm
  double slope;    // tan psi
};
// Of the part of the plane that the cap sees, or of the face where that is less.
PlaneRange range_within(const SurfacePlane& plane, const Cap& cap);

}  // namespace impinge
