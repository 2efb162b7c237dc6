// SPDX-License-Identifier: GPL-3.0-or-later
#include "23_detection_diagrams/diagram_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "hip/hip.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/star_shape.hpp"
#include "methods/chart_coverage.hpp"

namespace impinge::lab {
namespace {

constexpr double kGrid = 1048576.0;  // 2^20 steps in a millimetre
constexpr double kSphereRadius = 22.0;

}  // namespace

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

}  // namespace impinge::lab
