// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the faces of a surface near a direction, and what they prove about any table of the surface, without
// making one. It is ready in a few milliseconds: for a few directions, for which a table costs more than it
// saves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mesh/jump_edges.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/direction_index.hpp"
#include "table/face_cap.hpp"
#include "table/layer.hpp"

namespace impinge {

class NearFaces {
 public:
  /// What holds for all directions within the margin of the one that was asked for.
  struct Near {
    std::span<const std::uint32_t> faces;  // every face that is met there, and perhaps some that are not
    RadiusRange range;  // mm, holds every radius there and every mean of them; empty without a face
    bool rim = true;    // may the surface end or jump there?

    bool nothing() const { return range.empty(); }  // no face is met
  };

  /// `mesh` is in the centre frame and must outlive this; `margin` is in radians. Faces whose plane holds the
  /// centre cover no direction and are not listed.
  NearFaces(const TriangleMesh& mesh, double margin);
  NearFaces(const TriangleMesh&&, double) = delete;

  /// The faces near the direction of x, of any length. For x = 0, which has no direction, nothing is known:
  /// no faces, any radius.
  Near near(const Vec3& x) const;

  /// Radius of the layer along unit u, mm; kNoSurface if it meets no face. Equal to what fill_exact() gives
  /// an entry in this direction.
  double radius(const Vec3& u, Layer layer) const;

  /// A bound on radius(), from planes and not faces, in a third of the time: no larger for Layer::nearest, no
  /// smaller for Layer::farthest; infinite where no face can be met.
  double radius_bound(const Vec3& u, Layer layer) const;

  /// radius(), if u is within the margin of the direction for which `near` was made.
  double radius(const Vec3& u, const Near& near, Layer layer) const;

  /// Does test(face, side) hold for some face that may be met in the direction of x? side is the orientation
  /// of its corners.
  template <class Test>
  bool any_hit(const Vec3& x, Test&& test) const {
    const Vec3 u = x.stableNormalized();
    for (const std::uint32_t f : index_.shortest(index_.grid().stencil(u))) {
      const Cap& cap = caps_[f];
      if (cap.axis.dot(u) >= cap.cosine && test(f, cap.side)) return true;
    }
    return false;
  }

  const TriangleMesh& mesh() const { return mesh_; }             // as given
  bool empty() const { return index_.empty(); }                  // no face covers a direction
  double margin() const { return margin_; }                      // radians
  const std::vector<JumpEdge>& jumps() const { return jumps_; }  // of the whole mesh

  /// All jump edges that come within `angle` radians of one of these directions, and perhaps others.
  std::vector<JumpEdge> jumps_near(std::span<const Vec3> directions, double angle) const;

  std::size_t bytes() const;  // of memory, the mesh not included

 private:
  struct Cap {
    Vec3 axis;
    double cosine;               // of the radius of a cap that holds the face; -1 if there is none
    int side;                    // orientation of its corners
    std::array<float, 3> plane;  // w of its plane w . x = 1, 1/mm
    float slack;                 // of w . u, 1/mm; infinite where the plane says nothing
  };
  /// Summary of the faces within reach of an entry of the grid. Floats, rounded outwards, keep the summaries
  /// of neighbours close in memory.
  struct Summary {
    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();
    bool rim = false;
  };
  void see(std::size_t f);

  const TriangleMesh& mesh_;
  double margin_;
  DirectionIndex index_;
  double reach_;  // of summaries, radians
  std::vector<Cap> caps_;
  std::vector<Summary> summaries_;
  std::vector<JumpEdge> jumps_;
};

}  // namespace impinge
