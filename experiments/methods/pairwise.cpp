// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/pairwise.hpp"

#include <utility>
#include <vector>

#include <CGAL/intersections.h>

#include "methods/exact_triangles.hpp"

namespace impinge::lab {
namespace {

class Pairwise final : public TouchMethod {
 public:
  Pairwise(TriangleMesh ball, const TriangleMesh& socket)
      : ball_(std::move(ball)), socket_(exact_triangles(socket)) {}

  std::string_view name() const override { return "pairwise"; }
  bool gives_distance() const override { return false; }

  bool touches(const Pose& pose) override {
    for (const auto& moved : exact_triangles(ball_, pose)) {
      for (const auto& fixed : socket_) {
        if (CGAL::do_intersect(moved, fixed)) return true;
      }
    }
    return false;
  }

 private:
  TriangleMesh ball_;
  std::vector<ExactPredicates::Triangle_3> socket_;
};

}  // namespace

std::unique_ptr<TouchMethod> make_pairwise(const TriangleMesh& ball, const TriangleMesh& socket) {
  return std::make_unique<Pairwise>(ball, socket);
}

}  // namespace impinge::lab
