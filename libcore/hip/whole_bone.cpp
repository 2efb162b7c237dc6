// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/whole_bone.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <Eigen/Geometry>

#include "hip/length_unit.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/weld.hpp"

namespace impinge {
namespace {

constexpr double kFar = 4.5;          // head radii from the centre
constexpr double kCutEnds = 2.0;      // head radii: a head or a socket that was cut out ends before
constexpr double kHiddenBone = 0.02;  // of all directions

// Six times the volume; for an open mesh, of the cone from it to the centre.
double volume_of(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const Face& face : mesh.faces) volume += area_vector(mesh, face).dot(corner(mesh, face, 0));
  return volume;
}

// Unmarks all but the largest part by area; faces that share the place of a vertex are connected.
void keep_largest(const TriangleMesh& mesh, std::vector<bool>& marked) {
  const std::vector<VertexIndex> place = first_at_place(mesh.vertices);
  DisjointSets parts(place.size());
  for (std::size_t f = 0; f < marked.size(); ++f) {
    if (!marked[f]) continue;
    for (const VertexIndex v : mesh.faces[f]) parts.join(place[mesh.faces[f][0]], place[v], false);
  }
  const auto part_of = [&](std::size_t f) { return parts.find(place[mesh.faces[f][0]]).root; };
  std::vector<double> area(place.size(), 0.0);
  for (std::size_t f = 0; f < marked.size(); ++f)
    if (marked[f]) area[part_of(f)] += area_vector(mesh, mesh.faces[f]).norm();
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(area) - area.begin());
  for (std::size_t f = 0; f < marked.size(); ++f) marked[f] = marked[f] && part_of(f) == largest;
}

// The faces with that mark, and their vertices. The unmarked ones also get the vertices of no face.
TriangleMesh marked_faces(const TriangleMesh& mesh, const std::vector<bool>& marks, bool mark) {
  constexpr auto kNone = static_cast<VertexIndex>(-1);
  std::vector<bool> used(mesh.vertices.size(), !mark);
  TriangleMesh found;
  for (const bool now : {!mark, mark}) {
    for (std::size_t f = 0; f < marks.size(); ++f)
      if (marks[f] == now)
        for (const VertexIndex v : mesh.faces[f]) used[v] = now == mark;
  }
  std::vector<VertexIndex> to(mesh.vertices.size(), kNone);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    to[v] = static_cast<VertexIndex>(found.vertices.size());
    found.vertices.push_back(mesh.vertices[v]);
  }
  for (std::size_t f = 0; f < marks.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    if (marks[f] == mark) found.faces.push_back({to[a], to[b], to[c]});
  }
  return found;
}

}  // namespace

bool is_whole_bone(const TriangleMesh& bone, double hidden, double head_radius) {
  const double reach = reach_of(bone).farthest;
  return reach > kFar * head_radius || (reach > kCutEnds * head_radius && hidden > kHiddenBone);
}

std::vector<bool> faces_of_joint(const TriangleMesh& bone, Surface of, double head_radius) {
  const double outward = volume_of(bone) < 0.0 ? -1.0 : 1.0;
  std::vector<bool> marked;
  marked.reserve(bone.faces.size());
  for (const Face& face : bone.faces) {
    const auto [a, b, c] = corners_of(bone, face);
    const bool near = ((a + b + c) / 3.0).norm() < kJointEnds * head_radius;
    marked.push_back(near && (of == Surface::ball || outward * area_vector(bone, face).dot(a) < 0.0));
  }
  keep_largest(bone, marked);
  return marked;
}

void split_bone(TriangleMesh& mesh, std::vector<MeshPart>& parts, const std::vector<bool>& of_joint,
                const std::string& rest) {
  const TriangleMesh bone = main_surface(mesh, parts);
  const std::vector<TriangleMesh> beside = part_surfaces(mesh, parts);
  const std::vector<MeshPart> before = std::exchange(parts, {});
  mesh = marked_faces(bone, of_joint, true);
  append_part(mesh, parts, rest, marked_faces(bone, of_joint, false));
  parts.back().of_main = true;
  for (std::size_t k = 0; k < beside.size(); ++k) append_part(mesh, parts, before[k].name, beside[k]);
}

}  // namespace impinge
