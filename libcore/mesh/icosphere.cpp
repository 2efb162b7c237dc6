// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/icosphere.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "sphere/icosahedron.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMostHalvings = 8;

// The faces share the twelve corners, which are much farther apart than this tolerance.
VertexIndex corner_index(TriangleMesh& mesh, const Vec3& corner) {
  const auto same = [&](const Vec3& v) { return (v - corner).squaredNorm() < 1e-12; };
  const auto found = std::find_if(mesh.vertices.begin(), mesh.vertices.end(), same);
  const auto index = static_cast<VertexIndex>(found - mesh.vertices.begin());
  if (found == mesh.vertices.end()) mesh.vertices.push_back(corner);
  return index;
}

TriangleMesh icosahedron() {
  TriangleMesh mesh;
  for (const Icosahedron::Face& face : Icosahedron::instance().face) {
    Face corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = corner_index(mesh, face.corner[k]);
    if (area_vector(mesh, corners).dot(face.axis) < 0.0) std::swap(corners[1], corners[2]);
    mesh.faces.push_back(corners);
  }
  return mesh;
}

TriangleMesh halved(const TriangleMesh& coarse) {
  TriangleMesh fine{coarse.vertices, {}};
  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> middles;
  const auto middle = [&](VertexIndex a, VertexIndex b) {
    const auto next = static_cast<VertexIndex>(fine.vertices.size());
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), next);
    if (is_new) fine.vertices.push_back((coarse.vertices[a] + coarse.vertices[b]).normalized());
    return place->second;
  };
  for (const auto& [a, b, c] : coarse.faces) {
    const VertexIndex ab = middle(a, b);
    const VertexIndex bc = middle(b, c);
    const VertexIndex ca = middle(c, a);
    fine.faces.insert(fine.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

}  // namespace

TriangleMesh icosphere(double radius, std::size_t halvings) {
  if (!(radius > 0.0 && std::isfinite(radius))) {
    throw std::invalid_argument("the radius of a sphere is a positive length in mm, not " +
                                std::to_string(radius));
  }
  if (halvings > kMostHalvings) {
    throw std::invalid_argument("an icosahedron is halved at most " + std::to_string(kMostHalvings) +
                                " times, not " + std::to_string(halvings));
  }
  TriangleMesh mesh = icosahedron();
  for (std::size_t i = 0; i < halvings; ++i) mesh = halved(mesh);
  for (Vec3& v : mesh.vertices) v *= radius;
  return mesh;
}

}  // namespace impinge
