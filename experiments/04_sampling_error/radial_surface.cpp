// SPDX-License-Identifier: GPL-3.0-or-later
#include "04_sampling_error/radial_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/bodies.hpp"

namespace impinge::lab {
namespace {

// tan psi of the plane with normal n (any length) along u.
double plane_slope(const Vec3& n, const Vec3& u) { return n.cross(u).norm() / n.dot(u); }

}  // namespace

RadialSurface spherical_surface(std::string name, double radius, const Vec3& centre) {
  if (!(centre.norm() < radius)) {
    throw std::invalid_argument("a spherical surface holds the centre of rotation: |centre| < radius");
  }
  RadialSurface surface;
  surface.name = std::move(name);
  surface.radius = [radius, centre](const Vec3& u) { return eccentric_sphere_radius(u, radius, centre); };
  surface.slope = [radius, centre](const Vec3& u) {
    const double sine = centre.cross(u).norm() / radius;
    return sine / std::sqrt((1.0 - sine) * (1.0 + sine));
  };
  return surface;
}

RadialSurface conchoid_surface(std::string name, const ConchoidShape& shape, const Vec3& axis) {
  if (!(shape.b >= 0.0 && shape.a > shape.b)) {
    throw std::invalid_argument(
        "a conchoid a + b cos(phi) has one radius a direction for 0 <= b < a, not otherwise");
  }
  RadialSurface surface;
  surface.name = std::move(name);
  surface.radius = [shape, axis](const Vec3& u) { return shape.a + shape.b * axis.dot(u); };
  surface.slope = [shape, axis](const Vec3& u) {
    return shape.b * axis.cross(u).norm() / (shape.a + shape.b * axis.dot(u));
  };
  surface.axis = axis;
  surface.opening = 0.5 * kPi;
  return surface;
}

RadialSurface planar_surface(std::string name, const Vec3& normal, double distance, double steepest_deg) {
  if (!(distance > 0.0 && steepest_deg > 0.0 && steepest_deg < 90.0)) {
    throw std::invalid_argument("a plane has a positive distance and is seen at less than 90 degrees");
  }
  RadialSurface surface;
  surface.name = std::move(name);
  surface.radius = [normal, distance](const Vec3& u) { return distance / normal.dot(u); };
  surface.slope = [normal](const Vec3& u) { return plane_slope(normal, u); };
  surface.axis = normal;
  surface.opening = steepest_deg * kDegree;
  return surface;
}

EdgeSurface edge_surface(std::string name, const EdgeShape& shape) {
  const double half = 0.5 * shape.dihedral_deg;
  if (!(half > 0.0 && std::abs(shape.tilt_deg) + half + shape.opening_deg < 90.0 &&
        std::abs(shape.axis.dot(shape.edge)) < 1e-9)) {
    throw std::invalid_argument(
        "an edge lies across its axis, is convex, and both planes are seen at less than 90 degrees");
  }
  const auto inverse = [&shape](double angle_deg) -> Vec3 {
    const Vec3 n = Eigen::AngleAxisd(angle_deg * kDegree, shape.edge) * shape.axis;
    return n / (shape.radius * n.dot(shape.axis));
  };
  EdgeSurface result;
  result.inverse_1 = inverse(shape.tilt_deg + half);
  result.inverse_2 = inverse(shape.tilt_deg - half);
  const auto nearer = [q1 = result.inverse_1, q2 = result.inverse_2](const Vec3& u) -> Vec3 {
    return q1.dot(u) > q2.dot(u) ? q1 : q2;
  };
  result.surface.name = std::move(name);
  result.surface.radius = [nearer](const Vec3& u) { return 1.0 / nearer(u).dot(u); };
  result.surface.slope = [nearer](const Vec3& u) { return plane_slope(nearer(u), u); };
  result.surface.axis = shape.axis;
  result.surface.opening = shape.opening_deg * kDegree;
  return result;
}

std::vector<Vec3> directions_along(const EdgeShape& shape, double half_width, std::size_t count) {
  const Vec3 across = shape.axis.cross(shape.edge);
  const double reach = std::max(0.0, shape.opening_deg * kDegree - half_width);
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  std::vector<Vec3> directions(count);
  for (std::size_t k = 0; k < count; ++k) {
    // Evenly along the edge, and across it by the golden ratio, which fills the strip at any count.
    const double turn = golden * static_cast<double>(k);
    const double along = reach * (2.0 * (static_cast<double>(k) + 0.5) / static_cast<double>(count) - 1.0);
    const double aside = half_width * (2.0 * (turn - std::floor(turn)) - 1.0);
    directions[k] = (std::cos(aside) * (std::cos(along) * shape.axis + std::sin(along) * shape.edge) +
                     std::sin(aside) * across)
                        .normalized();
  }
  return directions;
}

}  // namespace impinge::lab
