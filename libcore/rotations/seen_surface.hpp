// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as the centre sees it, face by face: planes, sides and neighbours. For statements about all faces
// over a cap of directions, not only about vertices. Theorem 14 (volume), (ii) and its use.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "contact/cap_tree.hpp"
#include "mesh/triangle_distance.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/face_cap.hpp"
#include "table/layer.hpp"

namespace impinge {

/// The radius of a cap of directions, with its cosine, sine and tangent.
struct CapAngle {
  explicit CapAngle(double radians);  // 0 or more
  double radius;                      // radians
  double cosine, sine, tangent;       // of the radius
  bool wide;                          // is it about a quarter turn or more? Then most_over() does not hold
};

/// Above the error of planes through sides, 1e-10 at most: a side seen under less than 1e-6 rad has none.
inline constexpr double kSideSlack = 1e-9;

/// The largest, and the least, q . u of all u of the length |w| in the cap about w, unless the cap is wide.
double most_over(const Vec3& q, const Vec3& w, const CapAngle& cap);
double least_over(const Vec3& q, const Vec3& w, const CapAngle& cap);

/// A face, as the centre sees it.
struct DirectionFace {
  static constexpr std::uint32_t kNone = 0xffffffffU;
  static constexpr double kLeastCosine = 0.25;  // a face whose cap is wider has no plane

  std::array<Vec3, 3> corner;  // unit vectors
  std::array<Vec3, 3> inward;  // unit normal, towards the face, of the plane through the centre and the side
                               // from corner k to k + 1; or zero
  Vec3 plane;          // q, 1 / mm, with 1 / r = q . u along unit u; zero where q is not known well enough
  double doubt = 0.0;  // relative error of 1 / r at most
  RadiusRange range;   // least and largest radius, mm
  DirectionCap cap;    // holds all directions of the face
  std::array<std::uint32_t, 3> beyond;  // a face across each side, on the other side of it; or kNone
};

/// May the face have a direction in the cap? No is certain.
bool near(const DirectionFace& face, const DirectionCap& cap);

/// A side of a face beyond which there is no other: a border, or where the surface turns back.
struct SeenBorder {
  Vec3 middle;  // unit vector
  Vec3 inward;  // as of the face
};

/// A convex polygon: of directions, its corners unit vectors or shorter, or of a face.
class DirectionPolygon {
 public:
  explicit DirectionPolygon(std::span<const Vec3> corners) : size_(corners.size()) {
    std::copy(corners.begin(), corners.end(), points_.begin());
  }
  /// Keeps the points x with normal . x >= least.
  void clip(const Vec3& normal, double least);
  std::span<const Vec3> points() const& { return {points_.data(), size_}; }
  std::span<const Vec3> points() const&& = delete;

  static constexpr std::size_t kMost = 16;  // a triangle that is clipped five times, and a few more

 private:
  std::array<Vec3, kMost> points_;
  std::size_t size_;
};

/// Memory of SeenSurface::covers(), which may be used again.
struct PatchMemory {
  std::vector<std::uint32_t> faces;  // faces that were reached
  std::vector<std::uint32_t> mark;   // for each face: the number of the search that reached it last
  std::uint32_t search = 0;          // the number of the present search
};

class SeenSurface {
 public:
  /// mesh in the centre frame, mm. Edge-on faces are left out; or, if keep_edge_on, kept with a cap and a
  /// range of radii but no plane.
  SeenSurface(const TriangleMesh& mesh, Layer layer, bool keep_edge_on = false);

  const CapTree& face_tree() const { return face_tree_; }
  const CapTree& vertex_tree() const { return vertex_tree_; }
  const std::vector<DirectionFace>& faces() const { return faces_; }  // in the order of face_tree()
  const std::vector<Vec3>& vertices() const { return vertices_; }     // mm, in the order of vertex_tree()
  /// The corners of face f among vertices(); kNone for one at the centre.
  const std::array<std::uint32_t, 3>& corners(std::uint32_t f) const { return corners_[f]; }
  const Triangle& triangle(std::uint32_t f) const { return triangles_[f]; }  // mm
  std::vector<SeenBorder> borders() const;
  /// Face f as another centre sees it, mm; without neighbours.
  DirectionFace seen_from(std::uint32_t f, const Vec3& centre) const;
  double least_radius() const { return least_radius_; }  // of all faces, mm; 0 if one is edge-on
  double least_distance() const;                         // of its points from the centre, mm, rounded down
  Layer layer() const { return layer_; }
  bool edge_on() const { return edge_on_; }  // were edge-on faces kept?

  /// The face of the layer along unit u; kNone where there is none.
  std::uint32_t face_along(const Vec3& u) const;
  /// Calls visit(face) for every face that unit u meets until it returns true; returns whether it did. A face
  /// is not found along its sides.
  bool any_along(const Vec3& u, const std::function<bool(std::uint32_t)>& visit) const;

  /// May any face have a direction in the cap? No is certain.
  bool any_near(const DirectionCap& cap) const;

  /// Do the faces that are reached from `from`, across sides that meet the cap, cover all of the cap, and
  /// does keeps(face) hold for each? Yes is certain. `from` must hold the cap's axis.
  template <class Keeps, class Ends>
  bool covers(const DirectionCap& cap, std::uint32_t from, PatchMemory& memory, Keeps&& keeps,
              Ends&& ends) const {
    begin(memory, from);
    const double cosine = cap.radius < kPi ? std::cos(cap.radius) - kSideSlack : -2.0;
    const double sine = cap.radius < 0.5 * kPi ? std::sin(cap.radius) + kSideSlack : 2.0;
    for (std::size_t next = 0; next < memory.faces.size(); ++next) {
      const DirectionFace& face = faces_[memory.faces[next]];
      if (!keeps(face)) return false;
      for (std::size_t k = 0; k < 3; ++k) {
        if (!side_meets(face, k, {cap.axis, cosine, sine})) continue;
        if (face.beyond[k] != DirectionFace::kNone)
          reach(memory, face.beyond[k]);
        else if (!ends(face.inward[k]))
          return false;
      }
    }
    return true;
  }

  template <class Keeps>
  bool covers(const DirectionCap& cap, std::uint32_t from, PatchMemory& memory, Keeps&& keeps) const {
    return covers(cap, from, memory, std::forward<Keeps>(keeps), [](const Vec3&) { return false; });
  }

 private:
  template <class Visit>
  bool any_of(const DirectionCap& cap, const Visit& visit) const;  // visits faces whose caps meet the cap
  struct CapBorder {
    Vec3 axis;
    double cosine, sine;  // of the cap's radius
  };
  static bool side_meets(const DirectionFace& face, std::size_t side, const CapBorder& cap);
  void begin(PatchMemory& memory, std::uint32_t from) const;
  static void reach(PatchMemory& memory, std::uint32_t face);

  Layer layer_;
  CapTree face_tree_;
  CapTree vertex_tree_;
  std::vector<DirectionFace> faces_;
  std::vector<Triangle> triangles_;  // of each face, mm
  std::vector<Vec3> vertices_;
  std::vector<std::array<std::uint32_t, 3>> corners_;
  double least_radius_ = HUGE_VAL;
  bool edge_on_ = false;
};

}  // namespace impinge
