// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/chart_coverage.hpp"

#include <array>
#include <cmath>

#include "methods/thesis_raster.hpp"

namespace impinge::lab {
namespace {

// Twice the signed area of the flat triangle (a, b, p) on the chart.
double flat_area(Angles a, Angles b, Angles p) {
  return (b.theta - a.theta) * (p.phi - a.phi) - (b.phi - a.phi) * (p.theta - a.theta);
}

bool in_direct_map(const TriangleCone& cone, Angles p) {
  std::array<double, 3> area{};
  for (std::size_t k = 0; k < 3; ++k) {
    area[k] = flat_area(to_angles(cone.corners()[k]), to_angles(cone.corners()[(k + 1) % 3]), p);
  }
  return (area[0] >= 0.0 && area[1] >= 0.0 && area[2] >= 0.0) ||
         (area[0] <= 0.0 && area[1] <= 0.0 && area[2] <= 0.0);
}

}  // namespace

std::vector<EntryCoverage> chart_coverage(const TriangleMesh& mesh, const Rsid& scheme) {
  const RadialTable<Rsid> drawn = fill_thesis(mesh, scheme, Layer::nearest);
  std::vector<EntryCoverage> covered;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    EntryCoverage entry{.entry = i, .met_radius = kNoSurface, .drawn_radius = drawn.radii()[i]};
    entry.drawn = !std::isnan(entry.drawn_radius);
    const Vec3 u = scheme.direction(i);
    // By place in the table: on a pole row each column has its own azimuth, though the direction has none.
    const std::size_t row = i / scheme.columns();
    const std::size_t column = i % scheme.columns();
    const Angles place{static_cast<double>(row) * scheme.spacing(),
                       static_cast<double>(column) * scheme.spacing()};
    for (const Face& face : mesh.faces) {
      const TriangleCone cone = cone_of(mesh, face);
      if (cone.contains(u)) entry.met = true, entry.met_radius = cone.radius(u);
      if (in_direct_map(cone, place)) entry.direct = true;
    }
    if (entry.met || entry.drawn || entry.direct) covered.push_back(entry);
  }
  return covered;
}

TriangleMesh faces_along(const TriangleMesh& mesh, const Vec3& direction) {
  TriangleMesh found{mesh.vertices, {}};
  for (const Face& face : mesh.faces) {
    if (cone_of(mesh, face).contains(direction)) found.faces.push_back(face);
  }
  return found;
}

}  // namespace impinge::lab
