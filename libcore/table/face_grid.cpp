// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/face_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh/lengths.hpp"
#include "mesh/star_shape.hpp"

namespace impinge {
namespace {

constexpr double kFinest = 0.5;  // degrees

}  // namespace

CubeGnomonic face_grid(const TriangleMesh& mesh, double coarsest_deg) {
  require_lengths(mesh);
  double total = 0.0;
  for (const Face& face : mesh.faces)
    total += std::abs(solid_angle(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
  const double mean = total / static_cast<double>(std::max<std::size_t>(mesh.faces.size(), 1));
  const double size_deg = std::clamp(std::sqrt(mean) / kDegree, kFinest, coarsest_deg);
  return CubeGnomonic::with_precision(90.0 / std::round(90.0 / size_deg));
}

}  // namespace impinge
