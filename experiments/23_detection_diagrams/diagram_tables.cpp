// SPDX-License-Identifier: GPL-3.0-or-later
#include "23_detection_diagrams/diagram_tables.hpp"

#include <cmath>

#include "23_detection_diagrams/plane_section.hpp"
#include "methods/chart.hpp"
#include "methods/chart_coverage.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

constexpr double kSteps = 1e4;  // of a millimetre or a degree, to which what is drawn is rounded

double rounded(double value) { return std::round(kSteps * value) / kSteps; }

}  // namespace

Table corner_table() {
  return {{{"name", "", "of the mesh"},
           {"face", "1", "of the mesh"},
           {"corner", "1", "0 to 2, counter-clockwise seen from outside"},
           {"x", "mm", "centre frame"},
           {"y", "mm", "the same"},
           {"z", "mm", "the same; the poles of the table are on this axis"},
           {"phi_deg", "deg", "polar angle of the corner"},
           {"theta_deg", "deg", "its azimuth, in [0, 360)"},
           {"radius_mm", "mm", "its distance from the centre"}},
          {}};
}

void add_corners(std::string_view name, const TriangleMesh& mesh, Table& corners) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& x = corner(mesh, mesh.faces[f], k);
      const Angles at = to_angles(x);
      corners.add_row({name, f, k, rounded(x.x()), rounded(x.y()), rounded(x.z()), rounded(at.phi / kDegree),
                       rounded(at.theta / kDegree), rounded(x.norm())});
    }
  }
}

Table chart_table() {
  return {{{"name", "", "of the mesh"},
           {"face", "1", "of the mesh"},
           {"part", "1", "of the face: more than one where it holds a pole"},
           {"corner", "1", "0 to 2"},
           {"phi_deg", "deg", "on the chart"},
           {"theta_deg", "deg", "the same; beyond [0, 360) where a face crosses the seam"},
           {"radius_mm", "mm", "drawn there"}},
          {}};
}

void add_chart(std::string_view name, const TriangleMesh& mesh, Table& chart) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const TriangleCone cone = cone_of(mesh, mesh.faces[f]);
    if (cone.edge_on()) continue;
    const std::vector<ChartTriangle> parts = chart_triangles(cone);
    for (std::size_t part = 0; part < parts.size(); ++part) {
      for (std::size_t k = 0; k < 3; ++k) {
        const ChartPoint& at = parts[part][k];
        chart.add_row(
            {name, f, part, k, rounded(at.phi / kDegree), rounded(at.theta / kDegree), rounded(at.radius)});
      }
    }
  }
}

Table coverage_table() {
  return {{{"name", "", "of the mesh"},
           {"precision_deg", "deg", "of the RSID table"},
           {"row", "1", "of the table, phi = row times precision"},
           {"column", "1", "the same, theta"},
           {"met", "", "the ray along the entry meets the faces: exact"},
           {"drawn", "", "the thesis' raster fills it, poles heeded"},
           {"direct", "", "it lies between the corners as mapped directly"},
           {"met_mm", "mm", "exact radius"},
           {"drawn_mm", "mm", "radius by the thesis' raster"}},
          {}};
}

void add_coverage(std::string_view name, const TriangleMesh& mesh, const Rsid& scheme, Table& coverage) {
  for (const EntryCoverage& e : chart_coverage(mesh, scheme)) {
    coverage.add_row({name, scheme.precision_deg(), e.entry / scheme.columns(), e.entry % scheme.columns(),
                      e.met, e.drawn, e.direct, e.met_radius, e.drawn_radius});
  }
}

Table section_table() {
  return {{{"name", "", "of the mesh"},
           {"x0", "mm", "one end of a segment in the plane y = 0, centre frame"},
           {"z0", "mm", "the same"},
           {"x1", "mm", "the other end"},
           {"z1", "mm", "the same"}},
          {}};
}

void add_section(std::string_view name, const TriangleMesh& mesh, Table& section) {
  for (const auto& [a, b] : plane_section(mesh, Vec3::UnitY())) {
    section.add_row({name, rounded(a.x()), rounded(a.z()), rounded(b.x()), rounded(b.z())});
  }
}

Table ray_table() {
  return {{{"name", "", "of the mesh"},
           {"phi_deg", "deg", "polar angle of the ray"},
           {"theta_deg", "deg", "its azimuth, 0 (towards +x) or 180"},
           {"nearest_mm", "mm", "first crossing of the surface; empty for none"},
           {"farthest_mm", "mm", "last crossing"}},
          {}};
}

void add_rays(std::string_view name, const TriangleMesh& mesh, double step_deg, Table& rays) {
  const RayCaster caster(mesh);
  const int steps = static_cast<int>(std::round(180.0 / step_deg));
  for (int k = -steps + 1; k <= steps; ++k) {
    const double phi = std::abs(k) * step_deg;
    const Vec3 up = to_direction({phi * kDegree, 0.0});
    const Vec3 u(k < 0 ? -up.x() : up.x(), 0.0, up.z());
    rays.add_row(
        {name, phi, k < 0 ? 180.0 : 0.0, caster.cast(u, Layer::nearest), caster.cast(u, Layer::farthest)});
  }
}

}  // namespace impinge::lab
