// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/face_crossings.hpp"

#include <algorithm>
#include <numeric>

#include <CGAL/intersections.h>

#include "methods/exact_triangles.hpp"

namespace impinge::lab {
namespace {

// A face with its box.
struct Boxed {
  ExactPredicates::Triangle_3 triangle;
  CGAL::Bbox_3 box;
  std::size_t face;
};

bool share_vertex(const Face& a, const Face& b) {
  return std::ranges::any_of(a, [&b](VertexIndex v) { return std::ranges::find(b, v) != b.end(); });
}

std::vector<Boxed> boxed_faces(const TriangleMesh& mesh) {
  const auto point = [](const Vec3& v) { return ExactPredicates::Point_3(v.x(), v.y(), v.z()); };
  std::vector<Boxed> all;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const ExactPredicates::Triangle_3 triangle(point(corner(mesh, mesh.faces[f], 0)),
                                               point(corner(mesh, mesh.faces[f], 1)),
                                               point(corner(mesh, mesh.faces[f], 2)));
    if (!triangle.is_degenerate()) all.push_back({triangle, triangle.bbox(), f});
  }
  std::ranges::sort(all, {}, [](const Boxed& b) { return b.box.xmin(); });
  return all;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> face_crossings(const TriangleMesh& mesh) {
  const std::vector<Boxed> all = boxed_faces(mesh);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size() && all[j].box.xmin() <= all[i].box.xmax(); ++j) {
      if (!CGAL::do_overlap(all[i].box, all[j].box)) continue;
      if (share_vertex(mesh.faces[all[i].face], mesh.faces[all[j].face])) continue;
      if (CGAL::do_intersect(all[i].triangle, all[j].triangle))
        pairs.push_back(std::minmax(all[i].face, all[j].face));
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace impinge::lab
