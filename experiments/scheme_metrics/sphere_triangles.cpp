// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheme_metrics/sphere_triangles.hpp"

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

#include "reference/kernel_point.hpp"

namespace impinge {
namespace {

using Traits = CGAL::Projection_on_sphere_traits_3<Kernel>;
using VertexBase = CGAL::Triangulation_on_sphere_vertex_base_2<Traits>;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Traits, VertexBase>;
using FaceOfSphere = CGAL::Triangulation_on_sphere_face_base_2<Traits>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, FaceOfSphere>;
using Delaunay = CGAL::Delaunay_triangulation_on_sphere_2<Traits, Structure>;

// Along a space-filling curve, so that each insertion begins next to the last.
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

}  // namespace

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
  // Euler: a triangulation without this many triangles leaves a part of the sphere open.
  if (triangulation.dimension() != 2 || triangles.size() != 2 * directions.size() - 4) {
    throw std::invalid_argument(
        "the directions all lie in one hemisphere: a triangulation needs some all round");
  }
  return triangles;
}

}  // namespace impinge
