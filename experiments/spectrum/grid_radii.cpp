// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/grid_radii.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/angular_box.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {
namespace {

// Tries every direction of the grid in the box.
template <class Visit>
void for_each_in_box(const GaussGrid& grid, const AngularBox& box, const Visit& visit) {
  const auto columns = static_cast<long>(grid.columns());
  const double turn = 2.0 * kPi / static_cast<double>(columns);
  const auto left = static_cast<long>(std::floor(box.theta_min / turn));
  const auto right =
      std::min(static_cast<long>(std::ceil((box.theta_min + box.theta_width) / turn)), left + columns - 1);
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    if (grid.phi(row) < box.phi_min || grid.phi(row) > box.phi_max) continue;
    for (long j = left; j <= right; ++j)
      visit(row, static_cast<std::size_t>((j % columns + columns) % columns));
  }
}

}  // namespace

std::vector<double> grid_radii(const GaussGrid& grid, const TriangleMesh& mesh, Layer layer) {
  std::vector<double> radii(grid.size(), kNoSurface);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    for_each_in_box(grid, angular_box(cone.corners(), 1e-9), [&](std::size_t row, std::size_t column) {
      const Vec3 u = grid.direction(row, column);
      if (cone.contains(u)) keep(radii[row * grid.columns() + column], cone.radius(u), layer);
    });
  }
  return radii;
}

}  // namespace impinge
