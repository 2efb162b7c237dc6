// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/turn_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "contact/part_distance.hpp"
#include "mesh/edges.hpp"
#include "mesh/surface_vertices.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

// Share of the largest radius R that is above what rounding may hide. With u = 2^-53: to turn vertices to the
// frame of the axis and by the angle changes them by 20 u R each, and so does a rounded pose; distances of
// parts that are not thin are right to 24 u D / 1e-2, D <= 2 R, others are not above the true ones
// (contact/part_distance.hpp). Together 4920 u R = 6e-13 R. A sinusoid's coefficients are right to 20 u R
// times the lengths that it is a product of. turn_contact.gappa.
constexpr double kTolerance = 1e-12;
constexpr double kWithin = 4.0;        // times the tolerance: how near parts are that a search has to see
constexpr int kMostAdvances = 10'000;  // for a pair of parts in a span of angles; then they count as touching

// How a pair of parts is asked about. |f| <= bound * d whenever the parts are within the distance d of each
// other. `arm` is the largest distance of the turning part from the axis. `doubt`, mm, is added to the
// tolerance: a wall has 64 u / q of its reach, q the ratio of the least to the largest distance of its edge
// from the centre.
struct Pair {
  const Sinusoid& f;
  double bound;
  double arm;
  double doubt;
};

// Looks for the first angle at which two parts are within twice the tolerance of each other.
class Search {
 public:
  Search(const AngleSpan& angles, double tolerance) : angles_(angles), tolerance_(tolerance) {}

  // distance(t) is the distance of the parts, mm. Has an earlier angle been found?
  template <class Distance>
  bool improve(const Pair& pair, const Distance& distance) {
    const double tolerance = tolerance_ + pair.doubt;
    bool found = false;
    for (const AngleSpan& span : near_zero(pair.f, 2.0 * pair.bound * tolerance)) {
      const AngleSpan part{std::max(span.from, angles_.from), std::min(span.to, angles_.to)};
      int steps = kMostAdvances;
      // No point comes nearer by more than its arm times the angle: nothing touches in this step.
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

// The contact found so far, in the frame of the axis.
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
  if (!(squared > 0.0))  // parallel: the normal is the way from one to the other
    return found.note(ContactKind::edges, socket.from, b.cross(between.cross(b)));
  const double share = between.cross(along).dot(b.cross(along)) / squared;
  found.note(ContactKind::edges, socket.from + std::clamp(share, 0.0, 1.0) * b, across);
}

// A face as the frame of the axis has it.
TurnFace face_in(const Eigen::Matrix3d& frame, const SweptParts& parts, std::uint32_t node) {
  return turned_by(frame, parts.parts()[parts.nodes()[node].at]);
}

// Two faces. Corners and sides are left to the first face that has them.
void try_faces(const TurnScene& scene, std::uint32_t f, const TurnFace& turning, std::uint32_t g,
               const TurnFace& resting, Found& found) {
  const auto& ball_corner = scene.ball.first_corner[f];
  const auto& socket_corner = scene.socket.first_corner[g];
  const auto& ball_side = scene.ball.first_side[f];
  const auto& socket_side = scene.socket.first_side[g];
  for (std::size_t k = 0; k < 3; ++k) {
    if (ball_corner[k]) try_ball_point(turning.corner[k], resting, found);
    if (socket_corner[k]) try_socket_point(resting.corner[k], turning, found);
    for (std::size_t l = 0; l < 3 && ball_side[k]; ++l) {
      if (socket_side[l])
        try_edges({turning.corner[k], turning.corner[(k + 1) % 3]},
                  {resting.corner[l], resting.corner[(l + 1) % 3]}, found);
    }
  }
}

struct Frames {
  explicit Frames(const JointTurn& turn)
      : upright(rotation_to_z(turn.axis)),
        ball(upright * turn.inner),
        socket(upright * turn.outer.transpose()) {}
  Eigen::Matrix3d upright;  // takes the axis to +z
  Eigen::Matrix3d ball;
  Eigen::Matrix3d socket;
};

double tolerance_of(const SweptParts& ball, const SweptParts& socket) {
  double farthest = 0.0;
  for (const SweptParts* faces : {&ball, &socket}) {
    if (!faces->empty()) farthest = std::max(farthest, faces->nodes()[0].farthest);
  }
  return kTolerance * farthest;
}

std::optional<TurnContact> in_axis_frame(const Frames& frames, std::optional<TurnContact> found) {
  if (!found) return found;
  const Vec3 place = frames.upright.transpose() * found->place;
  const Vec3 normal = frames.upright.transpose() * found->normal;
  found->place = place;
  found->normal = normal;
  return found;
}

// The vertices, each moved outwards along its ray by `out` mm, but to no less than `nearest` from the centre.
SweptParts moved_out(const TriangleMesh& mesh, double out, double nearest) {
  std::vector<TurnFace> points;
  for (const VertexIndex v : surface_vertices(mesh)) {
    const Vec3& x = mesh.vertices[v];
    const double r = x.norm();
    if (r > 0.0) points.push_back(turn_point(std::max(r + out, nearest) / r * x));
  }
  return SweptParts(std::move(points));
}

}  // namespace

TurnBody::TurnBody(const TriangleMesh& mesh)
    : faces(turn_faces(mesh)),
      first_corner(mesh.faces.size(), {false, false, false}),
      first_side(mesh.faces.size(), {false, false, false}) {
  std::vector<bool> seen(mesh.vertices.size(), false);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex v = mesh.faces[f][k];
      first_corner[f][k] = !seen[v];
      seen[v] = true;
    }
  }
  for_each_edge(mesh, [&](std::span<const HalfEdge> half_edges) {
    first_side[half_edges[0].face][half_edges[0].side] = true;
  });
}

std::optional<TurnContact> first_contact(const TurnScene& scene, const AngleSpan& angles) {
  const Frames frames(scene.turn);
  const SweptParts& ball = scene.ball.faces;
  const SweptParts& socket = scene.socket.faces;
  const double tolerance = tolerance_of(ball, socket);
  Found found{{angles, tolerance}, {}};
  visit_meetings(
      {ball, frames.ball, socket, frames.socket}, angles.from, angles.to,
      [&](double) { return kWithin * tolerance; },
      [&](std::uint32_t a, std::uint32_t b) {
        try_faces(scene, ball.nodes()[a].at, face_in(frames.ball, ball, a), socket.nodes()[b].at,
                  face_in(frames.socket, socket, b), found);
        return found.search.first();
      });
  return in_axis_frame(frames, found.contact);
}

TurnGap::TurnGap(const BallSocketPair& meshes, double gap)
    : gap_mm(gap), ball_points(moved_out(meshes.ball, gap, 0.0)) {
  double nearest = HUGE_VAL;
  for (const Face& face : meshes.ball.faces) {
    const auto [a, b, c] = corners_of(meshes.ball, face);
    nearest = std::min(nearest, squared_distance_to_triangle(Vec3::Zero(), a, b, c));
  }
  socket_points = moved_out(meshes.socket, -gap, 0.5 * std::sqrt(nearest));
  double farthest = 0.0;
  for (const VertexIndex v : surface_vertices(meshes.ball))
    farthest = std::max(farthest, meshes.ball.vertices[v].norm());
  ball_walls = SweptParts(walls_within(meshes.ball, jump_edges(meshes.ball)));
  socket_walls = SweptParts(walls_beyond(meshes.socket, jump_edges(meshes.socket), farthest + gap));
}

std::optional<TurnContact> first_gap(const SweptParts& ball, const SweptParts& socket, const JointTurn& turn,
                                     const TurnGap& gap, const AngleSpan& angles) {
  const Frames frames(turn);
  const double tolerance = tolerance_of(ball, socket);
  const auto within = [&](double) { return kWithin * tolerance; };
  Found found{{angles, tolerance}, {}};
  for (const SweptParts* faces : {&socket, &gap.socket_walls}) {
    visit_meetings({gap.ball_points, frames.ball, *faces, frames.socket}, angles.from, found.search.first(),
                   within, [&](std::uint32_t a, std::uint32_t b) {
                     try_ball_point(face_in(frames.ball, gap.ball_points, a).corner[0],
                                    face_in(frames.socket, *faces, b), found);
                     return found.search.first();
                   });
  }
  for (const SweptParts* faces : {&ball, &gap.ball_walls}) {
    visit_meetings({*faces, frames.ball, gap.socket_points, frames.socket}, angles.from, found.search.first(),
                   within, [&](std::uint32_t a, std::uint32_t b) {
                     try_socket_point(face_in(frames.socket, gap.socket_points, b).corner[0],
                                      face_in(frames.ball, *faces, a), found);
                     return found.search.first();
                   });
  }
  return in_axis_frame(frames, found.contact);
}

}  // namespace impinge
