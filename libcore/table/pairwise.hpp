// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Filling a table by testing every ray against every triangle: the thesis' O(m n) baseline (Section 3.2,
/// Table 3) and the oracle of every other way of filling.
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
  /// Prepares each face. std::invalid_argument for lengths beyond those of mesh/lengths.hpp.
  explicit RayCaster(const TriangleMesh& mesh);

  /// Radius along unit u (mm), kNoSurface if no face is met. Boundaries of faces belong to them and signs are
  /// exact, so no ray slips through an edge. r = det(a, b, c) / (det(u, b, c) + det(a, u, c) + det(a, b, u))
  /// by Cramer's rule, a formula that shares nothing with the rasterisers but the edge planes, and
  /// the plane of a thin face (sphere/face_plane.hpp). The determinants of a small face cancel: of a face w
  /// radians wide seen at a right angle up to about 2^-53 / w^2 of the radius are lost.
  /// reference/exact_radius.hpp has every digit.
  double cast(const Vec3& u, Layer layer) const;

 private:
  double radius_of(std::size_t face, const Vec3& u) const;

  std::vector<TriangleCone> cones_;
  std::vector<double> determinant_;  // |det(a, b, c)| of each face
  /// Ten rows of one number a face: three edge planes (x, y, z each) and the doubt about their signs.
  std::array<std::vector<double>, 10> planes_;
};

/// mesh in the centre frame.
template <SamplingScheme S>
RadialTable<S> fill_pairwise(const TriangleMesh& mesh, const S& scheme, Layer layer) {
  const RayCaster caster(mesh);
  RadialTable<S> table(scheme);
  for (std::size_t i = 0; i < scheme.size(); ++i) table.radii()[i] = caster.cast(scheme.direction(i), layer);
  mask_rim(mesh, layer, table);
  return table;
}

}  // namespace impinge
