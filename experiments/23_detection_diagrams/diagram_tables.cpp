// SPDX-License-Identifier: GPL-3.0-or-later
#include "23_detection_diagrams/diagram_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "hip/hip.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/star_shape.hpp"
#include "methods/chart.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

constexpr double kSteps = 1e4;  // steps per millimetre or degree to which drawings are rounded

double rounded(double value) { return std::round(kSteps * value) / kSteps; }

constexpr double kGrid = 1048576.0;  // 2^20 steps in a millimetre
constexpr double kSphereRadius = 22.0;

// Crossing of the edge from a corner at height `front` >= 0 to one at height `behind` < 0. Both faces of the
// edge get the same bits.
Vec3 edge_crossing(const Vec3& in_front, double front, const Vec3& at_back, double behind) {
  return in_front + front / (front - behind) * (at_back - in_front);
}

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

std::vector<NamedBody> bodies_by_shape(HipParameters shape, std::size_t faces) {
  std::vector<NamedBody> bodies;
  bodies.push_back({"sphere", sphere(kSphereRadius, faces)});
  bodies.push_back({"near_spherical", make_ball_socket_pair(faces).ball});
  bodies.push_back({"femur", make_hip(shape, faces).ball});
  shape.shaft_length = 0.0;
  bodies.push_back({"star_shape", make_hip(shape, faces).ball});
  return bodies;
}

Table body_table() {
  return {{{"name", "", "of the mesh"},
           {"triangles", "1", "of it"},
           {"smallest_mm", "mm", "distance of its nearest vertex from the centre"},
           {"largest_mm", "mm", "that of its farthest one"},
           {"star_shaped", "", "no ray from the centre meets it twice: proven with exact signs"},
           {"violating", "1", "share of all directions that meet it more than once"}},
          {}};
}

void add_body(std::string_view name, const TriangleMesh& mesh, Table& bodies) {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const Vec3& x : mesh.vertices) {
    smallest = std::min(smallest, x.norm());
    largest = std::max(largest, x.norm());
  }
  const StarShapeReport report = star_shape(mesh);
  bodies.add_row({name, mesh.faces.size(), smallest, largest, report.star_shaped, report.violating});
}

TriangleMesh over_an_edge(TriangleMesh mesh) {
  for (Vec3& x : mesh.vertices) x = (kGrid * x).array().round() / kGrid;
  const TriangleMesh held = faces_along(mesh, Vec3::UnitZ());
  if (held.faces.empty()) throw std::invalid_argument("the z axis meets no face of the mesh");
  Vec3 shift = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3 middle = 0.5 * (corner(held, held.faces[0], k) + corner(held, held.faces[0], (k + 1) % 3));
    middle.z() = 0.0;
    if (middle.norm() < shift.norm()) shift = middle;
  }
  return relative_to(std::move(mesh), shift);
}

std::vector<Segment> plane_section(const TriangleMesh& mesh, const Vec3& normal) {
  std::vector<Segment> section;
  for (const Face& face : mesh.faces) {
    std::array<double, 3> height{};
    for (std::size_t k = 0; k < 3; ++k) height[k] = normal.dot(corner(mesh, face, k));
    const auto front = [&](std::size_t k) { return height[k % 3] >= 0.0; };
    for (std::size_t k = 0; k < 3; ++k) {
      const bool alone = front(k) != front(k + 1) && front(k) != front(k + 2);
      if (!alone) continue;
      Segment segment;
      for (std::size_t j = 0; j < 2; ++j) {
        const std::size_t other = (k + 1 + j) % 3;
        const std::size_t a = front(k) ? k : other;
        const std::size_t b = front(k) ? other : k;
        segment[j] = edge_crossing(corner(mesh, face, a), height[a], corner(mesh, face, b), height[b]);
      }
      section.push_back(segment);
    }
  }
  return section;
}

}  // namespace impinge::lab
