// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/body_pairs.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/collinear.hpp"
#include "mesh/meeting_faces.hpp"
#include "mesh/triangle_distance.hpp"

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

bool surfaces_meet(const SweptParts& ball, const SweptParts& socket, const Pose& pose) {
  if (ball.nodes().empty() || socket.nodes().empty()) return false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pending{{0, 0}};
  while (!pending.empty()) {
    const auto [p, q] = pending.back();
    pending.pop_back();
    const SweptParts::Node& a = ball.nodes()[p];
    const SweptParts::Node& b = socket.nodes()[q];
    const double reach = a.radius + b.radius;
    const double slack = kNodeRounding * (reach + a.centre.norm() + b.centre.norm());
    if ((to_socket(pose, a.centre) - b.centre).norm() > reach + slack) continue;
    if (a.leaf && b.leaf) {
      Triangle moved = ball.parts()[a.at].corner;
      for (Vec3& x : moved) x = to_socket(pose, x);
      if (faces_meet(moved, socket.parts()[b.at].corner)) return true;
      continue;
    }
    const bool open_a = b.leaf || (!a.leaf && a.radius >= b.radius);
    for (std::uint32_t k = 0; k < 2; ++k) pending.emplace_back(open_a ? a.at + k : p, open_a ? q : b.at + k);
  }
  return false;
}

bool is_closed(const TriangleMesh& mesh) { return boundary_edges(mesh).empty(); }

}  // namespace

BodyPairs::Body::Body(TriangleMesh of, bool main, bool ball)
    : mesh(std::move(of)), parts(without_walls(mesh)), faces(faces_with_area(mesh)) {
  if (faces.nodes().empty()) return;
  const SweptParts::Node& all = faces.nodes().front();
  about_centre = main;
  anchor_inside = main && ball;
  anchored = anchor_inside || is_closed(mesh);
  anchor = main ? kBesideCentre : Vec3(all.centre + 2.0 * all.radius * kOutside);
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
  ball_.push_back(std::make_unique<Body>(main.ball, true, true));
  socket_.push_back(std::make_unique<Body>(main.socket, true, false));
  for (const TriangleMesh& part : beside.ball) ball_.push_back(std::make_unique<Body>(part, false, true));
  for (const TriangleMesh& part : beside.socket)
    socket_.push_back(std::make_unique<Body>(part, false, false));
  for (std::size_t b = 0; b < ball_.size(); ++b) {
    for (std::size_t s = b == 0 ? 1 : 0; s < socket_.size(); ++s) pairs_.push_back({b, s});
  }
}

// Calls found(body, x), x a vertex of the other one in its frame, until it returns true.
template <class Found>
bool BodyPairs::any_vertex(const Pose& pose, const Found& found) const {
  return std::ranges::any_of(pairs_, [&](const Pair& pair) {
    const Body& ball = *ball_[pair.ball];
    const Body& socket = *socket_[pair.socket];
    return std::ranges::any_of(
               ball.parts.vertices,
               [&](VertexIndex v) { return found(socket, to_socket(pose, ball.mesh.vertices[v])); }) ||
           std::ranges::any_of(socket.parts.vertices, [&](VertexIndex v) {
             return found(ball, to_ball(pose, socket.mesh.vertices[v]));
           });
  });
}

bool BodyPairs::impinged(const Pose& pose) const {
  return std::ranges::any_of(pairs_,
                             [&](const Pair& pair) {
                               return surfaces_meet(ball_[pair.ball]->faces, socket_[pair.socket]->faces,
                                                    pose);
                             }) ||
         any_vertex(pose, [](const Body& body, const Vec3& x) { return body.holds(x); });
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

bool BodyPairs::vertex_inside_by(const Pose& pose, double depth_mm) const {
  return any_vertex(pose, [depth_mm](const Body& body, const Vec3& x) {
    return body.holds(x) && body.faces.farther_than(depth_mm, x);
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
                               const WithinSpan& within, double largest) const {
  for (const Pair& pair : pairs_)
    largest = impinge::first_within(ball_[pair.ball]->faces.rotated(ball),
                                    socket_[pair.socket]->faces.rotated(socket), within, largest);
  return largest;
}

}  // namespace impinge
