// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/cgal_tree.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include "methods/exact_triangles.hpp"

namespace impinge::lab {
namespace {

using Triangles = std::vector<ExactPredicates::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<ExactPredicates, Triangles::const_iterator>;
using BoxTree = CGAL::AABB_tree<CGAL::AABB_traits<ExactPredicates, Primitive>>;

class CgalTree final : public TouchMethod {
 public:
  CgalTree(TriangleMesh ball, const TriangleMesh& socket)
      : ball_(std::move(ball)),
        triangles_(exact_triangles(socket)),
        tree_(triangles_.cbegin(), triangles_.cend()) {
    tree_.build();
  }

  std::string_view name() const override { return "cgal_tree"; }
  bool gives_distance() const override { return false; }

  bool touches(const Pose& pose) override {
    const Triangles moved = exact_triangles(ball_, pose);
    return std::any_of(moved.begin(), moved.end(), [this](const auto& t) { return tree_.do_intersect(t); });
  }

 private:
  TriangleMesh ball_;
  Triangles triangles_;
  BoxTree tree_;
};

}  // namespace

std::unique_ptr<TouchMethod> make_cgal_tree(const TriangleMesh& ball, const TriangleMesh& socket) {
  return std::make_unique<CgalTree>(ball, socket);
}

}  // namespace impinge::lab
