// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mesh/triangle_distance.hpp"
#include "methods/cgal.hpp"

namespace impinge::lab {
namespace {

constexpr double kMargin = 1e-6;  // mm, far above the rounding of a distance

// A triangle and a sphere about its centroid that holds it.
struct Held {
  Triangle corners;
  Vec3 middle;
  double reach = 0.0;  // mm
};

std::vector<Held> held_triangles(const TriangleMesh& mesh, const Pose& pose) {
  std::vector<Held> all;
  all.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    Held held;
    for (std::size_t k = 0; k < 3; ++k) held.corners[k] = to_socket(pose, corner(mesh, face, k));
    held.middle = (held.corners[0] + held.corners[1] + held.corners[2]) / 3.0;
    for (const Vec3& x : held.corners) held.reach = std::max(held.reach, (x - held.middle).norm());
    all.push_back(held);
  }
  return all;
}

std::vector<double> distances(const PointQuery& closest, const std::vector<Vec3>& points) {
  std::vector<double> out(points.size());
  closest.answer(points, out);
  return out;
}

}  // namespace

double surface_distance(const BenchmarkScene& scene) {
  if (make_cgal_tree(scene.pair.ball, scene.pair.socket)(scene.pose)) return 0.0;
  const auto closest = make_cgal_closest(scene.pair.socket);
  const auto socket = held_triangles(scene.pair.socket, {});
  const auto ball = held_triangles(scene.pair.ball, scene.pose);
  double least = std::ranges::min(distances(closest, scene.queries()));
  std::vector<Vec3> middles;
  middles.reserve(ball.size());
  for (const Held& held : ball) middles.push_back(held.middle);
  const std::vector<double> from_middle = distances(closest, middles);
  for (std::size_t i = 0; i < ball.size(); ++i) {
    if (from_middle[i] - ball[i].reach > least + kMargin) continue;
    for (const Held& other : socket) {
      const double apart = (ball[i].middle - other.middle).norm() - ball[i].reach - other.reach;
      if (apart > least + kMargin) continue;
      least = std::min(least, std::sqrt(squared_distance_of_triangles(ball[i].corners, other.corners)));
    }
  }
  return least;
}

}  // namespace impinge::lab
