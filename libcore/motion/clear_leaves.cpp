// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/clear_leaves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sphere/infinity.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMostNodes = 100'000;  // of one level, undecided: more leaves nobody checks
constexpr double kMostRadius = 0x1p60;       // in 1 / kLeafUnit mm; a ball beyond 10^6 km has no leaf

// A face as one face of the cube sees it: corners (m, p, q).
struct LeafFace {
  std::array<Vec3, 3> corner;
  double farthest;  // mm, of its corners
};

struct LeafSurface {
  std::vector<LeafFace> faces;
  double off;    // mm
  double chord;  // share of a distance

  // How far a plane is moved outwards whose normal `longer` is a bound on, as a share of its length.
  double widening(const LeafFace& face, double longer) const { return off + chord * longer * face.farthest; }
};

// a m + b x[i] >= 0, with a unit normal.
struct LeafPlane {
  double a;
  Eigen::Index i;
  double b;
  double longer;  // the whole number above the length of the normal in whole numbers, over that length

  double side(const Vec3& x) const { return a * x[0] + b * x[i]; }
};

struct LeafNode {
  ClearLeaf leaf;
  std::vector<std::uint32_t> ball;  // faces that may be in it
  std::vector<std::uint32_t> socket;
};

std::int64_t width(const ClearLeaf& leaf) { return std::int64_t{1} << leaf.level; }

// Of the middle, in whole numbers.
std::array<std::int64_t, 3> middle(const ClearLeaf& leaf) {
  const std::int64_t n = width(leaf);
  return {n, 2 * leaf.i + 1 - n, 2 * leaf.j + 1 - n};
}

std::array<LeafPlane, 4> planes_of(const ClearLeaf& leaf) {
  const auto n = static_cast<double>(width(leaf));
  const auto plane = [n](double a, Eigen::Index i, double sign) {
    const double length = std::hypot(a, n);
    return LeafPlane{a / length, i, sign * n / length, (std::floor(length) + 1.0) / length};
  };
  const double p = 2.0 * static_cast<double>(leaf.i) - n;
  const double q = 2.0 * static_cast<double>(leaf.j) - n;
  return {plane(-p, 1, 1.0), plane(p + 2.0, 1, -1.0), plane(-q, 2, 1.0), plane(q + 2.0, 2, -1.0)};
}

// A triangle cut by four planes: 7 corners, and more only where rounding makes a sliver cross a plane often.
struct CutFace {
  std::array<Vec3, 16> corner;
  std::size_t size = 0;

  void add(const Vec3& x) { corner[size++] = x; }
  std::span<const Vec3> corners() const& { return {corner.data(), size}; }
  std::span<const Vec3> corners() const&& = delete;  // they would be gone before they are read
};

CutFace cut(const CutFace& whole, const LeafPlane& plane, double widening) {
  CutFace left;
  for (std::size_t k = 0; k < whole.size; ++k) {
    const Vec3& x = whole.corner[k];
    const Vec3& y = whole.corner[(k + 1) % whole.size];
    const double dx = plane.side(x) + widening;
    const double dy = plane.side(y) + widening;
    if (dx >= 0.0) left.add(x);
    if ((dx < 0.0) != (dy < 0.0)) left.add(x + (dx / (dx - dy)) * (y - x));
  }
  return left;
}

CutFace part_in(const LeafSurface& surface, const LeafFace& face, const std::array<LeafPlane, 4>& planes) {
  CutFace part;
  for (const Vec3& x : face.corner) part.add(x);
  for (const LeafPlane& plane : planes) part = cut(part, plane, surface.widening(face, plane.longer));
  return part;
}

// Those of the faces that no plane has all on its far side.
std::vector<std::uint32_t> meeting(const LeafSurface& surface, const std::vector<std::uint32_t>& faces,
                                   const std::array<LeafPlane, 4>& planes) {
  std::vector<std::uint32_t> left;
  for (const std::uint32_t f : faces) {
    const LeafFace& face = surface.faces[f];
    const bool beyond = std::ranges::any_of(planes, [&](const LeafPlane& plane) {
      const double least = -surface.widening(face, plane.longer);
      return std::ranges::all_of(face.corner, [&](const Vec3& x) { return plane.side(x) < least; });
    });
    if (!beyond) left.push_back(f);
  }
  return left;
}

// Farthest point of the ball in the node; above `enough` it may be any such number.
double ball_radius(const LeafSurface& ball, const LeafNode& node, const std::array<LeafPlane, 4>& planes,
                   double enough) {
  double most = 0.0;
  for (const std::uint32_t f : node.ball) {
    if (ball.faces[f].farthest <= most) continue;
    const CutFace part = part_in(ball, ball.faces[f], planes);
    for (const Vec3& x : part.corners()) most = std::max(most, x.norm());
    if (most > enough) break;
  }
  return most;
}

// Least height of the socket's points over the plane through the centre across the node's middle; infinite
// where there are none.
double socket_height(const LeafSurface& socket, const LeafNode& node,
                     const std::array<LeafPlane, 4>& planes) {
  const auto axis = middle(node.leaf);
  const Vec3 unit =
      Vec3(static_cast<double>(axis[0]), static_cast<double>(axis[1]), static_cast<double>(axis[2]))
          .normalized();
  double least = kInfinity;
  for (const std::uint32_t f : node.socket) {
    const auto& corner = socket.faces[f].corner;
    if (std::ranges::all_of(corner, [&](const Vec3& x) { return unit.dot(x) >= least; })) continue;
    const CutFace part = part_in(socket, socket.faces[f], planes);
    for (const Vec3& x : part.corners()) least = std::min(least, unit.dot(x));
  }
  return least;
}

// The radius halfway between both, if there is one; where one surface is missing, beside the other.
std::optional<std::int64_t> radius_between(const LeafSurface& ball, const LeafSurface& socket,
                                           const LeafNode& node, const std::array<LeafPlane, 4>& planes) {
  const auto unit = static_cast<double>(kLeafUnit);
  const double high = socket_height(socket, node, planes) - socket.off;
  const double low = node.ball.empty() ? 0.0 : ball_radius(ball, node, planes, high) + ball.off;
  const double least = std::ceil(low * unit);
  if (!(least < kMostRadius)) return std::nullopt;
  if (high == kInfinity) return static_cast<std::int64_t>(least) + 1;
  const double most = std::min(std::ceil(high * unit) - 1.0, kMostRadius);
  if (least > most) return std::nullopt;
  return static_cast<std::int64_t>(node.ball.empty() ? least : std::floor(0.5 * (least + most)));
}

// Where the ray along u meets a face, and how far that may be from the truth: mm.
struct RayHit {
  double radius;
  double off;
};

// None where the ray does not meet the face by more than the points of it are off, or too obliquely.
std::optional<RayHit> hit_of(const LeafFace& face, double off, const Vec3& u) {
  const auto& [a, b, c] = face.corner;
  const Vec3 normal = (b - a).cross(c - a);
  const double side = normal.dot(a) > 0.0 ? 1.0 : -1.0;
  const double nearest = std::min({a.norm(), b.norm(), c.norm()});
  for (const Vec3& edge : {a.cross(b), b.cross(c), c.cross(a)}) {
    if (!(side * edge.dot(u) * nearest > 8.0 * off * edge.norm())) return std::nullopt;
  }
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  const double across = std::abs(normal.dot(u));  // twice the area times the cosine
  if (!(across > 16.0 * off * longest)) return std::nullopt;
  return RayHit{normal.dot(a) / normal.dot(u), 4.0 * off * normal.norm() / across};
}

// Is the ball not nearer than the socket along the middle of the node, beyond doubt?
bool impinged_along_middle(const LeafSurface& ball, const LeafSurface& socket, const LeafNode& node) {
  const auto axis = middle(node.leaf);
  const Vec3 u =
      Vec3(static_cast<double>(axis[0]), static_cast<double>(axis[1]), static_cast<double>(axis[2]))
          .normalized();
  double outermost = -kInfinity;
  for (const std::uint32_t f : node.ball) {
    if (const auto hit = hit_of(ball.faces[f], ball.off, u))
      outermost = std::max(outermost, hit->radius - hit->off);
  }
  if (outermost < 0.0) return false;
  return std::ranges::any_of(node.socket, [&](std::uint32_t f) {
    const auto hit = hit_of(socket.faces[f], socket.off, u);
    return hit && hit->radius + hit->off <= outermost;
  });
}

// From (m, p, q) to (x, y, z).
template <class Number>
std::array<Number, 3> turned_back(int face, const std::array<Number, 3>& seen) {
  std::array<Number, 3> x{};
  const auto k = static_cast<std::size_t>(face / 2);
  for (std::size_t c = 0; c < 3; ++c) x[(k + c) % 3] = c == 0 && face % 2 == 1 ? -seen[0] : seen[c];
  return x;
}

LeafSurface seen_from(int face, const UncertainMesh& surface, double chord) {
  LeafSurface seen{{}, surface.off_mm, chord};
  const Eigen::Index k = face / 2;
  const double sign = face % 2 == 0 ? 1.0 : -1.0;
  seen.faces.reserve(surface.mesh.faces.size());
  for (const Face& f : surface.mesh.faces) {
    LeafFace one{corners_of(surface.mesh, f), 0.0};
    for (Vec3& x : one.corner) {
      one.farthest = std::max(one.farthest, x.norm());
      x = Vec3(sign * x[k], x[(k + 1) % 3], x[(k + 2) % 3]);
    }
    seen.faces.push_back(one);
  }
  return seen;
}

std::vector<std::uint32_t> all_faces(const LeafSurface& surface) {
  std::vector<std::uint32_t> all(surface.faces.size());
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<std::uint32_t>(f);
  return all;
}

// The four parts of a node, appended.
void divide(const LeafNode& node, std::vector<LeafNode>& parts) {
  for (std::int64_t part = 0; part < 4; ++part) {
    const ClearLeaf& whole = node.leaf;
    parts.push_back({{whole.face, whole.level + 1, 2 * whole.i + part / 2, 2 * whole.j + part % 2, 0},
                     node.ball,
                     node.socket});
  }
}

// Adds the leaves of a face of the cube, level by level.
void divide_cube_face(int face, const LeafQuestion& question, LeafAnswer& answer) {
  const LeafSurface ball = seen_from(face, question.ball, question.chord);
  const LeafSurface socket = seen_from(face, question.socket, 0.0);
  std::vector<LeafNode> level{{{face, 0, 0, 0, 0}, all_faces(ball), all_faces(socket)}};
  while (!level.empty()) {
    std::vector<LeafNode> finer;
    for (LeafNode& node : level) {
      const auto planes = planes_of(node.leaf);
      node.ball = meeting(ball, node.ball, planes);
      node.socket = meeting(socket, node.socket, planes);
      if (const auto radius = radius_between(ball, socket, node, planes)) {
        node.leaf.radius = *radius;
        answer.leaves.push_back(node.leaf);
        continue;
      }
      const auto axis = middle(node.leaf);
      if (question.chord == 0.0 && impinged_along_middle(ball, socket, node)) {
        answer.ray = turned_back(face, axis);
        return;
      }
      if (node.leaf.level == question.finest || finer.size() > kMostNodes) {
        const auto open = turned_back(face, axis);
        answer.open =
            Vec3(static_cast<double>(open[0]), static_cast<double>(open[1]), static_cast<double>(open[2]))
                .normalized();
        if (question.chord > 0.0 || finer.size() > kMostNodes) return;  // else a ray may still be found
        continue;
      }
      divide(node, finer);
    }
    level = std::move(finer);
  }
}

}  // namespace

LeafAnswer clear_leaves(const LeafQuestion& question) {
  LeafAnswer answer;
  for (int face = 0; face < 6 && !answer.ray; ++face) {
    if (question.chord > 0.0 && answer.open) break;
    divide_cube_face(face, question, answer);
  }
  return answer;
}

}  // namespace impinge
