// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/inside_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "mesh/disjoint_sets.hpp"
#include "mesh/edges.hpp"
#include "mesh/weld.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMostRays = 64;  // of a piece

// To a frame in which a ray that is along no edge or axis of usual meshes is along +z. It keeps z.
Vec3 leaning(const Vec3& x) { return {x.x() + 0.209 * x.z(), x.y() + 0.096 * x.z(), x.z()}; }

// A welded mesh with the piece of each vertex: a vertex of it.
struct Pieces {
  explicit Pieces(const TriangleMesh& unwelded) : mesh(weld(unwelded)) {
    DisjointSets sets(mesh.vertices.size());
    for (const Face& f : mesh.faces) {
      sets.join(f[0], f[1], false);
      sets.join(f[1], f[2], false);
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) of.push_back(sets.find(v).root);
    for (Vec3& x : mesh.vertices) x = leaning(x);
  }
  // Those that are not closed.
  std::set<std::size_t> open() const {
    std::set<std::size_t> found;
    for_each_edge(mesh, [&](std::span<const HalfEdge> half_edges) {
      if (half_edges.size() % 2 == 1) found.insert(of[mesh.faces[half_edges[0].face][0]]);
    });
    return found;
  }
  TriangleMesh mesh;
  std::vector<std::size_t> of;
};

// Does the ray from x along +z cross the face? None if it passes within `off` of what would change that.
std::optional<bool> crosses(const std::array<Vec3, 3>& face, const Vec3& x, double off) {
  const auto [low, high] = std::minmax({face[0].x(), face[1].x(), face[2].x()});
  if (x.x() < low - off || x.x() > high + off) return false;
  const auto [front, back] = std::minmax({face[0].y(), face[1].y(), face[2].y()});
  if (x.y() < front - off || x.y() > back + off) return false;
  int sides = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = face[(k + 1) % 3] - face[k];
    const double turn = side.x() * (x.y() - face[k].y()) - side.y() * (x.x() - face[k].x());
    if (!(std::abs(turn) > off * (std::hypot(side.x(), side.y()) + off))) return std::nullopt;
    sides += turn > 0.0 ? 1 : -1;
  }
  if (std::abs(sides) != 3) return false;
  const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]);
  const double above = normal.dot(face[0] - x);
  if (!(std::abs(above) > off * normal.norm())) return std::nullopt;
  return (above > 0.0) == (normal.z() > 0.0);
}

// Whether x is inside one of the pieces that are not open.
std::optional<bool> is_inside(const Vec3& x, const Pieces& in, const std::set<std::size_t>& open,
                              double off) {
  std::map<std::size_t, bool> odd;
  for (const Face& f : in.mesh.faces) {
    const auto crossed = crosses(corners_of(in.mesh, f), x, off);
    if (crossed && !*crossed) continue;
    if (open.contains(in.of[f[0]])) continue;
    if (!crossed) return std::nullopt;
    odd[in.of[f[0]]] ^= true;
  }
  return std::ranges::any_of(odd, [](const auto& piece) { return piece.second; });
}

}  // namespace

bool all_closed(const TriangleMesh& mesh) { return Pieces(mesh).open().empty(); }

Inside inside_pieces(const UncertainMesh& of, const UncertainMesh& in) {
  const Pieces from(of.mesh);
  const Pieces into(in.mesh);
  const std::set<std::size_t> open = into.open();
  std::map<std::size_t, std::size_t> rays;  // of a piece; kMostRays + 1 once it is known
  for (const Face& f : from.mesh.faces) {
    std::size_t& tried = rays[from.of[f[0]]];
    if (tried >= kMostRays) continue;
    const auto inside = is_inside(from.mesh.vertices[f[0]], into, open, 3.0 * (of.off_mm + in.off_mm));
    if (inside && *inside) return Inside::yes;
    tried = inside ? kMostRays + 1 : tried + 1;
  }
  const bool known = std::ranges::all_of(rays, [](const auto& piece) { return piece.second > kMostRays; });
  return known ? Inside::no : Inside::open;
}

}  // namespace impinge
