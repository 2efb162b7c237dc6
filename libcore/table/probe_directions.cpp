// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/probe_directions.hpp"

#include <cmath>

#include "mesh/edges.hpp"

namespace impinge {

std::vector<Vec3> polar_directions(double within, std::size_t count) {
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  std::vector<Vec3> directions(count);
  for (std::size_t k = 0; k < count; ++k) {
    // For equal areas sin(phi / 2)^2 grows evenly.
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    const double phi = 2.0 * std::asin(std::sin(0.5 * within) * std::sqrt(share));
    const double theta = golden * static_cast<double>(k);
    const double side = k % 2 == 0 ? 1.0 : -1.0;
    directions[k] =
        Vec3(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta), side * std::cos(phi))
            .normalized();
  }
  return directions;
}

std::vector<Vec3> feature_directions(const TriangleMesh& mesh) {
  std::vector<Vec3> directions;
  const EdgeList list = edges(mesh);
  directions.reserve(mesh.vertices.size() + list.size());
  for (const Vec3& v : mesh.vertices) directions.push_back(v.normalized());
  for (std::size_t e = 0; e < list.size(); ++e) {
    const auto [from, to] = ends(mesh, list[e].front());
    directions.push_back((mesh.vertices[from] + mesh.vertices[to]).normalized());
  }
  return directions;
}

}  // namespace impinge
