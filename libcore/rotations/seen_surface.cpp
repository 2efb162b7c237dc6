// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/seen_surface.hpp"

#include <algorithm>

#include "mesh/edges.hpp"
#include "mesh/lengths.hpp"
#include "mesh/surface_vertices.hpp"

namespace impinge {
namespace {

constexpr double kMostDoubt = 1e-9;       // a plane that is less certain is not used
constexpr double kThinSide = 1e-6;        // a side that is seen under a smaller angle has no plane
constexpr double kPlaneRounding = 4e-15;  // rounding of q . v as a share of |q| |v|

// Adds the plane of a face, if it is certain enough. A point of the face is a mean of its corners v, so that
// the relative error of 1 / r is at most the largest |q . v - 1|.
void add_plane(const std::array<Vec3, 3>& v, DirectionFace& face) {
  face.plane = Vec3::Zero();
  const Vec3 normal = (v[1] - v[0]).cross(v[2] - v[0]);
  const double offset = normal.dot((v[0] + v[1] + v[2]) / 3.0);
  if (!(std::abs(offset) > 0.0)) return;
  const Vec3 plane = normal / offset;
  double doubt = 0.0;
  for (const Vec3& x : v)
    doubt = std::max(doubt, std::abs(plane.dot(x) - 1.0) + kPlaneRounding * plane.norm() * x.norm());
  if (!(doubt <= kMostDoubt)) return;
  face.plane = plane;
  face.doubt = doubt + kPlaneRounding;
}

DirectionFace seen_face(const std::array<Vec3, 3>& v) {
  const FaceCap cap = face_cap(v);
  DirectionFace seen{{}, {}, Vec3::Zero(), 0.0, cap.range, cap.cap, {}};
  if (!cap.small()) seen.cap.radius = kPi;
  for (std::size_t k = 0; k < 3; ++k) seen.corner[k] = v[k].stableNormalized();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 across = static_cast<double>(cap.side) * seen.corner[k].cross(seen.corner[(k + 1) % 3]);
    const double length = across.norm();
    seen.inward[k] = length > kThinSide ? Vec3(across / length) : Vec3(Vec3::Zero());
  }
  if (std::cos(cap.cap.radius) >= DirectionFace::kLeastCosine) add_plane(v, seen);
  return seen;
}

// Finds, for each side of each face, a face on the other side of the plane through the centre and that side.
void find_neighbours(const TriangleMesh& mesh, std::vector<DirectionFace>& faces) {
  for (DirectionFace& face : faces) face.beyond.fill(DirectionFace::kNone);
  for_each_edge(mesh, [&](std::span<const HalfEdge> at) {
    const Edge edge = ends(mesh, at[0]);
    std::array<std::uint32_t, 2> on{DirectionFace::kNone, DirectionFace::kNone};  // on either side
    const auto turn = [&](const HalfEdge& h) {
      const Vec3& third = corner(mesh, mesh.faces[h.face], (h.side + 2) % 3);
      return orientation(mesh.vertices[edge[0]], mesh.vertices[edge[1]], third);  // 0 if edge-on
    };
    for (const HalfEdge& h : at)
      if (turn(h) != 0) on[turn(h) > 0 ? 1 : 0] = static_cast<std::uint32_t>(h.face);
    for (const HalfEdge& h : at)
      if (turn(h) != 0) faces[h.face].beyond[h.side] = on[turn(h) > 0 ? 0 : 1];
  });
}

// Makes the tree of the faces, and sorts the faces in its order.
CapTree sorted(TriangleMesh& mesh) {
  std::vector<CapItem> items;
  for (const Face& face : mesh.faces) {
    const FaceCap cap = face_cap(corners_of(mesh, face));  // used where the face is edge-on
    items.push_back(cap_item(mesh, face)
                        .value_or(CapItem{{cap.cap.axis, cap.small() ? cap.cap.radius : kPi}, cap.range}));
  }
  CapTree tree(items);
  std::vector<Face> faces;
  for (const std::uint32_t f : tree.order()) faces.push_back(mesh.faces[f]);
  mesh.faces = std::move(faces);
  return tree;
}

// Makes the tree of the vertices; their places come in its order, and the numbers of the faces' corners too.
CapTree of_vertices(const TriangleMesh& mesh, std::vector<Vec3>& places,
                    std::vector<std::array<std::uint32_t, 3>>& corners) {
  std::vector<CapItem> items;
  std::vector<Vec3> all;
  std::vector<std::uint32_t> number(mesh.vertices.size(), DirectionFace::kNone);
  std::vector<VertexIndex> kept;
  for (const VertexIndex v : surface_vertices(mesh)) {
    const Vec3& x = mesh.vertices[v];
    const double length = x.norm();
    if (!(length > 0.0)) continue;
    items.push_back({{x.stableNormalized(), 0.0}, {length, length}});
    all.push_back(x);
    kept.push_back(v);
  }
  CapTree tree(items);
  for (const std::uint32_t v : tree.order()) {
    number[kept[v]] = static_cast<std::uint32_t>(places.size());
    places.push_back(all[v]);
  }
  corners.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) corners.push_back({number[face[0]], number[face[1]], number[face[2]]});
  return tree;
}

}  // namespace

CapAngle::CapAngle(double radians)
    : radius(radians),
      cosine(std::cos(radians)),
      sine(std::sin(radians)),
      tangent(sine / cosine),
      wide(!(radians < 0.5 * kPi - 1e-3)) {}

double most_over(const Vec3& q, const Vec3& w, const CapAngle& cap) {
  const double along = q.dot(w);
  const double across = q.cross(w).norm();
  if (across <= along * cap.tangent) return q.norm() * w.norm();
  return along * cap.cosine + across * cap.sine;
}

double least_over(const Vec3& q, const Vec3& w, const CapAngle& cap) { return -most_over(-q, w, cap); }

void DirectionPolygon::clip(const Vec3& normal, double least) {
  std::array<double, kMost> at;
  double lowest = HUGE_VAL;
  for (std::size_t k = 0; k < size_; ++k) lowest = std::min(lowest, at[k] = normal.dot(points_[k]) - least);
  if (lowest >= 0.0) return;
  std::array<Vec3, kMost> kept;
  std::size_t count = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    const Vec3& a = points_[k];
    const Vec3& b = points_[(k + 1) % size_];
    const double at_a = at[k];
    const double at_b = at[(k + 1) % size_];
    if (at_a >= 0.0) kept[count++] = a;
    if ((at_a >= 0.0) != (at_b >= 0.0)) kept[count++] = a + (at_a / (at_a - at_b)) * (b - a);
  }
  std::copy_n(kept.begin(), count, points_.begin());
  size_ = count;
}

SeenSurface::SeenSurface(const TriangleMesh& mesh, Layer layer, bool keep_edge_on)
    : layer_(layer), face_tree_(std::span<const CapItem>{}), vertex_tree_(std::span<const CapItem>{}) {
  require_float_lengths(mesh);
  TriangleMesh kept = without_edge_on(mesh);
  edge_on_ = keep_edge_on && kept.faces.size() < mesh.faces.size();
  if (edge_on_) kept = mesh;
  face_tree_ = sorted(kept);
  vertex_tree_ = of_vertices(kept, vertices_, corners_);
  triangles_.reserve(kept.faces.size());
  faces_.reserve(kept.faces.size());
  for (const Face& face : kept.faces) {
    triangles_.push_back(corners_of(kept, face));
    faces_.push_back(seen_face(triangles_.back()));
    least_radius_ = std::min(least_radius_, faces_.back().range.low);
  }
  find_neighbours(kept, faces_);
}

double SeenSurface::least_distance() const {
  double least = HUGE_VAL;
  for (const Triangle& face : triangles_) least = std::min(least, nearest_point(Vec3::Zero(), face).norm());
  return least * (1.0 - 1e-9);
}

std::vector<SeenBorder> SeenSurface::borders() const {
  std::vector<SeenBorder> found;
  for (const DirectionFace& face : faces_)
    for (std::size_t k = 0; k < 3; ++k)
      if (face.beyond[k] == DirectionFace::kNone)
        found.push_back({(face.corner[k] + face.corner[(k + 1) % 3]).stableNormalized(), face.inward[k]});
  return found;
}

DirectionFace SeenSurface::seen_from(std::uint32_t f, const Vec3& centre) const {
  std::array<Vec3, 3> at = triangles_[f];
  for (Vec3& x : at) x -= centre;
  DirectionFace face = seen_face(at);
  face.beyond.fill(DirectionFace::kNone);
  return face;
}

template <class Visit>
bool SeenSurface::any_of(const DirectionCap& cap, const Visit& visit) const {
  std::array<std::uint32_t, CapTree::kMostPending> pending;
  std::size_t count = 0;
  if (!faces_.empty()) pending[count++] = 0;
  while (count > 0) {
    const CapBlock& block = face_tree_.blocks()[pending[--count]];
    for (std::size_t k = 0; k < block.nodes; ++k) {
      const Vec3 axis(block.x[k], block.y[k], block.z[k]);
      if ((axis - cap.axis).norm() > block.angle[k] + cap.radius) continue;
      if (!block.leaf(k)) pending[count++] = block.first[k];
      for (std::uint32_t f = block.first[k]; f < block.first[k] + block.items[k]; ++f)
        if (visit(f)) return true;
    }
  }
  return false;
}

bool SeenSurface::any_along(const Vec3& u, const std::function<bool(std::uint32_t)>& visit) const {
  return any_of({u, 0.0}, [&](std::uint32_t f) {
    const auto inside = [&](const Vec3& n) { return n.dot(u) >= kSideSlack; };
    return std::ranges::all_of(faces_[f].inward, inside) && visit(f);
  });
}

bool near(const DirectionFace& face, const DirectionCap& cap) {
  if ((face.cap.axis - cap.axis).norm() > face.cap.radius + cap.radius) return false;
  if (cap.radius >= 0.5 * kPi) return true;
  const double beyond = -std::sin(cap.radius) - kSideSlack;
  return std::ranges::all_of(face.inward, [&](const Vec3& n) { return n.dot(cap.axis) >= beyond; });
}

bool SeenSurface::any_near(const DirectionCap& cap) const {
  return any_of(cap, [&](std::uint32_t f) { return near(faces_[f], cap); });
}

std::uint32_t SeenSurface::face_along(const Vec3& u) const {
  std::uint32_t found = DirectionFace::kNone;
  double best = 0.0;
  any_along(u, [&](std::uint32_t f) {
    const double inverse = faces_[f].plane.dot(u);
    if (found == DirectionFace::kNone || (layer_ == Layer::nearest ? inverse > best : inverse < best)) {
      found = f;
      best = inverse;
    }
    return false;
  });
  return found;
}

bool SeenSurface::side_meets(const DirectionFace& face, std::size_t side, const CapBorder& cap) {
  const Vec3& n = face.inward[side];
  if (n.isZero(0.0)) return true;
  const Vec3& a = face.corner[side];
  const Vec3& b = face.corner[(side + 1) % 3];
  if (std::abs(n.dot(cap.axis)) > cap.sine) return false;
  if (a.dot(cap.axis) >= cap.cosine || b.dot(cap.axis) >= cap.cosine) return true;
  // Both ends are outside of the cap: the side meets it only if the nearest direction of its great circle is
  // between the ends.
  const Vec3 along = a.cross(b);
  return a.cross(cap.axis).dot(along) >= -kDirectionSlack && cap.axis.cross(b).dot(along) >= -kDirectionSlack;
}

void SeenSurface::begin(PatchMemory& memory, std::uint32_t from) const {
  memory.mark.resize(faces_.size(), 0);
  if (++memory.search == 0) {  // the counter has overflowed
    std::ranges::fill(memory.mark, 0U);
    memory.search = 1;
  }
  memory.faces.clear();
  reach(memory, from);
}

void SeenSurface::reach(PatchMemory& memory, std::uint32_t face) {
  if (memory.mark[face] == memory.search) return;
  memory.mark[face] = memory.search;
  memory.faces.push_back(face);
}

}  // namespace impinge
