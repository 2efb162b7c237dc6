// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/centre_interval.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "limits/centre_walls.hpp"
#include "mesh/surface_vertices.hpp"
#include "mesh/triangle_distance.hpp"
#include "sphere/orientation.hpp"
#include "sphere/plane_side.hpp"

namespace impinge {
namespace {

constexpr double kCertainMargin = 1e-9;  // share of a length that allows for rounding in the upper end
constexpr double kFirstStep = 0.1;       // degrees behind the limit, where the upper end is tried first
constexpr double kLonger = 1.2599210498948732;  // growth of the steps; a deep vertex soon comes out again
constexpr int kHalvings = 5;                    // of the last step
constexpr std::size_t kMostVertices = 40;       // tried in a pose, the deepest first
constexpr double kNear = 5.0;                   // mm: vertices as near to the contact are tried

Pose pose_of(const JointTurn& turn, double angle_deg) {
  const Eigen::AngleAxisd about(angle_deg * kDegree, turn.axis);
  return {turn.outer * about.toRotationMatrix() * turn.inner, Vec3::Zero()};
}

// The least value of a sinusoid in a span of angles.
double least_in(const Sinusoid& f, const AngleSpan& span) {
  const auto at = [&](double t) { return f.cosine * std::cos(t) + f.sine * std::sin(t) + f.constant; };
  double lowest = std::atan2(-f.sine, -f.cosine);
  if (lowest < span.from) lowest += 2.0 * kPi;
  if (lowest >= span.from && lowest <= span.to) return f.constant - std::hypot(f.cosine, f.sine);
  return std::min(at(span.from), at(span.to));
}

// The least angle, radians, between unit u and the arc from a to b that the centre sees.
double angle_to_arc(const Vec3& u, const Vec3& a, const Vec3& b) {
  const Vec3 across = a.cross(b);
  const double ends = std::min(angle_between(u, a), angle_between(u, b));
  const bool beside = a.cross(u).dot(across) > 0.0 && u.cross(b).dot(across) > 0.0;
  return beside ? std::min(ends, std::asin(std::min(1.0, std::abs(across.dot(u)) / across.norm()))) : ends;
}

// Is every jump edge farther than `angle`, radians, from the direction of x?
bool clear_of_jumps(const TriangleMesh& mesh, const std::vector<JumpEdge>& jumps, const Vec3& x,
                    double angle) {
  const Vec3 u = x.stableNormalized();
  return std::ranges::all_of(jumps, [&](const JumpEdge& jump) {
    return angle_to_arc(u, mesh.vertices[jump.from], mesh.vertices[jump.to]) > angle;
  });
}

// The trace of the rotation R from the scan as a function of the angle. A common centre shifts the ball by at
// most r root(3 - tr R).
Sinusoid trace_of(const JointTurn& turn) {
  const Eigen::Matrix3d upright = rotation_to_z(turn.axis);
  const Eigen::Matrix3d m = upright * turn.inner * turn.rest * turn.outer * upright.transpose();
  return {m(0, 0) + m(1, 1), m(0, 1) - m(1, 0), m(2, 2)};
}

// Edges of an odd number of faces. Round any other edge a way crosses an even number of faces.
std::vector<Edge> border_of(const TriangleMesh& mesh) {
  std::vector<Edge> border;
  for_each_edge(mesh, [&](std::span<const HalfEdge> half_edges) {
    if (half_edges.size() % 2 != 0) border.push_back(ends(mesh, half_edges[0]));
  });
  return border;
}

std::vector<TurnFace> points_of(const TriangleMesh& mesh) {
  std::vector<TurnFace> points;
  for (const VertexIndex v : surface_vertices(mesh)) points.push_back(turn_point(mesh.vertices[v]));
  return points;
}

}  // namespace

CentreIntervals::CentreIntervals(const CulledJoint& joint, const SweptParts& ball, const SweptParts& socket,
                                 const CentreQuestion& question, const BodyPairs& bodies)
    : joint_(joint),
      question_(question),
      bodies_(bodies),
      ball_(side(ball, Surface::ball)),
      socket_(side(socket, Surface::socket)) {}

CentreIntervals::Side CentreIntervals::side(const SweptParts& faces, Surface of) const {
  const TriangleMesh& mesh = mesh_of(joint_.meshes(), of);
  const double r = question_.within_mm;
  if (question_.gap_mm == 0.0)
    return {faces, SweptParts(), SweptParts(), jump_edges(mesh), border_of(mesh), 0.0};
  const std::vector<Edge> edges = possible_jumps(mesh, r);
  const TriangleMesh& facing_mesh = mesh_of(joint_.meshes(), other(of));
  const std::vector<VertexIndex> facing = surface_vertices(facing_mesh);
  WallQuestion walls{
      of == Surface::socket, question_.doubt == CentreDoubt::common, r, question_.gap_mm, HUGE_VAL, 0.0};
  for (const VertexIndex v : facing) {
    walls.nearest = std::min(walls.nearest, facing_mesh.vertices[v].norm());
    walls.farthest = std::max(walls.farthest, facing_mesh.vertices[v].norm());
  }
  Side made{faces,
            SweptParts(facing.empty() ? std::vector<TurnFace>{} : shells(mesh, edges, walls)),
            SweptParts(points_of(mesh)),
            jump_edges(mesh),
            border_of(mesh),
            HUGE_VAL};
  for (const TurnFace& face : made.faces.parts()) {
    const auto& [a, b, c] = face.corner;
    made.nearest = std::min(made.nearest, std::sqrt(squared_distance_to_triangle(Vec3::Zero(), a, b, c)));
  }
  return made;
}

double CentreIntervals::low_deg(const JointTurn& turn, double to_deg) const {
  const double nearest = std::min(ball_.nearest, socket_.nearest);
  if (question_.gap_mm > 0.0 && !(nearest > question_.within_mm * (1.0 + kCertainMargin))) return 0.0;
  const Sinusoid trace = trace_of(turn);
  const bool common = question_.doubt == CentreDoubt::common;
  const WithinSpan within = [&](const AngleSpan& span) {
    const double turned = common ? std::sqrt(std::max(0.0, 3.0 - least_in(trace, span))) : 1.0;
    return question_.gap_mm + question_.within_mm * turned;
  };
  const Eigen::Matrix3d upright = rotation_to_z(turn.axis);
  const Eigen::Matrix3d ball = upright * turn.inner;
  const Eigen::Matrix3d socket = upright * turn.outer.transpose();
  double first = to_deg * kDegree;
  if (question_.gap_mm > 0.0) {
    first = first_within({ball_.points, ball, socket_.walls, socket}, within, first);
    first = first_within({ball_.walls, ball, socket_.points, socket}, within, first);
    first = first_within({ball_.faces, ball, socket_.faces, socket}, within, first);
  }
  first = bodies_.first_within(ball, socket, within, first);
  return std::min(first / kDegree, to_deg);
}

// How many faces of the other surface a vertex of the ball at x is beyond, or a vertex of the socket within,
// on its ray; none where the ray meets a side of a face, which would count twice.
std::optional<int> CentreIntervals::layers_passed(const ScannedVertex& at, const Vec3& x) const {
  const NearFaces& faces = joint_.faces(other(at.scanned));
  int passed = 0;
  const bool on_side = faces.any_hit(x, [&](std::uint32_t f, int side) {
    const auto corners = corners_of(faces.mesh(), faces.mesh().faces[f]);
    const int place = place_in_cone(corners, side, x);
    if (place < 0) return false;
    const int beyond = side * plane_side(corners[0], corners[1], corners[2], x);
    passed += at.scanned == Surface::ball ? beyond > 0 : beyond < 0;
    return place == 0;
  });
  return on_side ? std::nullopt : std::optional(passed);
}

// Case (iii) of the theorem that the header names. Up to way.free_deg the vertex crosses nothing. From there
// on, as long as no jump edge comes into its direction, each crossing changes layers_passed() by one, which
// counts the crossings.
bool CentreIntervals::has_crossed(const Way& way, const ScannedVertex& at) const {
  constexpr double kStep = 0.25;    // degrees, along the way
  constexpr double kBeside = 1e-9;  // radians
  const Side& facing = at.scanned == Surface::ball ? socket_ : ball_;
  if (facing.faces.empty()) return false;
  const TriangleMesh& mesh = mesh_of(joint_.meshes(), other(at.scanned));
  const Vec3& from = mesh_of(joint_.meshes(), at.scanned).vertices[at.vertex];
  const auto place = [&](double angle_deg) {
    return to_other(at.scanned, pose_of(way.turn, angle_deg), from);
  };
  const Vec3 end = place(way.angle_deg);
  const double rounding = kCertainMargin * (from.norm() + facing.faces.nodes()[0].farthest);
  const double moved = most_shift(way.turn, way.angle_deg) + rounding;
  if (layers_passed(at, end).value_or(0) % 2 == 0 || layers_passed(at, place(way.free_deg)) != 0 ||
      !facing.faces.farther_than(moved, end) ||
      !facing.faces.farther_than(shift(way.turn, pose_of(way.turn, 0.0)) + rounding, place(0.0)))
    return false;
  const double half = 0.5 * kStep * kDegree * (1.0 + kBeside);
  for (double angle = 0.5 * kStep; angle < way.angle_deg + 0.5 * kStep; angle += kStep) {
    const Vec3 x = place(std::min(angle, way.angle_deg));
    const double near = moved + from.norm() * half;
    for (const Edge& edge : facing.border) {
      if (squared_distance_to_segment(x, mesh.vertices[edge[0]], mesh.vertices[edge[1]]) <= near * near)
        return false;
    }
    if (angle + 0.5 * kStep > way.free_deg && !clear_of_jumps(mesh, facing.jumps, x, half + kBeside))
      return false;
  }
  return true;
}

// The largest shift on all of the way, mm.
double CentreIntervals::most_shift(const JointTurn& turn, double to_deg) const {
  if (question_.doubt == CentreDoubt::play) return question_.within_mm;
  const double least = least_in(trace_of(turn), {0.0, to_deg * kDegree});
  return question_.within_mm * std::sqrt(std::max(0.0, 3.0 - least));
}

// Case (v) of the theorem that the header names, for one vertex; x is its place in the other surface's frame.
bool CentreIntervals::is_certain(const Way& way, const ScannedVertex& at) const {
  const bool of_ball = at.scanned == Surface::ball;
  const Side& facing = of_ball ? socket_ : ball_;
  const BallSocketPair& meshes = joint_.meshes();
  const Vec3 x = to_other(at.scanned, way.pose, mesh_of(meshes, at.scanned).vertices[at.vertex]);
  const double r = question_.within_mm;
  const double length = x.norm() + (of_ball ? question_.gap_mm : -question_.gap_mm);
  if (!(x.norm() > 4.0 * r) || !(length > 4.0 * r)) return false;
  const double rounding = kCertainMargin * (x.norm() + facing.nearest);
  const double moved = way.shift_mm + 2.0 * question_.gap_mm * r / std::min(length, x.norm()) + rounding;
  const double sine = of_ball ? std::max(r, moved) / facing.nearest : (r + moved) / length;
  if (!(sine < 0.5)) return false;
  const Vec3 p = length / x.norm() * x;
  return facing.faces.farther_than(moved, p) &&
         clear_of_jumps(mesh_of(meshes, other(at.scanned)), facing.jumps, p,
                        std::asin(sine) + kCertainMargin);
}

bool CentreIntervals::gap_always(const Way& way) const {
  const double enough = question_.gap_mm - way.shift_mm;
  const auto least = joint_.least_gap(way.pose);
  if (!least || !(least->gap_mm < enough)) return false;
  if (is_certain(way, least->at)) return true;
  std::vector<std::pair<double, ScannedVertex>> deep;
  for (const CulledScan& scan : joint_.scans()) {
    const TriangleMesh& mesh = mesh_of(joint_.meshes(), scan.scanned());
    for (const VertexIndex v : surface_vertices(mesh)) {
      const double gap = joint_.gap(scan.scanned(), to_other(scan.scanned(), way.pose, mesh.vertices[v]));
      if (gap < enough) deep.emplace_back(gap, ScannedVertex{scan.scanned(), v});
    }
  }
  std::ranges::sort(deep, [](const auto& a, const auto& b) { return a.first < b.first; });
  deep.resize(std::min(deep.size(), kMostVertices));
  return std::ranges::any_of(deep, [&](const auto& at) { return is_certain(way, at.second); });
}

// Asks the vertices near the first contact and, if the main bones have no inside, the deepest one.
bool CentreIntervals::contact_always(const Way& way, const NearContact& near) const {
  const double certain = way.shift_mm * (1.0 + kCertainMargin) + kCertainMargin;
  const auto inside = [&](const BodyPairs::Vertex& at) {
    return bodies_.is_inside_by(at, way.pose, certain);
  };
  const auto crossed = [&](const ScannedVertex& at) { return has_crossed(way, at); };
  if (std::ranges::any_of(near.vertices, inside) || std::ranges::any_of(near.scanned, crossed)) return true;
  if (bodies_.has_inside()) return false;
  const auto least = joint_.least_gap(way.pose);
  return least && least->gap_mm < 0.0 && crossed(least->at);
}

CentreIntervals::NearContact CentreIntervals::near_contact(const JointTurn& turn,
                                                           const TurnContact& contact) const {
  const Pose pose = pose_of(turn, contact.angle / kDegree);
  const BodyPairs::Pair pair{contact.body[0], contact.body[1]};
  NearContact near{bodies_.near(pair, pose, contact.place, kNear), {}};
  if (bodies_.has_inside() || contact.body != std::array<std::size_t, 2>{}) return near;
  for (const Surface of : kSurfaces) {
    const TriangleMesh& mesh = mesh_of(joint_.meshes(), of);
    const Vec3 at = of == Surface::ball ? to_ball(pose, contact.place) : contact.place;
    for (const VertexIndex v : surface_vertices(mesh)) {
      if ((mesh.vertices[v] - at).norm() <= kNear) near.scanned.push_back({of, v});
    }
  }
  return near;
}

std::optional<double> CentreIntervals::high_deg(const JointTurn& turn, const CentreLimit& limit) const {
  const NearContact near = limit.contact ? near_contact(turn, *limit.contact) : NearContact{};
  const auto ask = [&](double angle_deg) {
    const Pose pose = pose_of(turn, angle_deg);
    const Way way{turn, limit.low_deg, angle_deg, pose, shift(turn, pose)};
    return contact_always(way, near) || (question_.gap_mm > 0.0 && gap_always(way));
  };
  double before = limit.high_deg;
  if (ask(before)) return before;
  for (double step = kFirstStep; before < limit.largest_deg; step *= kLonger) {
    double at = std::min(limit.high_deg + step, limit.largest_deg);
    if (ask(at)) {
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (before + at);
        (ask(middle) ? at : before) = middle;
      }
      return at;
    }
    before = at;
  }
  return std::nullopt;
}

double CentreIntervals::shift(const JointTurn& turn, const Pose& pose) const {
  if (question_.doubt == CentreDoubt::play) return question_.within_mm;
  return question_.within_mm * std::sqrt(std::max(0.0, 3.0 - (pose.rotation * turn.rest).trace()));
}

}  // namespace impinge
