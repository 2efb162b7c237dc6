// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/turn_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/triangle_distance.hpp"
#include "motion/part_distance.hpp"
#include "motion/sinusoid.hpp"
#include "motion/turn_tree.hpp"

namespace impinge {
namespace {

constexpr double kTolerance = 1e-12;   // of the largest radius
constexpr int kMostAdvances = 10'000;  // of a pair of parts

// What a pair of parts is asked with. f is near zero, by `bound` times a distance, whenever the parts are
// within that distance of each other; the one that turns is within `arm` of the axis; `doubt` is added to the
// tolerance.
struct Pair {
  const Sinusoid& f;
  double bound;
  double arm;
  double doubt;
};

// Looks for the first angle at which two parts are within the tolerance of each other.
class Search {
 public:
  Search(const AngleSpan& angles, double tolerance) : angles_(angles), tolerance_(tolerance) {}

  // distance(t) is that of the parts. Has a new first angle been found?
  template <class Distance>
  bool improve(const Pair& pair, const Distance& distance) {
    const double tolerance = tolerance_ + pair.doubt;
    bool found = false;
    int steps = kMostAdvances;
    for (const AngleSpan& span : near_zero(pair.f, 2.0 * pair.bound * tolerance)) {
      const AngleSpan part{std::max(span.from, angles_.from), std::min(span.to, angles_.to)};
      // No point comes nearer by more than its arm times the angle: what is left of the distance is free.
      for (double t = part.from; t <= part.to;) {
        const double d = distance(t);
        if (!(d > 2.0 * tolerance && --steps > 0)) {
          angles_.to = t;
          found = true;
          break;
        }
        t += (d - tolerance) / pair.arm;
      }
    }
    return found;
  }

  double first() const { return angles_.to; }

 private:
  AngleSpan angles_;
  double tolerance_;
};

// Where a contact was found, in the frame of the axis.
struct Found {
  Search search;
  std::optional<TurnContact> contact;

  void note(ContactKind kind, const Vec3& place, const Vec3& normal) {
    contact = TurnContact{search.first(), kind, place, normal.stableNormalized(), {}};
  }
};

double arm_of(const Vec3& x) { return std::hypot(x.x(), x.y()); }

// A point of the ball against a face of the socket, or a wall beyond its rim.
void try_ball_point(const Vec3& x, const TurnFace& face, Found& found) {
  Sinusoid f = turned_dot(x, face.normal);
  f.constant -= face.normal.dot(face.corner[0]);
  if (found.search.improve({f, face.size, arm_of(x), face.doubt},
                           [&](double t) { return least_distance(turned(x, t), face); }))
    found.note(face.wall ? ContactKind::rims : ContactKind::ball_vertex, turned(x, found.search.first()),
               face.normal);
}

// A point of the socket against a face of the ball, or a wall within its rim.
void try_socket_point(const Vec3& y, const TurnFace& face, Found& found) {
  Sinusoid f = turned_dot(face.normal, y);
  f.constant -= face.normal.dot(face.corner[0]);
  if (found.search.improve({f, face.size, arm_of(y), face.doubt},
                           [&](double t) { return least_distance(turned(y, -t), face); }))
    found.note(face.wall ? ContactKind::rims : ContactKind::socket_vertex, y,
               turned(face.normal, found.search.first()));
}

void try_edges(const TurnEdge& ball, const TurnEdge& socket, Found& found) {
  const Vec3 a = ball.to - ball.from;
  const Vec3 b = socket.to - socket.from;
  const Sinusoid f = turned_dot(a, socket.from.cross(b)) + turned_dot(ball.from.cross(a), b);
  const double arm = std::max(arm_of(ball.from), arm_of(ball.to));
  const bool better = found.search.improve({f, a.norm() * b.norm(), arm, 0.0}, [&](double t) {
    return least_distance_of_edges(turned(ball.from, t), turned(ball.to, t), socket.from, socket.to);
  });
  if (!better) return;
  const Vec3 along = turned(a, found.search.first());
  const Vec3 across = along.cross(b);
  const double squared = across.squaredNorm();
  const Vec3 between = turned(ball.from, found.search.first()) - socket.from;
  const double share = squared > 0.0 ? between.cross(along).dot(b.cross(along)) / squared : 0.0;
  found.note(ContactKind::edges, socket.from + std::clamp(share, 0.0, 1.0) * b, across);
}

// Points with a tree.
struct Points {
  std::vector<Vec3> places;  // mm
  TurnTree tree;
};

// Vertices, moved out by `out` mm but not nearer to the centre than `nearest`. A moved vertex keeps its ray.
Points moved_out(const TurnSurface& surface, double out, double nearest, double margin) {
  Points moved;
  std::vector<TurnBox> boxes;
  std::vector<std::uint32_t> order;
  for (const std::uint32_t k : surface.parts->by_vertex) {
    const TurnPoint& vertex = surface.points[surface.parts->vertices[k]];
    if (vertex.r == 0.0) continue;
    const TurnPoint point(std::max(vertex.r + out, nearest) / vertex.r * vertex.x);
    order.push_back(static_cast<std::uint32_t>(boxes.size()));
    boxes.push_back(turn_box(std::array{&point}, point.r, margin));
    moved.places.push_back(point.x);
  }
  moved.tree = TurnTree(boxes, order);
  return moved;
}

TurnTree tree_of_walls(const std::vector<TurnFace>& walls, double margin) {
  std::vector<TurnBox> boxes;
  std::vector<Vec3> middles;
  for (const TurnFace& wall : walls) {
    const auto& [a, b, c] = wall.corner;
    const std::array points{TurnPoint(a), TurnPoint(b), TurnPoint(c)};
    const double nearest = std::sqrt(squared_distance_to_triangle(Vec3::Zero(), a, b, c));
    boxes.push_back(turn_box(std::array{&points[0], &points[1], &points[2]}, nearest, margin + wall.doubt));
    middles.emplace_back(a + b + c);
  }
  return {boxes, order_by_place(middles)};
}

// Calls visit(side) for those sides of a face that no face before it has.
template <class Visit>
void for_each_first_side(const TurnSurface& surface, std::size_t f, const Visit& visit) {
  const Face& face = surface.mesh->faces[f];
  for (std::size_t k = 0; k < 3; ++k) {
    if (surface.parts->first_side[f][k])
      visit(TurnEdge{surface.points[face[k]].x, surface.points[face[(k + 1) % 3]].x});
  }
}

template <class Visit>
void for_each_first_corner(const TurnSurface& surface, std::size_t f, const Visit& visit) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (surface.parts->first_corner[f][k]) visit(surface.points[surface.mesh->faces[f][k]].x);
  }
}

// Two faces, by what of them is in no face before.
void try_faces(const TurnSurface& ball, std::size_t f, const TurnSurface& socket, std::size_t g,
               Found& found) {
  const TurnFace turning = ball.face(f);
  const TurnFace resting = socket.face(g);
  for_each_first_corner(ball, f, [&](const Vec3& x) { try_ball_point(x, resting, found); });
  for_each_first_corner(socket, g, [&](const Vec3& y) { try_socket_point(y, turning, found); });
  for_each_first_side(ball, f, [&](const TurnEdge& a) {
    for_each_first_side(socket, g, [&](const TurnEdge& b) { try_edges(a, b, found); });
  });
}

}  // namespace

std::string_view name(ContactKind kind) {
  switch (kind) {
    case ContactKind::ball_vertex:
      return "ball vertex";
    case ContactKind::socket_vertex:
      return "socket vertex";
    case ContactKind::edges:
      return "edges";
    case ContactKind::rims:
      break;
  }
  return "rims";
}

TurnContacts::TurnContacts(const TurnScene& scene)
    : rotation_(rotation_to_z(scene.axis)),
      ball_(scene.ball.mesh, scene.ball.parts, rotation_ * scene.ball.before, {WallSide::within, 0.0}),
      socket_(scene.socket.mesh, scene.socket.parts, rotation_ * scene.socket.before,
              {WallSide::beyond, ball_.largest_radius + scene.largest_gap}),
      tolerance_(kTolerance * std::max(ball_.largest_radius, socket_.largest_radius)),
      body_(scene.body),
      ball_faces_(ball_.tree(tolerance_)),
      socket_faces_(socket_.tree(tolerance_)) {}

std::optional<TurnContact> TurnContacts::first(const AngleSpan& angles) const {
  Found found{{angles, tolerance_}, {}};
  visit_meetings(ball_faces_, socket_faces_, angles.from, found.search.first(),
                 [&](std::uint32_t f, std::uint32_t g) {
                   try_faces(ball_, f, socket_, g, found);
                   return found.search.first();
                 });
  return in_mesh_frame(found.contact);
}

std::optional<TurnContact> TurnContacts::first_gap(double gap_mm, const AngleSpan& angles) const {
  Found found{{angles, tolerance_}, {}};
  const auto visit = [&](const TurnTree& ball, const TurnTree& socket, const auto& attempt) {
    visit_meetings(ball, socket, angles.from, found.search.first(), [&](std::uint32_t i, std::uint32_t j) {
      attempt(i, j);
      return found.search.first();
    });
  };
  const auto ball_points = [&](double out, const TurnTree& faces, const auto& face) {
    const Points points = moved_out(ball_, out, 0.0, tolerance_);
    visit(points.tree, faces,
          [&](std::uint32_t x, std::uint32_t f) { try_ball_point(points.places[x], face(f), found); });
  };
  const auto socket_points = [&](double out, double nearest, const TurnTree& faces, const auto& face) {
    const Points points = moved_out(socket_, out, nearest, tolerance_);
    visit(faces, points.tree,
          [&](std::uint32_t f, std::uint32_t y) { try_socket_point(points.places[y], face(f), found); });
  };
  const auto ball_face = [&](std::uint32_t f) { return ball_.face(f); };
  const auto socket_face = [&](std::uint32_t f) { return socket_.face(f); };
  const double half_way = 0.5 * ball_.smallest_radius;
  ball_points(gap_mm, socket_faces_, socket_face);
  socket_points(-gap_mm, half_way, ball_faces_, ball_face);
  ball_points(gap_mm, tree_of_walls(socket_.walls, tolerance_),
              [&](std::uint32_t f) { return socket_.walls[f]; });
  socket_points(-gap_mm, half_way, tree_of_walls(ball_.walls, tolerance_),
                [&](std::uint32_t f) { return ball_.walls[f]; });
  return in_mesh_frame(found.contact);
}

std::optional<TurnContact> TurnContacts::in_mesh_frame(const std::optional<TurnContact>& found) const {
  if (!found) return found;
  return TurnContact{found->angle, found->kind, rotation_.transpose() * found->place,
                     rotation_.transpose() * found->normal, body_};
}

}  // namespace impinge
