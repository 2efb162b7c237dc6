// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Fills a table by testing every ray against every triangle: the thesis' O(m n) baseline (Section 3.2, Table
/// 3), and the oracle that every other way of filling is checked against.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "table/layer.hpp"
#include "table/rim.hpp"

namespace impinge {

/// All faces of a mesh in the centre frame, ready for rays from the centre.
class RayCaster {
 public:
  /// Prepares each face. Throws std::invalid_argument for lengths outside of the range of mesh/lengths.hpp.
  explicit RayCaster(const TriangleMesh& mesh);

  /// Radius along unit u (mm), kNoSurface if no face is met. Faces include their boundaries and signs are
  /// exact, so that no ray slips through an edge. By Cramer's rule r = det(a, b, c) / (det(u, b, c) + det(a,
  /// u, c) + det(a, b, u)), a formula that shares only the edge planes, and the plane of a thin face
  /// (sphere/face_plane.hpp), with the rasterisers. The determinants of a small face cancel: for a face w
  /// radians wide, seen at a right angle, the relative error is up to about 2^-53 / w^2.
  /// reference/exact_radius.hpp has every digit.
  double cast(const Vec3& u, Layer layer) const;

 private:
  double radius_of(std::size_t face, const Vec3& u) const;

  std::vector<TriangleCone> cones_;
  std::vector<double> determinant_;  // |det(a, b, c)| of each face
  /// Ten numbers for each face, row by row: three edge planes (x, y, z each) and the doubt about their signs.
  std::array<std::vector<double>, 10> planes_;
};

/// The table of `mesh`, which is in the centre frame. Throws as RayCaster does.
template <SamplingScheme S>
RadialTable<S> fill_pairwise(const TriangleMesh& mesh, const S& scheme, Layer layer) {
  const RayCaster caster(mesh);
  RadialTable<S> table(scheme);
  for (std::size_t i = 0; i < scheme.size(); ++i) table.radii()[i] = caster.cast(scheme.direction(i), layer);
  mask_rim(mesh, layer, table);
  return table;
}

}  // namespace impinge
