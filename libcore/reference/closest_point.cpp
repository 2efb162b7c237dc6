// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/closest_point.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include "reference/exact_input.hpp"
#include "reference/exact_ratio.hpp"
#include "reference/kernel_point.hpp"

namespace impinge {
namespace {

using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using BoxTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Corners = std::array<ExactVector, 3>;

constexpr std::size_t kPointBatch = 1024;  // points between two calls of the progress
constexpr double kEnlarged = 1 + 1e-12;    // so that the faces at the least distance are inside the ball

void keep_least(ExactRatio& least, const ExactRatio& other) {
  if (other < least) least = other;
}

// Takes the distance from the edge between two corners, if the foot of x lies between them.
void keep_edge(const ExactVector& from, const ExactVector& to, const ExactVector& x, ExactRatio& least) {
  const ExactVector e = to - from;
  const ExactNumber along = e * (x - from);
  const ExactNumber length = e * e;
  if (along.sign() != CGAL::POSITIVE || !(along < length)) return;
  keep_least(least, {CGAL::cross_product(e, x - from).squared_length(), length});
}

// Takes the distance from the plane of the face, if the foot of x lies in the face.
void keep_plane(const Corners& c, const ExactVector& x, ExactRatio& least) {
  const ExactVector n = CGAL::cross_product(c[1] - c[0], c[2] - c[0]);
  const ExactNumber area = n * n;
  if (area.is_zero()) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const ExactVector inward = CGAL::cross_product(n, c[(k + 1) % 3] - c[k]);
    if ((inward * (x - c[k])).sign() == CGAL::NEGATIVE) return;
  }
  const ExactNumber height = n * (x - c[0]);
  keep_least(least, {height * height, area});
}

class ClosestPoint {
 public:
  explicit ClosestPoint(const TriangleMesh& mesh) : mesh_(mesh) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Face& face = mesh.faces[f];
      const Kernel::Triangle_3 triangle(kernel_point(corner(mesh, face, 0)),
                                        kernel_point(corner(mesh, face, 1)),
                                        kernel_point(corner(mesh, face, 2)));
      // CGAL's predicates do not take faces without area; these few are tried one by one.
      (triangle.is_degenerate() ? degenerate_ : proper_).push_back(f);
      if (!triangle.is_degenerate()) triangles_.push_back(triangle);
    }
    tree_.rebuild(triangles_.cbegin(), triangles_.cend());
    if (!triangles_.empty()) tree_.accelerate_distance_queries();
  }

  double distance(const Vec3& x) const {
    const ExactVector at = exact(x);
    std::optional<ExactRatio> least;
    const auto look_at = [&](std::size_t f) {
      if (!least) least = ExactRatio{(at - exact(corner(mesh_, mesh_.faces[f], 0))).squared_length(), 1};
      keep_face(f, at, *least);
    };
    for (const std::size_t f : degenerate_) look_at(f);
    if (!triangles_.empty()) {
      // The tree finds a face that is nearest up to rounding. Every nearer face meets the ball about x that
      // reaches this one.
      look_at(face_of(tree_.closest_point_and_primitive(kernel_point(x)).second));
      const double reach = nearest_root(*least) * kEnlarged;
      if (reach == 0.0) return 0.0;
      std::vector<Triangles::const_iterator> near;
      tree_.all_intersected_primitives(Kernel::Sphere_3(kernel_point(x), reach * reach),
                                       std::back_inserter(near));
      for (const auto& triangle : near) look_at(face_of(triangle));
    }
    return nearest_root(*least);
  }

 private:
  std::size_t face_of(Triangles::const_iterator triangle) const {
    return proper_[static_cast<std::size_t>(triangle - triangles_.cbegin())];
  }

  void keep_face(std::size_t f, const ExactVector& x, ExactRatio& least) const {
    const Face& face = mesh_.faces[f];
    const Corners c{exact(corner(mesh_, face, 0)), exact(corner(mesh_, face, 1)),
                    exact(corner(mesh_, face, 2))};
    for (std::size_t k = 0; k < 3; ++k) {
      keep_least(least, {(x - c[k]).squared_length(), 1});
      keep_edge(c[k], c[(k + 1) % 3], x, least);
    }
    keep_plane(c, x, least);
  }

  const TriangleMesh& mesh_;
  std::vector<std::size_t> proper_;      // faces with area, in the order of triangles_
  std::vector<std::size_t> degenerate_;  // faces without area
  Triangles triangles_;
  BoxTree tree_;
};

}  // namespace

std::vector<double> closest_distances(const TriangleMesh& mesh, const DistanceQuery& query) {
  require_exact_input(mesh);
  require_finite(query.points, "point");
  const ClosestPoint closest(mesh);
  std::vector<double> distances;
  distances.reserve(query.points.size());
  for (const Vec3& x : query.points) {
    distances.push_back(closest.distance(x));
    const std::size_t done = distances.size();
    if (query.progress && (done % kPointBatch == 0 || done == query.points.size())) query.progress(done);
  }
  return distances;
}

}  // namespace impinge
