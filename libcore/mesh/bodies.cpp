// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/rings.hpp"

namespace impinge {
namespace {

void require_positive(double length, const char* what) {
  if (!(length > 0.0 && std::isfinite(length))) {
    throw std::invalid_argument(std::string(what) + " is a positive length in mm, not " +
                                std::to_string(length));
  }
}

void require_cone(const ConeShape& shape) {
  require_positive(shape.base_radius, "the base radius of a cone");
  require_positive(shape.apex_height, "the apex height of a cone");
  require_positive(shape.base_depth, "the base depth of a cone");
  if (shape.sides < 3) {
    throw std::invalid_argument("a cone needs 3 sides or more, not " + std::to_string(shape.sides));
  }
}

}  // namespace

TriangleMesh sphere(double radius, std::size_t faces, const Vec3& centre) {
  require_positive(radius, "the radius of a sphere");
  TriangleMesh mesh = unit_sphere(faces);
  for (Vec3& v : mesh.vertices) v = centre + radius * v;
  return mesh;
}

double eccentric_sphere_radius(const Vec3& direction, double radius, const Vec3& centre) {
  const double along = centre.dot(direction);
  return along + std::sqrt(radius * radius - centre.squaredNorm() + along * along);
}

TriangleMesh radial_body(std::size_t faces, const std::function<double(const Vec3&)>& radius) {
  TriangleMesh mesh = unit_sphere(faces);
  for (Vec3& v : mesh.vertices) v *= radius(v);
  return mesh;
}

TriangleMesh octahedron(double radius) {
  require_positive(radius, "the radius of an octahedron");
  const double r = radius;
  return {{{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

double octahedron_mesh_radius(const Vec3& direction, double radius) { return radius / direction.lpNorm<1>(); }

TriangleMesh cone(const ConeShape& shape) {
  require_cone(shape);
  TriangleMesh mesh;
  mesh.vertices = {{0.0, 0.0, shape.apex_height}, {0.0, 0.0, -shape.base_depth}};
  const auto base_corner = [&shape](std::size_t k) { return static_cast<VertexIndex>(2 + k % shape.sides); };
  for (std::size_t k = 0; k < shape.sides; ++k) {
    const CosSin c = half_turn_fraction(static_cast<long>(2 * k), static_cast<long>(shape.sides));
    mesh.vertices.emplace_back(shape.base_radius * c.cos, shape.base_radius * c.sin, -shape.base_depth);
    mesh.faces.push_back({0, base_corner(k), base_corner(k + 1)});
    mesh.faces.push_back({1, base_corner(k + 1), base_corner(k)});
  }
  return mesh;
}

double cone_mesh_radius(const Vec3& direction, const ConeShape& shape) {
  require_cone(shape);
  // Side plane k in the half-plane of azimuth pi (2 k + 1) / n: through (0, h) and (a, -d) of (rho, z).
  const double a = shape.base_radius * std::cos(kPi / static_cast<double>(shape.sides));
  const double slope = shape.apex_height + shape.base_depth;
  double nearest = std::numeric_limits<double>::infinity();
  const auto meet = [&nearest](double offset, double along) {
    if (along > 0.0) nearest = std::min(nearest, offset / along);
  };
  meet(shape.base_depth, -direction.z());
  for (std::size_t k = 0; k < shape.sides; ++k) {
    const CosSin c = half_turn_fraction(static_cast<long>(2 * k + 1), static_cast<long>(shape.sides));
    const double outward = c.cos * direction.x() + c.sin * direction.y();
    meet(a * shape.apex_height, slope * outward + a * direction.z());
  }
  return nearest;
}

TriangleMesh cup(double inner_radius, double half_opening_deg, std::size_t faces) {
  require_positive(inner_radius, "the inner radius of a cup");
  TriangleMesh mesh = unit_cap(faces, half_opening_deg * kDegree);
  for (Vec3& v : mesh.vertices) v *= inner_radius;
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

}  // namespace impinge
