// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/turn_contact.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "motion/part_distance.hpp"
#include "motion/sinusoid.hpp"

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

// The piece of its ray within a gap of a point.
TurnEdge along_ray(const Vec3& x, double gap) {
  const double length = x.norm();
  return {std::max(length - gap, 0.0) / length * x, (length + gap) / length * x};
}

// Vertices, moved out by `out` mm but not nearer to the centre than `nearest`, as boxes with this margin.
struct Points {
  const std::vector<Vec3>& vertices;
  double out;
  double margin;
  double nearest;
};

// Calls attempt(point, part) for each part that a point may meet.
template <class Try>
void try_points(const Points& points, const ProfileIndex& parts, const Try& attempt) {
  for (const Vec3& vertex : points.vertices) {
    const double length = vertex.norm();
    if (length == 0.0) continue;
    const Vec3 x = std::max(length + points.out, points.nearest) / length * vertex;
    parts.visit(profile_of(x, points.margin), [&](std::uint32_t part) { attempt(x, part); });
  }
}

auto ball_point(const std::vector<TurnFace>& faces, Found& found) {
  return [&](const Vec3& x, std::uint32_t f) { try_ball_point(x, faces[f], found); };
}

auto socket_point(const std::vector<TurnFace>& faces, Found& found) {
  return [&](const Vec3& y, std::uint32_t f) { try_socket_point(y, faces[f], found); };
}

std::vector<ProfileBox> boxes_of(const std::vector<TurnFace>& faces, double margin) {
  std::vector<ProfileBox> boxes;
  boxes.reserve(faces.size());
  for (const TurnFace& face : faces)
    boxes.push_back(profile_of(face.corner[0], face.corner[1], face.corner[2], margin + face.doubt));
  return boxes;
}

std::vector<ProfileBox> boxes_of(const std::vector<TurnEdge>& edges, double margin) {
  std::vector<ProfileBox> boxes;
  boxes.reserve(edges.size());
  for (const TurnEdge& edge : edges) boxes.push_back(profile_of(edge.from, edge.to, margin));
  return boxes;
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

// A point that is moved along its ray by a gap changes its radius by that, and its height by no more.
TurnContacts::TurnContacts(const TurnScene& scene)
    : rotation_(rotation_to_z(scene.axis)),
      ball_(turn_surface(scene.ball.mesh, scene.ball.parts, rotation_ * scene.ball.before,
                         {WallSide::within, 0.0})),
      socket_(turn_surface(scene.socket.mesh, scene.socket.parts, rotation_ * scene.socket.before,
                           {WallSide::beyond, ball_.largest_radius + scene.largest_gap})),
      tolerance_(kTolerance * std::max(ball_.largest_radius, socket_.largest_radius)),
      body_(scene.body) {
  const double margin = scene.largest_gap + tolerance_;
  const ProfileBox ball_reach = bounds_of(boxes_of(ball_.faces, margin));
  const ProfileBox socket_reach = bounds_of(boxes_of(socket_.faces, margin));
  ball_index_.emplace(index(ball_, socket_reach));
  socket_index_.emplace(index(socket_, ball_reach));
}

TurnContacts::Indices TurnContacts::index(const TurnSurface& surface, const ProfileBox& within) const {
  return {{boxes_of(surface.faces, tolerance_), within},
          {boxes_of(surface.edges, tolerance_), within},
          {boxes_of(surface.walls, tolerance_), within}};
}

std::optional<TurnContact> TurnContacts::first(const AngleSpan& angles) const {
  Found found{{angles, tolerance_}, {}};
  try_points({ball_.vertices, 0.0, tolerance_, 0.0}, socket_index_->faces, ball_point(socket_.faces, found));
  try_points({socket_.vertices, 0.0, tolerance_, 0.0}, ball_index_->faces, socket_point(ball_.faces, found));
  try_points({ball_.rim_vertices, 0.0, tolerance_, 0.0}, socket_index_->walls,
             ball_point(socket_.walls, found));
  try_points({socket_.rim_vertices, 0.0, tolerance_, 0.0}, ball_index_->walls,
             socket_point(ball_.walls, found));
  for (const TurnEdge& edge : ball_.edges) {
    socket_index_->edges.visit(profile_of(edge.from, edge.to, tolerance_),
                               [&](std::uint32_t e) { try_edges(edge, socket_.edges[e], found); });
  }
  return in_mesh_frame(found.contact);
}

std::optional<TurnContact> TurnContacts::first_gap(double gap_mm, const AngleSpan& angles) const {
  Found found{{angles, tolerance_}, {}};
  const Points ball{ball_.vertices, gap_mm, tolerance_, 0.0};
  const Points socket{socket_.vertices, -gap_mm, tolerance_, 0.5 * ball_.smallest_radius};
  try_points(ball, socket_index_->faces, ball_point(socket_.faces, found));
  try_points(ball, socket_index_->walls, ball_point(socket_.walls, found));
  try_points(socket, ball_index_->faces, socket_point(ball_.faces, found));
  try_points(socket, ball_index_->walls, socket_point(ball_.walls, found));
  if (body_ != std::array<std::size_t, 2>{}) {
    const Points within{ball_.vertices, -gap_mm, tolerance_, 0.0};
    const Points beyond{socket_.vertices, gap_mm, tolerance_, 0.0};
    try_points(within, socket_index_->faces, ball_point(socket_.faces, found));
    try_points(beyond, ball_index_->faces, socket_point(ball_.faces, found));
    const auto try_rays = [&](const TurnSurface& of, const ProfileIndex& edges, const auto& attempt) {
      for (const Vec3& x : of.vertices) {
        if (x.isZero(0.0)) continue;
        const TurnEdge ray = along_ray(x, gap_mm);
        edges.visit(profile_of(ray.from, ray.to, tolerance_), [&](std::uint32_t e) { attempt(ray, e); });
      }
    };
    try_rays(ball_, socket_index_->edges,
             [&](const TurnEdge& ray, std::uint32_t e) { try_edges(ray, socket_.edges[e], found); });
    try_rays(socket_, ball_index_->edges,
             [&](const TurnEdge& ray, std::uint32_t e) { try_edges(ball_.edges[e], ray, found); });
  }
  return in_mesh_frame(found.contact);
}

std::optional<TurnContact> TurnContacts::in_mesh_frame(const std::optional<TurnContact>& found) const {
  if (!found) return found;
  return TurnContact{found->angle, found->kind, rotation_.transpose() * found->place,
                     rotation_.transpose() * found->normal, body_};
}

}  // namespace impinge
