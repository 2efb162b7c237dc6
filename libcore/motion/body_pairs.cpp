// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/body_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/collinear.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/meeting_faces.hpp"
#include "mesh/triangle_distance.hpp"
#include "motion/part_distance.hpp"

namespace impinge {
namespace {

constexpr double kNodeRounding = 1e-9;  // of lengths
// Where a segment from a point ends, off every edge and vertex of usual meshes: beside the centre, and
// outside.
const Vec3 kBesideCentre(1.3e-3, -0.7e-3, 0.9e-3);  // mm
const Vec3 kOutside(0.47311, -0.28713, 0.83291);    // of more than the size

std::vector<TurnFace> faces_with_area(const TriangleMesh& mesh) {
  std::vector<TurnFace> faces;
  for (const Face& face : mesh.faces) {
    const auto [a, b, c] = corners_of(mesh, face);
    if (!collinear(a, b, c)) faces.push_back(turn_face(a, b, c));
  }
  return faces;
}

TurnParts without_walls(const TriangleMesh& mesh) {
  TurnParts parts(mesh);
  parts.jumps.clear();
  parts.rim_vertices.clear();
  return parts;
}

// Calls visit(triangle) for those near the segment until it returns true.
template <class Visit>
bool visit_near(const SweptParts& faces, const Vec3& from, const Vec3& to, const Visit& visit) {
  std::vector<std::uint32_t> pending;
  if (!faces.nodes().empty()) pending.push_back(0);
  while (!pending.empty()) {
    const SweptParts::Node& node = faces.nodes()[pending.back()];
    pending.pop_back();
    const double reach = node.radius + kNodeRounding * (node.centre.norm() + node.radius);
    if (squared_distance_to_segment(node.centre, from, to) > reach * reach) continue;
    if (!node.leaf)
      pending.insert(pending.end(), {node.at, node.at + 1});
    else if (visit(faces.parts()[node.at].corner))
      return true;
  }
  return false;
}

// Is meet(a, b) true of two triangles? Nodes of which apart(a, b) is true are not opened.
template <class Apart, class Meet>
bool any_pair(const SweptParts& ball, const SweptParts& socket, const Apart& apart, const Meet& meet) {
  if (ball.nodes().empty() || socket.nodes().empty()) return false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pending{{0, 0}};
  while (!pending.empty()) {
    const auto [p, q] = pending.back();
    pending.pop_back();
    const SweptParts::Node& a = ball.nodes()[p];
    const SweptParts::Node& b = socket.nodes()[q];
    if (apart(a, b)) continue;
    if (a.leaf && b.leaf) {
      if (meet(a, b)) return true;
      continue;
    }
    const bool open_a = b.leaf || (!a.leaf && a.radius >= b.radius);
    for (std::uint32_t k = 0; k < 2; ++k) pending.emplace_back(open_a ? a.at + k : p, open_a ? q : b.at + k);
  }
  return false;
}

bool surfaces_meet(const SweptParts& ball, const SweptParts& socket, const Pose& pose) {
  const auto apart = [&](const SweptParts::Node& a, const SweptParts::Node& b) {
    const double reach = a.radius + b.radius;
    const double slack = kNodeRounding * (reach + a.centre.norm() + b.centre.norm());
    return (to_socket(pose, a.centre) - b.centre).norm() > reach + slack;
  };
  return any_pair(ball, socket, apart, [&](const SweptParts::Node& a, const SweptParts::Node& b) {
    Triangle moved = ball.parts()[a.at].corner;
    for (Vec3& x : moved) x = to_socket(pose, x);
    return faces_meet(moved, socket.parts()[b.at].corner);
  });
}

// May a point of one come within reach of a point of the other? `reach(r)` is of points r from the centre,
// and `shift` what may take points to another distance from it.
template <class Reach>
bool may_come_near(const SweptParts& ball, const SweptParts& socket, const Eigen::Matrix3d& rotation,
                   double shift, const Reach& reach) {
  const auto slack = [](const SweptParts::Node& a, const SweptParts::Node& b) {
    return kNodeRounding * (a.farthest + b.farthest);
  };
  const auto near = [&](const SweptParts::Node& a, const SweptParts::Node& b) {
    return reach(std::min(a.farthest, b.farthest + shift)) + slack(a, b);
  };
  const auto apart = [&](const SweptParts::Node& a, const SweptParts::Node& b) {
    return std::max(a.nearest - b.farthest, b.nearest - a.farthest) > shift + slack(a, b) ||
           (rotation * a.centre - b.centre).norm() > a.radius + b.radius + near(a, b);
  };
  return any_pair(ball, socket, apart, [&](const SweptParts::Node& a, const SweptParts::Node& b) {
    const auto& [c0, c1, c2] = ball.parts()[a.at].corner;
    const TurnFace moved = turn_face(rotation * c0, rotation * c1, rotation * c2);
    const TurnFace& face = socket.parts()[b.at];
    return !farther_than(moved, face, near(a, b)) || faces_meet(moved.corner, face.corner);
  });
}

// Without those that are there again.
TriangleMesh once(TriangleMesh mesh) {
  std::set<Face> seen;
  std::erase_if(mesh.faces, [&](Face face) {
    std::ranges::sort(face);
    return !seen.insert(face).second;
  });
  return mesh;
}

// Where walls that are counted end: edges of one face, or three.
std::vector<Edge> odd_edges(const TriangleMesh& mesh) {
  std::vector<Edge> odd;
  for_each_edge(mesh, [&](std::span<const HalfEdge> half_edges) {
    if (half_edges.size() % 2 == 1) odd.push_back(ends(mesh, half_edges[0]));
  });
  return odd;
}

// From these edges away from beside the centre, to farther than all bodies.
std::vector<TurnFace> walls_beyond(const TriangleMesh& mesh, std::span<const Edge> from, double farthest) {
  std::vector<TurnFace> walls;
  for (const auto& [first, last] : from) {
    const Vec3& a = mesh.vertices[first];
    const Vec3& b = mesh.vertices[last];
    const double middle =
        0.5 * (a.stableNormalized() + b.stableNormalized()).norm();  // how near their chord comes
    const double least = std::max(1e-6, std::min(a.norm(), b.norm()) * middle);
    const double times = std::max(2.0, 4.0 * farthest / least);
    const Vec3 a_far = kBesideCentre + times * (a - kBesideCentre);
    const Vec3 b_far = kBesideCentre + times * (b - kBesideCentre);
    walls.push_back(turn_face(a, b, b_far));
    walls.push_back(turn_face(a, b_far, a_far));
  }
  return walls;
}

}  // namespace

BodyPairs::Body::Body(TriangleMesh of, bool main, bool ball, double farthest)
    : mesh(once(std::move(of))),
      parts(without_walls(mesh)),
      faces(faces_with_area(mesh)),
      beyond(std::vector<TurnFace>{}) {
  find_pieces();
  if (faces.nodes().empty()) return;
  const SweptParts::Node& all = faces.nodes().front();
  const std::vector<Edge> odd = odd_edges(mesh);
  about_centre = main;
  anchor_inside = main && ball;
  anchored = anchor_inside || odd.empty();
  anchor = main ? kBesideCentre : Vec3(all.centre + 2.0 * all.radius * kOutside);
  if (!anchor_inside) return;
  for (const Edge& edge : odd) {
    for (const VertexIndex v : edge) stretch = std::max(stretch, farthest / mesh.vertices[v].norm());
  }
  const std::vector<TurnFace> walls = walls_beyond(mesh, odd, farthest);
  for (const TurnFace& wall : walls) {
    const auto next = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), wall.corner.begin(), wall.corner.end());
    mesh.faces.push_back({next, next + 1, next + 2});
  }
  beyond = SweptParts(walls);
  parts = without_walls(mesh);
}

void BodyPairs::Body::find_pieces() {
  DisjointSets sets(mesh.vertices.size());
  std::vector<bool> seen(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces) {
    const auto [a, b, c] = corners_of(mesh, face);
    if (collinear(a, b, c)) continue;
    for (const VertexIndex v : face) {
      sets.join(face[0], v, false);
      seen[v] = true;
    }
  }
  for (const VertexIndex v : parts.vertices) {
    if (!seen[v])
      loose.push_back(mesh.vertices[v]);
    else if (sets.find(v).root == v)
      pieces.push_back(mesh.vertices[v]);
  }
}

// The walls between the point and the anchor are counted.
bool BodyPairs::Body::holds(const Vec3& x) const {
  if (!anchored || (!about_centre && (x - faces.nodes()[0].centre).norm() > faces.nodes()[0].radius))
    return false;
  bool inside = anchor_inside;
  visit_near(faces, x, anchor, [&](const Triangle& face) {
    if (meets_segment(face, x, anchor)) inside = !inside;
    return false;
  });
  return inside;
}

BodyPairs::BodyPairs(const BallSocketPair& main, const BoneParts& beside) {
  if (beside.ball.empty() && beside.socket.empty()) return;
  double farthest = 0.0;
  const auto reach_to = [&](const TriangleMesh& mesh) {
    for (const Vec3& x : mesh.vertices) farthest = std::max(farthest, x.norm());
  };
  for (const TriangleMesh* mesh : {&main.ball, &main.socket}) reach_to(*mesh);
  for (const auto* parts : {&beside.ball, &beside.socket}) {
    for (const TriangleMesh& part : *parts) reach_to(part);
  }
  const auto add = [&](auto& bodies, const TriangleMesh& mesh, bool is_main, bool is_ball) {
    bodies.push_back(std::make_unique<Body>(mesh, is_main, is_ball, farthest));
  };
  add(ball_, main.ball, true, true);
  add(socket_, main.socket, true, false);
  for (const TriangleMesh& part : beside.ball) add(ball_, part, false, true);
  for (const TriangleMesh& part : beside.socket) add(socket_, part, false, false);
  for (std::size_t b = 0; b < ball_.size(); ++b) {
    for (std::size_t s = b == 0 ? 1 : 0; s < socket_.size(); ++s) pairs_.push_back({b, s});
  }
}

// Calls found(body, x), x a vertex of the other one in its frame, until it returns true.
template <class Found>
bool BodyPairs::any_vertex_of(const Pair& pair, const Pose& pose, const Found& found) const {
  const Body& ball = *ball_[pair.ball];
  const Body& socket = *socket_[pair.socket];
  return std::ranges::any_of(
             ball.parts.vertices,
             [&](VertexIndex v) { return found(socket, to_socket(pose, ball.mesh.vertices[v])); }) ||
         std::ranges::any_of(socket.parts.vertices, [&](VertexIndex v) {
           return found(ball, to_ball(pose, socket.mesh.vertices[v]));
         });
}

template <class Found>
bool BodyPairs::any_vertex(const Pose& pose, const Found& found) const {
  return std::ranges::any_of(pairs_, [&](const Pair& pair) { return any_vertex_of(pair, pose, found); });
}

bool BodyPairs::touch(const Pair& pair, const Pose& pose) const {
  return surfaces_meet(ball_[pair.ball]->faces, socket_[pair.socket]->faces, pose) ||
         any_vertex_of(pair, pose, [](const Body& body, const Vec3& x) { return body.holds(x); });
}

bool BodyPairs::impinged(const Pose& pose) const {
  return std::ranges::any_of(pairs_, [&](const Pair& pair) { return touch(pair, pose); });
}

std::optional<BodyPairs::Nearest> BodyPairs::nearest(const Pose& pose) const {
  std::optional<Nearest> found;
  for (const Pair& pair : pairs_) {
    if (touch(pair, pose)) return Nearest{pair, 0.0, true};
    double least = found ? found->distance_mm : HUGE_VAL;
    const SweptParts& ball = ball_[pair.ball]->faces;
    const auto apart = [&](const SweptParts::Node& a, const SweptParts::Node& b) {
      const double spheres = (to_socket(pose, a.centre) - b.centre).norm() - a.radius - b.radius;
      return spheres > least + kNodeRounding * (a.farthest + b.farthest);
    };
    const auto measure = [&](const SweptParts::Node& a, const SweptParts::Node& b) {
      const auto& [c0, c1, c2] = ball.parts()[a.at].corner;
      const TurnFace moved = turn_face(to_socket(pose, c0), to_socket(pose, c1), to_socket(pose, c2));
      least = std::min(least, least_distance(moved, socket_[pair.socket]->faces.parts()[b.at]));
      return false;
    };
    any_pair(ball, socket_[pair.socket]->faces, apart, measure);
    if (std::isfinite(least) && (!found || least < found->distance_mm)) found = Nearest{pair, least, false};
  }
  return found;
}

bool BodyPairs::vertex_within(const Pose& pose, double gap_mm) const {
  return any_vertex(pose, [gap_mm](const Body& body, const Vec3& x) {
    const Vec3 reach = gap_mm * x.stableNormalized();
    const Vec3 from = x.norm() > gap_mm ? Vec3(x - reach) : Vec3::Zero();
    const Vec3 to = x + reach;
    return visit_near(body.faces, from, to,
                      [&](const Triangle& face) { return meets_segment(face, from, to); }) ||
           body.holds(x);
  });
}

bool BodyPairs::vertex_inside_by(const Pose& pose, double depth_mm, double centre_mm) const {
  return any_vertex(pose, [&](const Body& body, const Vec3& x) {
    return body.holds(x) && body.faces.farther_than(depth_mm, x) &&
           body.beyond.farther_than(depth_mm + body.stretch * centre_mm, x);
  });
}

double BodyPairs::Moved::reach(double from_centre) const {
  return 2.0 * from_centre * std::sin(0.5 * std::min(poses.turn, kPi)) * (1.0 + kNodeRounding) +
         poses.shift_mm;
}

// x, of this body, is farther from the surface of the other one than the poses take it, by so much.
bool BodyPairs::Moved::is_off(const Body& other, const Vec3& x, double by_mm) const {
  const double near = by_mm + reach(x.norm()) + kNodeRounding * x.norm();
  return other.faces.farther_than(near, rotation * x) &&
         other.beyond.farther_than(near + other.stretch * poses.centre_mm, rotation * x);
}

// x, of this body, is within the gap of the other one in all poses.
bool BodyPairs::Moved::is_near(const Body& other, const Vec3& x) const {
  return other.faces.within(poses.gap_mm - reach(x.norm()) - kNodeRounding * x.norm(), rotation * x);
}

// Where the surfaces are apart.
bool BodyPairs::Moved::may_enter(const Body& other) const {
  const auto holds = [&](const Vec3& x) { return other.holds(rotation * x); };
  return std::ranges::any_of(body.pieces, holds) || std::ranges::any_of(body.loose, [&](const Vec3& x) {
           return holds(x) || !is_off(other, x, poses.gap_mm);
         });
}

bool BodyPairs::Moved::is_within(const Body& other) const {
  const bool may_be = other.anchored || poses.gap_mm > 0.0;
  if (!may_be || body.faces.nodes().empty() || other.faces.nodes().empty()) return false;
  const SweptParts::Node& whole = other.faces.nodes()[0];
  std::vector<std::uint32_t> pending{0};
  while (!pending.empty()) {
    const SweptParts::Node& node = body.faces.nodes()[pending.back()];
    pending.pop_back();
    // A point of the node is at most its radius deeper or nearer than the middle, and has to be deeper than
    // the poses take it, or nearer than the gap by as much.
    const Vec3 middle = rotation * node.centre;
    const double least = reach(node.nearest);
    if (poses.gap_mm <= least && other.faces.within(least - node.radius, middle)) continue;
    const double near = std::max(0.0, node.radius + poses.gap_mm - least);
    if ((middle - whole.centre).norm() > near + whole.radius) continue;
    if (other.faces.farther_than(near, middle) && !other.holds(middle)) continue;  // none is, mostly
    if (!node.leaf) {
      pending.insert(pending.end(), {node.at, node.at + 1});
      continue;
    }
    const Vec3& x = body.faces.parts()[node.at].corner[0];
    if (is_near(other, x) || (is_off(other, x) && other.holds(rotation * x))) return true;
  }
  return false;
}

std::optional<BodyPairs::Pair> BodyPairs::may_meet(const NearPoses& poses) const {
  for (const Pair& pair : pairs_) {
    const Body& ball = *ball_[pair.ball];
    const Body& socket = *socket_[pair.socket];
    const Moved out{ball, poses, poses.rotation};
    const Moved back{socket, poses, poses.rotation.transpose()};
    const double apart = poses.shift_mm + poses.gap_mm;
    const double of_walls = ball.stretch * poses.centre_mm;
    const auto reach = [&](double from_centre) { return out.reach(from_centre) + poses.gap_mm; };
    const auto to_shadow = [&](double from_centre) { return reach(from_centre) + of_walls; };
    const auto near = [&](const SweptParts& of, double shift, const auto& within) {
      return may_come_near(of, socket.faces, poses.rotation, shift, within);
    };
    if (near(ball.faces, apart, reach) || near(ball.beyond, apart + of_walls, to_shadow) ||
        out.may_enter(socket) || back.may_enter(ball))
      return pair;
  }
  return std::nullopt;
}

bool BodyPairs::overlap(const NearPoses& poses) const {
  return std::ranges::any_of(pairs_, [&](const Pair& pair) {
    const Body& ball = *ball_[pair.ball];
    const Body& socket = *socket_[pair.socket];
    const Moved out{ball, poses, poses.rotation};
    const Moved back{socket, poses, poses.rotation.transpose()};
    return out.is_within(socket) || back.is_within(ball);
  });
}

std::vector<TurnContacts> BodyPairs::contacts(const JointTurn& turn, double largest_gap) const {
  std::vector<TurnContacts> found;
  for (const Pair& pair : pairs_) {
    const Body& ball = *ball_[pair.ball];
    const Body& socket = *socket_[pair.socket];
    found.emplace_back(TurnScene{{ball.mesh, ball.parts, turn.inner},
                                 {socket.mesh, socket.parts, turn.outer.transpose()},
                                 turn.axis,
                                 largest_gap,
                                 {pair.ball, pair.socket}});
  }
  return found;
}

double BodyPairs::first_within(const Eigen::Matrix3d& ball, const Eigen::Matrix3d& socket,
                               const WithinSpan& within, double centre_mm, double largest) const {
  for (const Pair& pair : pairs_) {
    const Body& turning = *ball_[pair.ball];
    const SweptParts resting = socket_[pair.socket]->faces.rotated(socket);
    largest = impinge::first_within(turning.faces.rotated(ball), resting, within, largest);
    if (turning.beyond.nodes().empty()) continue;
    const WithinSpan of_walls = [&](const AngleSpan& span) {
      return within(span) + turning.stretch * centre_mm;
    };
    largest = impinge::first_within(turning.beyond.rotated(ball), resting, of_walls, largest);
  }
  return largest;
}

}  // namespace impinge
