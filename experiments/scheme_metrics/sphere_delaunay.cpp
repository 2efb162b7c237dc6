// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheme_metrics/sphere_delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <CGAL/Delaunay_triangulation_on_sphere_2.h>
#include <CGAL/Projection_on_sphere_traits_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_on_sphere_face_base_2.h>
#include <CGAL/Triangulation_on_sphere_vertex_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <Eigen/Geometry>

#include "reference/kernel_point.hpp"

namespace impinge {
namespace {

// Area of a spherical triangle, negative if clockwise: tan(area / 2) = det / (1 + ab + bc + ca) (Van Oosterom
// and Strackee 1983). The determinant of differences keeps the digits of small triangles.
double signed_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double determinant = a.dot((b - a).cross(c - a));
  return 2.0 * std::atan2(determinant, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

// The corners are counter-clockwise, so the normal points to the centre on the outside.
EmptyCircle circle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 centre = (b - a).cross(c - a).normalized();
  return {centre, angle_between(centre, a)};
}

using Traits = CGAL::Projection_on_sphere_traits_3<Kernel>;
using VertexBase = CGAL::Triangulation_on_sphere_vertex_base_2<Traits>;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Traits, VertexBase>;
using FaceOfSphere = CGAL::Triangulation_on_sphere_face_base_2<Traits>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, FaceOfSphere>;
using Delaunay = CGAL::Delaunay_triangulation_on_sphere_2<Traits, Structure>;

// In the order of a space-filling curve, so that each insertion begins next to the last.
std::vector<std::size_t> insertion_order(const std::vector<Kernel::Point_3>& points) {
  using Map = CGAL::Pointer_property_map<Kernel::Point_3>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, Map>(CGAL::make_property_map(points)));
  return order;
}

void insert_all(Delaunay& triangulation, std::span<const Vec3> directions) {
  std::vector<Kernel::Point_3> points;
  points.reserve(directions.size());
  for (const Vec3& u : directions) points.emplace_back(u.x(), u.y(), u.z());
  const auto on_sphere = triangulation.geom_traits().construct_point_on_sphere_2_object();
  Delaunay::Face_handle near;
  for (const std::size_t i : insertion_order(points)) {
    const Delaunay::Vertex_handle vertex = triangulation.insert(on_sphere(points[i]), near);
    vertex->info() = i;
    near = vertex->face();
  }
  if (triangulation.number_of_vertices() != directions.size()) {
    throw std::invalid_argument("a direction is given twice: take distinct directions");
  }
}

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Indices of the entries in the order of their heights along an axis. The axis is oblique to every grid, so
// few have the same height.
std::vector<std::size_t> order_along(const std::vector<double>& height) {
  std::vector<std::size_t> order(height.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return height[a] != height[b] ? height[a] < height[b] : a < b;
  });
  return order;
}

}  // namespace

SphereDelaunay sphere_delaunay(std::span<const Vec3> entries) {
  SphereDelaunay delaunay;
  delaunay.distinct = distinct_directions(entries);
  const std::vector<Vec3>& u = delaunay.distinct.direction;
  delaunay.triangles = delaunay_triangles(u);
  delaunay.gaps.reserve(delaunay.triangles.size());
  for (const auto& [a, b, c] : delaunay.triangles) delaunay.gaps.push_back(circle(u[a], u[b], u[c]));
  return delaunay;
}

EmptyCircle widest_gap(const SphereDelaunay& delaunay, double z_max) {
  EmptyCircle widest;
  for (const EmptyCircle& gap : delaunay.gaps) {
    if (gap.radius > widest.radius && std::abs(gap.centre.z()) <= z_max) widest = gap;
  }
  return widest;
}

// Each triangle gives each of its corners the part nearest to it, between the corner, the middles of both
// sides and the centre. If the centre is outside, some parts are negative, which the neighbour makes up for.
std::vector<double> voronoi_areas(const SphereDelaunay& delaunay) {
  const std::vector<Vec3>& u = delaunay.distinct.direction;
  std::vector<double> areas(u.size(), 0.0);
  for (std::size_t i = 0; i < delaunay.triangles.size(); ++i) {
    const Vec3& centre = delaunay.gaps[i].centre;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = delaunay.triangles[i][k];
      const std::size_t b = delaunay.triangles[i][(k + 1) % 3];
      const Vec3 middle = (u[a] + u[b]).normalized();
      areas[a] += signed_area(u[a], middle, centre);
      areas[b] += signed_area(middle, u[b], centre);
    }
  }
  return areas;
}

std::vector<double> entry_areas(const SphereDelaunay& delaunay) {
  const std::vector<double> areas = voronoi_areas(delaunay);
  std::vector<double> shares;
  shares.reserve(delaunay.distinct.of_entry.size());
  for (const std::size_t place : delaunay.distinct.of_entry) {
    shares.push_back(areas[place] / static_cast<double>(delaunay.distinct.entries[place]));
  }
  return shares;
}

std::vector<SphereTriangle> delaunay_triangles(std::span<const Vec3> directions) {
  for (const Vec3& u : directions) {
    if (!u.allFinite() || u.isZero(0.0))
      throw std::invalid_argument("a direction is a finite vector that is not zero");
  }
  if (directions.size() < 4) throw std::invalid_argument("a triangulation needs at least four directions");
  Delaunay triangulation(Traits(CGAL::ORIGIN, 1.0));
  insert_all(triangulation, directions);
  std::vector<SphereTriangle> triangles;
  triangles.reserve(2 * directions.size());
  for (auto face = triangulation.solid_faces_begin(); face != triangulation.solid_faces_end(); ++face) {
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  // By Euler's formula a triangulation with another number of triangles leaves a part of the sphere open.
  if (triangulation.dimension() != 2 || triangles.size() != 2 * directions.size() - 4) {
    throw std::invalid_argument(
        "the directions all lie in one hemisphere: a triangulation needs some all round");
  }
  return triangles;
}

DistinctDirections distinct_directions(std::span<const Vec3> entries) {
  for (const Vec3& u : entries) {  // before the sort, which NaN would break
    if (!u.allFinite() || u.isZero(0.0))
      throw std::invalid_argument("a direction is a finite vector that is not zero");
  }
  const Vec3 axis = Vec3(0.5377, 0.6213, 0.5699).normalized();
  std::vector<double> height;
  height.reserve(entries.size());
  for (const Vec3& u : entries) height.push_back(axis.dot(u));
  const std::vector<std::size_t> order = order_along(height);

  std::vector<std::size_t> leader(entries.size(), kNone);  // an entry of the same direction
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = order[i];
    if (leader[a] != kNone) continue;
    for (std::size_t j = i; j < order.size() && height[order[j]] <= height[a] + kCoincident; ++j) {
      const std::size_t b = order[j];
      if (leader[b] == kNone && (entries[a] - entries[b]).norm() <= kCoincident) leader[b] = a;
    }
  }

  DistinctDirections distinct;
  distinct.of_entry.reserve(entries.size());
  std::vector<std::size_t> place(entries.size(), kNone);  // index of a leader's direction
  for (std::size_t entry = 0; entry < entries.size(); ++entry) {
    std::size_t& at = place[leader[entry]];
    if (at == kNone) {
      at = distinct.direction.size();
      distinct.direction.push_back(entries[entry]);
      distinct.entries.push_back(0);
    }
    distinct.of_entry.push_back(at);
    ++distinct.entries[at];
  }
  return distinct;
}

}  // namespace impinge
