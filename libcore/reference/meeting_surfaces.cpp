// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meeting_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <CGAL/Bbox_3.h>
#include <CGAL/intersections.h>

#include "reference/kernel_point.hpp"

namespace impinge {
namespace {

using Facet = std::pair<Kernel::Triangle_3, CGAL::Bbox_3>;

std::vector<Facet> facets(const TriangleMesh& mesh) {
  std::vector<Facet> found;
  for (const Face& f : mesh.faces) {
    const Kernel::Triangle_3 facet(kernel_point(corner(mesh, f, 0)), kernel_point(corner(mesh, f, 1)),
                                   kernel_point(corner(mesh, f, 2)));
    if (!facet.is_degenerate()) found.emplace_back(facet, facet.bbox());
  }
  return found;
}

bool meets_segment(const TriangleMesh& mesh, const Vec3& from, const Vec3& to) {
  const Kernel::Segment_3 segment(kernel_point(from), kernel_point(to));
  return std::ranges::any_of(facets(mesh),
                             [&](const Facet& one) { return CGAL::do_intersect(segment, one.first); });
}

// A power of two that brings the largest coordinate of v beyond the reach.
double stretch(const Vec3& v, double reach) {
  return std::exp2(1.0 + std::max(0.0, std::ceil(std::log2(reach / v.cwiseAbs().maxCoeff()))));
}

}  // namespace

bool surfaces_meet(const TriangleMesh& a, const TriangleMesh& b) {
  const std::vector<Facet> all = facets(b);
  return std::ranges::any_of(facets(a), [&](const Facet& one) {
    return std::ranges::any_of(all, [&](const Facet& other) {
      return CGAL::do_overlap(one.second, other.second) && CGAL::do_intersect(one.first, other.first);
    });
  });
}

bool beyond_surface(const TriangleMesh& mesh, const Vec3& x) { return meets_segment(mesh, Vec3::Zero(), x); }

bool within_surface(const TriangleMesh& mesh, const Vec3& x, double reach) {
  return meets_segment(mesh, x, stretch(x, reach) * x);
}

TriangleMesh rim_wall(const TriangleMesh& mesh, double reach) {
  std::map<std::pair<VertexIndex, VertexIndex>, int> faces;  // of each edge
  for (const Face& f : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++faces[std::minmax(f[k], f[(k + 1) % 3])];
  }
  TriangleMesh wall;
  for (const auto& [edge, count] : faces) {
    if (count != 1) continue;
    const Vec3& a = mesh.vertices[edge.first];
    const Vec3& b = mesh.vertices[edge.second];
    const double far = std::max(stretch(a, 2.0 * reach), stretch(b, 2.0 * reach));
    const auto first = static_cast<VertexIndex>(wall.vertices.size());
    wall.vertices.insert(wall.vertices.end(), {a, b, far * b, far * a});
    wall.faces.push_back({first, first + 1, first + 2});
    wall.faces.push_back({first, first + 2, first + 3});
  }
  return wall;
}

}  // namespace impinge
