// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as the centre sees it, face by face: planes, sides and neighbours, for statements about whole
// caps of directions that hold for its faces, not its vertices alone.
//
// Along a direction u of a face 1 / r = q . u, with q the normal of its plane over the plane's offset. A q in
// doubles is only near that vector; its error is bounded by what it gives at the corners themselves: a point
// of the face p = sum of l_k v_k, l_k >= 0 and of sum 1, has q . p within max |q . v_k - 1| of 1. So
// 1 / r is q . u to a share of `doubt`, however q was rounded.
//
// Over a cap of radius rho about a unit w the most that q . u can be is, A = q . w and T = |q x w|,
//   |q| if T <= A tan rho, else A cos rho + T sin rho          (rho below a quarter turn)
// which is convex in w, as the largest of linear functions, and of degree 1.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "contact/cap_tree.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/face_cap.hpp"
#include "table/layer.hpp"

namespace impinge {

/// A cap of directions narrower than a quarter turn, as planes and their inner products need it.
struct CapAngle {
  explicit CapAngle(double radians);  // of 0 or more
  double radius;                      // radians
  double cosine, sine, tangent;       // of it
  bool wide;                          // is it a quarter turn or more? Then nothing but ranges holds
};

/// Slack for the planes of sides, which are off by 1e-10 at most: a side seen under less than 1e-6 rad has
/// none.
inline constexpr double kSideSlack = 1e-9;

/// The most, and the least, that q . u is over all unit u within the cap about w, times |w|.
double most_over(const Vec3& q, const Vec3& w, const CapAngle& cap);
double least_over(const Vec3& q, const Vec3& w, const CapAngle& cap);

/// A face.
struct DirectionFace {
  static constexpr std::uint32_t kNone = 0xffffffffU;
  static constexpr double kLeastCosine = 0.25;  // of the widest cap whose face has a plane

  std::array<Vec3, 3> corner;  // unit vectors
  std::array<Vec3, 3>
      inward;          // unit vector across the side from corner k to k + 1, towards the face; or zero
  Vec3 plane;          // q, 1 / mm; zero where nothing is known of it
  double doubt = 0.0;  // share of 1 / r that it may be off by
  RadiusRange range;   // mm
  DirectionCap cap;    // holds its directions
  std::array<std::uint32_t, 3> beyond;  // a face on the other side of each side; kNone where none is
};

/// A polygon of directions, as unit vectors or shorter.
class DirectionPolygon {
 public:
  explicit DirectionPolygon(const std::array<Vec3, 3>& corners)
      : points_{corners[0], corners[1], corners[2]}, size_(3) {}
  /// Keeps what has normal . x >= least.
  void clip(const Vec3& normal, double least);
  std::span<const Vec3> points() const& { return {points_.data(), size_}; }
  std::span<const Vec3> points() const&& = delete;

 private:
  static constexpr std::size_t kMost = 16;  // a triangle, clipped five times, slivers allowed for
  std::array<Vec3, kMost> points_;
  std::size_t size_;
};

/// Memory of a search over a surface.
struct PatchMemory {
  std::vector<std::uint32_t> faces;  // that were reached
  std::vector<std::uint32_t> mark;   // of each face: the search that reached it last
  std::uint32_t search = 0;          // this one
};

class SeenSurface {
 public:
  /// mesh in the centre frame, mm. Faces that are edge-on are left out, or kept by their caps and ranges
  /// alone.
  SeenSurface(const TriangleMesh& mesh, Layer layer, bool keep_edge_on = false);

  const CapTree& face_tree() const { return face_tree_; }
  const CapTree& vertex_tree() const { return vertex_tree_; }
  const std::vector<DirectionFace>& faces() const { return faces_; }  // in the order of their tree
  const std::vector<Vec3>& vertices() const { return vertices_; }  // of faces, in the order of their tree, mm
  double least_radius() const { return least_radius_; }            // of all faces, mm
  Layer layer() const { return layer_; }
  bool edge_on() const { return edge_on_; }  // were edge-on faces kept?

  /// The face of the layer along unit u; kNone where there is none.
  std::uint32_t face_along(const Vec3& u) const;
  /// Calls visit(face) for every face that unit u meets within its sides until it returns true; returns
  /// whether it did. Along a side itself no face is found.
  bool any_along(const Vec3& u, const std::function<bool(std::uint32_t)>& visit) const;

  /// May that face, or any, have a direction in the cap? Not if the cap is wholly beyond one of its sides.
  bool near(std::uint32_t f, const DirectionCap& cap) const;
  bool any_near(const DirectionCap& cap) const;

  /// Do the faces that are reached from `from` across sides within the cap cover all of it, and does
  /// keeps(face) hold for each? `from` must hold the axis. A way along a great circle from the axis to a
  /// direction u of the cap that meets no corner crosses sides only, each within the cap, so that there is a
  /// face on the other side each time: u is covered by one of the faces that were asked. A direction whose
  /// way meets a corner is a limit of others, and the faces are closed.
  template <class Keeps>
  bool covers(const DirectionCap& cap, std::uint32_t from, PatchMemory& memory, Keeps&& keeps) const {
    begin(memory, from);
    const double cosine = cap.radius < kPi ? std::cos(cap.radius) - kSideSlack : -2.0;
    const double sine = cap.radius < 0.5 * kPi ? std::sin(cap.radius) + kSideSlack : 2.0;
    for (std::size_t next = 0; next < memory.faces.size(); ++next) {
      const DirectionFace& face = faces_[memory.faces[next]];
      if (!keeps(face)) return false;
      for (std::size_t k = 0; k < 3; ++k) {
        if (!side_meets(face, k, {cap.axis, cosine, sine})) continue;
        if (face.beyond[k] == DirectionFace::kNone) return false;
        reach(memory, face.beyond[k]);
      }
    }
    return true;
  }

 private:
  template <class Visit>
  bool any_of(const DirectionCap& cap, const Visit& visit) const;  // faces that may be met there
  struct CapBorder {
    Vec3 axis;
    double cosine, sine;  // of the radius
  };
  static bool side_meets(const DirectionFace& face, std::size_t side, const CapBorder& cap);
  void begin(PatchMemory& memory, std::uint32_t from) const;
  static void reach(PatchMemory& memory, std::uint32_t face);

  Layer layer_;
  CapTree face_tree_;
  CapTree vertex_tree_;
  std::vector<DirectionFace> faces_;
  std::vector<Vec3> vertices_;
  double least_radius_ = HUGE_VAL;
  bool edge_on_ = false;
};

}  // namespace impinge
