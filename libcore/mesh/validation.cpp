// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validation.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/collinear.hpp"
#include "mesh/disjoint_sets.hpp"

namespace impinge {
namespace {

bool exists(const TriangleMesh& mesh, const Face& face) {
  return std::ranges::all_of(face, [&mesh](VertexIndex v) { return v < mesh.vertices.size(); });
}

void count_vertices(const TriangleMesh& mesh, MeshReport& report) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces) {
    for (const VertexIndex v : face) {
      if (v < used.size()) used[v] = true;
    }
  }
  report.unreferenced_vertices = static_cast<std::size_t>(std::ranges::count(used, false));
  report.non_finite_vertices = static_cast<std::size_t>(
      std::ranges::count_if(mesh.vertices, [](const Vec3& v) { return !v.allFinite(); }));
}

bool degenerate(const TriangleMesh& mesh, const Face& face) {
  if (!has_three_corners(mesh, face)) return true;
  const Vec3& a = corner(mesh, face, 0);
  const Vec3& b = corner(mesh, face, 1);
  const Vec3& c = corner(mesh, face, 2);
  return a.allFinite() && b.allFinite() && c.allFinite() && collinear(a, b, c);
}

void count_faces(const TriangleMesh& mesh, MeshReport& report) {
  std::vector<Face> sorted;
  for (Face face : mesh.faces) {
    if (!exists(mesh, face)) {
      ++report.invalid_faces;
      continue;
    }
    if (degenerate(mesh, face)) ++report.degenerate_faces;
    if (!has_three_corners(mesh, face)) continue;
    std::ranges::sort(face);
    sorted.push_back(face);
  }
  std::ranges::sort(sorted);
  report.duplicate_faces =
      static_cast<std::size_t>(std::distance(std::unique(sorted.begin(), sorted.end()), sorted.end()));
}

void count_edges(const EdgeList& list, MeshReport& report) {
  for (std::size_t e = 0; e < list.size(); ++e) {
    if (list[e].size() == 1) ++report.boundary_edges;
    if (list[e].size() > 2) ++report.non_manifold_edges;
  }
}

void count_components(const TriangleMesh& mesh, MeshReport& report) {
  DisjointSets sets(mesh.vertices.size());
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces) {
    if (!has_three_corners(mesh, face)) continue;
    for (const VertexIndex v : face) {
      sets.join(face[0], v, false);
      used[v] = true;
    }
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (used[v] && sets.find(v).root == v) ++report.components;
  }
}

void count_flips(const TriangleMesh& mesh, const EdgeList& list, MeshReport& report) {
  DisjointSets sets(mesh.faces.size());
  for (std::size_t e = 0; e < list.size(); ++e) {
    if (list[e].size() != 2) continue;
    const HalfEdge a = list[e][0];
    const HalfEdge b = list[e][1];
    const bool disagree = ends(mesh, a) == ends(mesh, b);
    report.orientable = sets.join(a.face, b.face, disagree) && report.orientable;
  }
  std::vector<std::array<std::size_t, 2>> sides(mesh.faces.size(), {0, 0});
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const DisjointSets::Place place = sets.find(f);
    ++sides[place.root][place.opposite ? 1 : 0];
  }
  for (const auto& [same, opposite] : sides) report.flipped_faces += std::min(same, opposite);
}

// By the divergence theorem, relative to a vertex, so that a far origin costs no digits.
double signed_volume(const TriangleMesh& mesh) {
  const Vec3 origin = mesh.vertices.front();
  double six_times = 0.0;
  for (const Face& face : mesh.faces) {
    if (!has_three_corners(mesh, face)) continue;
    six_times += (corner(mesh, face, 0) - origin).dot(area_vector(mesh, face));
  }
  return six_times / 6.0;
}

}  // namespace

bool MeshReport::closed() const {
  return components > 0 && boundary_edges == 0 && non_manifold_edges == 0 && invalid_faces == 0;
}

MeshReport& MeshReport::operator+=(const MeshReport& other) {
  for (const auto count :
       {&MeshReport::vertices, &MeshReport::faces, &MeshReport::unreferenced_vertices,
        &MeshReport::non_finite_vertices, &MeshReport::invalid_faces, &MeshReport::degenerate_faces,
        &MeshReport::duplicate_faces, &MeshReport::flipped_faces, &MeshReport::non_manifold_edges,
        &MeshReport::boundary_edges, &MeshReport::components})
    this->*count += other.*count;
  orientable = orientable && other.orientable;
  volume = volume && other.volume ? std::optional(*volume + *other.volume) : std::nullopt;
  return *this;
}

MeshReport validate(const TriangleMesh& mesh) {
  MeshReport report;
  report.vertices = mesh.vertices.size();
  report.faces = mesh.faces.size();
  count_vertices(mesh, report);
  count_faces(mesh, report);
  const EdgeList list = edges(mesh);
  count_edges(list, report);
  count_components(mesh, report);
  count_flips(mesh, list, report);
  const bool one_orientation = report.orientable && report.flipped_faces == 0;
  if (report.closed() && one_orientation && report.non_finite_vertices == 0) {
    report.volume = signed_volume(mesh);
  }
  return report;
}

std::string describe(const MeshReport& report) {
  std::ostringstream text;
  text << report.faces << " faces, " << report.vertices << " vertices, " << report.components
       << (report.components == 1 ? " part, " : " parts, ");
  if (report.closed()) {
    text << "closed";
    if (report.volume) text << ", volume " << *report.volume << " mm^3";
  } else {
    text << "open, " << report.boundary_edges << " boundary edges";
  }
  const std::array<std::pair<std::size_t, const char*>, 7> flaws{{
      {report.non_finite_vertices, "vertices that are not finite"},
      {report.unreferenced_vertices, "vertices of no face"},
      {report.invalid_faces, "faces of missing vertices"},
      {report.degenerate_faces, "degenerate faces"},
      {report.duplicate_faces, "duplicate faces"},
      {report.flipped_faces, "flipped faces"},
      {report.non_manifold_edges, "non-manifold edges"},
  }};
  const char* separator = "\nflaws: ";
  for (const auto& [count, what] : flaws) {
    if (count == 0) continue;
    text << separator << count << ' ' << what;
    separator = ", ";
  }
  if (!report.orientable) text << separator << "not orientable";
  return text.str();
}

}  // namespace impinge
