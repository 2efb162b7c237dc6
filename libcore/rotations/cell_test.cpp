// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/cell_test.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>

#include "files/formatted.hpp"
#include "files/thread_team.hpp"
#include "mesh/surface_vertices.hpp"
#include "rotations/cap_search.hpp"

namespace impinge {
namespace {

constexpr double kTolerance = CellTest::kTolerance;
constexpr double kTurnSlack = CellTest::kTurnSlack;

constexpr std::uint32_t kCoarsestPart = 6;      // cells from this level on are taken apart
constexpr std::uint32_t kCoarsestOfBodies = 5;  // the same level where bones have an inside
constexpr std::uint32_t kCoarsestBlocked = 3;   // and that for blocked parts of these
constexpr std::uint32_t kFinestPart = 10;       // beyond this level planes in floats are too coarse
constexpr std::size_t kMostWitnesses = 4;    // vertices, or points of bodies, that may block part of a cell
constexpr std::size_t kMostBlocked = 6;      // blocked half-spaces of a cell
constexpr std::uint32_t kUnnamed = 0xffffU;  // number of a plane that only bounds a piece
constexpr double kLeastGain = 0.05;          // a half-space that reaches less far, in half sides, is left out
constexpr double kLeastSlope = 1e-3;         // least share of a normal across a direction, as a divisor
constexpr double kLeastNormal = 1e-9;        // mm^2, least cross product of two edges
constexpr std::size_t kMostPairs = 4000;     // pairs of faces in a cell
constexpr std::size_t kMostClose = 10000;    // pairs of faces of bodies in a cell
constexpr double kLeastFree = 0.3;           // a smaller share of a cell is not worth its time

// A question for faces that come near a cap and are, somewhere, at least `least` from the centre.
struct NearCap {
  Eigen::Vector3f axis;
  float radius;  // radians
  float least;   // mm
};

// Which nodes of a block may hold such faces? In floats, for which the slack of nodes allows.
std::array<std::int32_t, CapBlock::kLanes> near_nodes(const CapBlock& block, const NearCap& cap) {
  std::array<std::int32_t, CapBlock::kLanes> near;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const float x = block.x[k] - cap.axis.x();
    const float y = block.y[k] - cap.axis.y();
    const float z = block.z[k] - cap.axis.z();
    const float room = cap.radius + block.angle[k];
    const bool is = x * x + y * y + z * z <= room * room;
    near[k] = static_cast<std::int32_t>(is) & static_cast<std::int32_t>(block.high[k] >= cap.least);
  }
  return near;
}

// Calls found(face) for faces of a tree that come near the cap until it is true; returns whether it was.
template <class Found>
bool any_near(const CapTree& faces, const NearCap& cap, const Found& found) {
  PendingBlocks pending;
  pending.push(0);
  while (pending.count > 0) {
    const CapBlock& block = faces.blocks()[pending.pop()];
    const auto may_hold = near_nodes(block, cap);
    for (std::size_t k = 0; k < block.nodes; ++k) {
      if (may_hold[k] == 0) continue;
      if (!block.leaf(k)) pending.push(block.first[k]);
      for (std::uint32_t f = block.first[k]; f < block.first[k] + block.items[k]; ++f)
        if (found(f)) return true;
    }
  }
  return false;
}

// The mesh with every corner moved out along its ray, so that each face is moved out by the gap at least
// (theorem in the header, (iii)). Edge-on faces that do not count are left out first, as rounding may make
// others edge-on afterwards.
TriangleMesh moved_out(const TriangleMesh& of, const CellQuestion& question) {
  const double gap = question.gap_mm;
  TriangleMesh mesh = question.centre_within_mm > 0.0 ? of : without_edge_on(of);
  std::vector<double> cosine(mesh.vertices.size(), 1.0);
  for (const Face& face : mesh.faces) {
    const double least =
        std::max(DirectionFace::kLeastCosine, std::cos(face_cap(corners_of(mesh, face)).cap.radius));
    for (const VertexIndex v : face) cosine[v] = std::min(cosine[v], least);
  }
  for (std::size_t v = 0; v < cosine.size(); ++v) {
    Vec3& x = mesh.vertices[v];
    const double length = x.norm();
    if (length > 0.0) x *= 1.0 + gap / (cosine[v] * length) * (1.0 + kTolerance);
  }
  return mesh;
}

// An upper bound, mm, of how far moved_out() moves a corner.
double growth_of(const TriangleMesh& mesh, double gap) {
  double least = 1.0;  // cosine
  for (const Face& face : mesh.faces)
    least = std::min(least, std::cos(face_cap(corners_of(mesh, face)).cap.radius));
  return gap / std::max(DirectionFace::kLeastCosine, least) * (1.0 + 1e-9);
}

// Do edge-on faces of the socket count? From a shifted centre they may be seen.
bool edge_on(const CellQuestion& question) {
  return question.centre_within_mm > 0.0 || question.play_mm > 0.0;
}

const CellQuestion& checked(const BallSocketPair& joint, const CellQuestion& question) {
  if (!(question.gap_mm >= 0.0) || !(question.centre_within_mm >= 0.0) || !(question.play_mm >= 0.0))
    throw std::invalid_argument(
        "motion volume: the gap, the distance of the centre and the play must be 0 mm or more");
  if (question.centre_within_mm > 0.0 && question.play_mm > 0.0)
    throw std::invalid_argument(
        "motion volume: every centre and play are two questions; ask for one of them");
  if (without_edge_on(joint.ball).faces.empty() || without_edge_on(joint.socket).faces.empty())
    throw std::invalid_argument(
        "motion volume: a surface has no face that the centre sees; give both meshes");
  return question;
}

}  // namespace

RotationBall ball_about(const RotationCell& cell) {
  return {rotation_of(centre(cell)), angular_radius(cell)};
}

CellTest::Side::Side(const TriangleMesh& mesh, Layer layer, const CellQuestion& question, bool ends)
    : seen(mesh, layer, layer == Layer::nearest && edge_on(question)),
      limits(without_edge_on(layer == Layer::farthest ? moved_out(mesh, question) : mesh), layer),
      holes(ends ? mesh_holes(seen) : MeshHoles{CapTree({}), {}, {}}),
      floor(seen) {
  if (question.play_mm > 0.0) borders = seen.borders();
  if (layer == Layer::farthest && (question.gap_mm > 0.0 || question.centre_within_mm > 0.0))
    moved = std::make_unique<const SeenSurface>(moved_out(mesh, question), layer, true);
}

CellTest::CellTest(const BallSocketPair& joint, const CellQuestion& question, const BoneParts& beside)
    : question_(checked(joint, question)),
      growth_(growth_of(joint.ball, question.gap_mm)),
      bodies_(joint, beside) {
  on_threads(kSurfaces.size(), [&](std::size_t k) {
    const Surface of = kSurfaces[k];
    sides_[k] = std::make_unique<const Side>(mesh_of(joint, of), facing_layer(of), question,
                                             of == Surface::ball && !beside.whole_ball);
  });
  bodies_.find_inner_balls(joint, question_.gap_mm > 0.0 || !bodies_.has_inside());
  const SeenSurface& socket = surface(Surface::socket);
  least_ball_ = grown_ball().least_radius() - growth_;
  least_socket_ = question.play_mm > 0.0 ? socket.least_distance() : socket.least_radius();
  edge_on_ = grown_ball().edge_on() || (question.play_mm == 0.0 && socket.edge_on());
  if (question.play_mm > 0.0 && !(question.play_mm + question.gap_mm < least_socket_))
    throw std::invalid_argument(
        "motion volume: the play must be less than " +
        formatted("%.3g mm, which the socket is from the centre", least_socket_ - question.gap_mm));
}

NearPoses CellTest::poses_near(const RotationBall& rotations, const Vec3& shift) const {
  const double turned = Eigen::AngleAxisd(rotations.rotation).angle();
  const double turn = rotations.radius + kTurnSlack;
  const double most = std::min(kPi, turned + turn);
  const double within = question_.centre_within_mm;
  return {rotations.rotation, turn, 2.0 * std::sin(0.5 * most) * within * (1.0 + kTolerance),
          question_.gap_mm, shift};
}

// The angle of (viii) in the header's theorem for these two faces; it is no larger than asked.angle.
CapAngle CellSearch::angle_of(const Asked& asked, const PosedFace& socket, const DirectionFace& ball) const {
  const double r = test_.question_.centre_within_mm;
  const double gap = test_.question_.gap_mm;
  if (r == 0.0) return asked.angle;
  const double y = socket.range.low;
  const double farthest = ball.range.high + asked.shift;
  const double nearest = ball.range.low - test_.growth_;  // least radius of the face without the gap
  if (!(y > r + gap) || !(nearest > asked.shift) || !(farthest > r)) return asked.angle;
  const double part = std::max({1.0 - (y - r) / (farthest - r), gap / (y - r - gap), 0.0});
  const double turned = std::asin(asked.shift / nearest) + std::asin(std::min(1.0, part * r / y));
  return CapAngle(std::min(asked.angle.radius, asked.turn + turned + kTurnSlack));
}

bool CellSearch::may_touch(const Asked& asked, const PosedFace& socket, const DirectionFace& ball) const {
  if (ball.range.high + asked.shift < socket.range.low * (1.0 - kTolerance)) return false;
  const CapAngle angle = angle_of(asked, socket, ball);
  if ((ball.cap.axis - socket.axis).norm() > ball.cap.radius + socket.radius + angle.radius) return false;
  const bool planes = !ball.plane.isZero(0.0) && !socket.plane.isZero(0.0);  // else ranges decide
  const double scale = 1.0 / (1.0 + asked.shift / ball.range.low);
  const Vec3 q = ball.plane * scale;
  const double slack = (ball.doubt + socket.doubt + kTolerance) * (q.norm() + socket.plane.norm());
  const double beyond = -angle.sine - kSideSlack;
  DirectionPolygon of_ball(ball.corner);
  for (const Vec3& n : socket.inward) of_ball.clip(n, beyond);
  if (std::ranges::none_of(of_ball.points(), [&](const Vec3& w) {
        return !planes || most_over(socket.plane, w, angle) - q.dot(w) >= -slack;
      }))
    return false;
  DirectionPolygon of_socket(socket.corner);
  for (const Vec3& n : ball.inward) of_socket.clip(n, beyond);
  return std::ranges::any_of(of_socket.points(), [&](const Vec3& u) {
    return !planes || socket.plane.dot(u) - least_over(q, u, angle) >= -slack;
  });
}

// The face as the ball's centre sees it; `room` is for a face that is seen from elsewhere.
const DirectionFace& CellSearch::seen_face(const Asked& asked, std::uint32_t socket_face,
                                           DirectionFace& room) const {
  const SeenSurface& socket = test_.surface(Surface::socket);
  if (asked.offset.isZero(0.0)) return socket.faces()[socket_face];
  return room = socket.seen_from(socket_face, asked.offset);
}

CellSearch::PosedFace CellSearch::posed(const Asked& asked, std::uint32_t socket_face) const {
  DirectionFace room;
  const DirectionFace& face = seen_face(asked, socket_face, room);
  PosedFace at{{},
               {},
               asked.inverse * face.plane,
               asked.inverse * face.cap.axis,
               face.range,
               face.plane,
               face.cap.radius,
               face.doubt};
  for (std::size_t k = 0; k < 3; ++k) {
    at.corner[k] = asked.inverse * face.corner[k];
    at.inward[k] = asked.inverse * face.inward[k];
  }
  return at;
}

bool CellSearch::find_pair_of(const Asked& asked, std::uint32_t socket_face, CellHint& hint) const {
  const PosedFace socket = posed(asked, socket_face);
  const NearCap near{socket.axis.cast<float>(), static_cast<float>(socket.radius + asked.angle.radius),
                     static_cast<float>(socket.range.low * (1.0 - kTolerance) - asked.shift)};
  const SeenSurface& ball = test_.grown_ball();
  return any_near(ball.face_tree(), near, [&](std::uint32_t f) {
    if (!may_touch(asked, socket, ball.faces()[f])) return false;
    hint.ball_face = f;
    hint.socket_face = socket_face;
    return true;
  });
}

// Calls found(face) for faces of the socket that the ball may reach until it is true; returns whether it was.
template <class Found>
bool CellSearch::any_socket_face(const Asked& asked, const Found& found) const {
  const CapLimits& farthest = test_.side(Surface::ball).limits;
  const double turn = asked.angle.radius + asked.aside + kTurnSlack;
  const double nearer = asked.shift + asked.offset.norm();
  const auto depth_of = [&](const CapBlock& block, std::size_t k) {
    const float wide = std::nextafter(block.angle[k] + static_cast<float>(turn), HUGE_VALF);
    const double most = test_.edge_on_ ? HUGE_VAL : farthest.within(asked.inverse * axis_of(block, k), wide);
    return most + nearer - block.low[k];
  };
  return search_deepest(test_.surface(Surface::socket).face_tree(), SIZE_MAX, depth_of, found);
}

bool CellSearch::find_pair(const Asked& asked, CellHint& hint) const {
  if (hint.ball_face != CellHint::kNone &&
      may_touch(asked, posed(asked, hint.socket_face), test_.grown_ball().faces()[hint.ball_face]))
    return true;
  if (hint.socket_face != CellHint::kNone && find_pair_of(asked, hint.socket_face, hint)) return true;
  return any_socket_face(asked, [&](std::uint32_t face) { return find_pair_of(asked, face, hint); });
}

// May the shifted ball's face reach beyond the socket's face, along a ray from the socket's centre?
bool CellSearch::may_pass(const Asked& asked, const DirectionFace& socket, std::uint32_t ball_face) const {
  const SeenSurface& ball = test_.surface(Surface::ball);
  const double size = ball.faces()[ball_face].range.high + asked.offset.norm();
  const double moved = 2.0 * std::sin(0.5 * asked.angle.radius) * size + kSideSlack * size;
  DirectionPolygon kept(ball.triangle(ball_face));
  for (const Vec3& n : socket.inward) kept.clip(asked.inverse * n, -moved - n.dot(asked.offset));
  const Vec3 q = asked.inverse * socket.plane;
  const double least =
      1.0 - socket.plane.dot(asked.offset) - (socket.doubt + kTolerance) * (1.0 + q.norm() * size);
  return std::ranges::any_of(kept.points(), [&](const Vec3& x) {
    return socket.plane.isZero(0.0) || most_over(q, x, asked.angle) >= least;
  });
}

// May the shifted ball overlap the socket, as the socket's centre sees it?
bool CellSearch::may_overlap(const Asked& asked) const {
  return any_socket_face(asked, [&](std::uint32_t f) {
    const DirectionFace& socket = test_.surface(Surface::socket).faces()[f];
    const Vec3 axis = asked.inverse * socket.cap.axis;
    const double turn = socket.cap.radius + asked.angle.radius + asked.aside;
    const NearCap near{axis.cast<float>(), static_cast<float>(turn),
                       static_cast<float>(socket.range.low * (1.0 - kTolerance) - asked.offset.norm())};
    return any_near(test_.surface(Surface::ball).face_tree(), near,
                    [&](std::uint32_t g) { return may_pass(asked, socket, g); });
  });
}

CellSearch::Reach CellSearch::reach_at(const Asked& asked, Surface of, std::uint32_t vertex) const {
  const bool of_ball = of == Surface::ball;
  const Vec3& x = test_.surface(of).vertices()[vertex];
  const double length = x.norm();
  Reach reach;
  const double r = test_.question_.centre_within_mm;
  const double gap = test_.question_.gap_mm;
  const double shift = asked.shift + 2.0 * gap * r / length;
  reach.radius = of_ball ? length + gap - shift : length - gap + shift;
  const double nearest = std::min(length, of_ball ? test_.least_socket_ : HUGE_VAL) - shift;
  if (!(nearest > r) || !(reach.radius > 0.5 * length) || (r > 0.0 && gap > 0.5 * (length - r))) return reach;
  reach.cap.axis = (of_ball ? asked.rotation : asked.inverse) * x / length;
  reach.cap.radius = asked.turn + std::asin(asked.shift / length) + std::asin(r / nearest) + kTurnSlack;
  const SeenSurface& met = test_.surface(other(of));
  reach.face = test_.side(other(of)).floor.face_along(reach.cap.axis);
  if (reach.face == DirectionFace::kNone) return reach;
  const DirectionFace& face = met.faces()[reach.face];
  // How far from the axis the plane of that face stays within, or beyond, the radius.
  const double along = face.plane.dot(reach.cap.axis);
  const double tilt = std::atan2(face.plane.cross(reach.cap.axis).norm(), along);
  const double limit = 1.0 / (reach.radius * face.plane.norm());
  const double turn = limit >= 1.0 ? 0.0 : std::acos(limit);
  reach.angle = of_ball ? (limit >= 1.0 ? -1.0 : turn - tilt) : (limit >= 1.0 ? kPi : tilt - turn);
  if (face.plane.isZero(0.0)) reach.angle = 0.0;
  return reach;
}

bool CellSearch::blocks(const Reach& reach, Surface of) {
  if (reach.face == DirectionFace::kNone || reach.angle < 0.0) return false;
  const CapAngle angle(reach.cap.radius);
  if (angle.wide) return false;
  const double inverse = 1.0 / reach.radius;
  const Vec3 across = reach.cap.axis.unitOrthogonal();
  const std::array<Vec3, 2> sides{across, reach.cap.axis.cross(across)};
  const auto polygon = [&](const DirectionFace& face) {
    DirectionPolygon kept(face.corner);
    for (const Vec3& side : sides) {
      kept.clip(angle.tangent * reach.cap.axis + side, -kSideSlack);
      kept.clip(angle.tangent * reach.cap.axis - side, -kSideSlack);
    }
    return kept;
  };
  const auto within = [&](const DirectionFace& face) {  // a face of the socket, no farther than the radius
    if (face.range.high <= reach.radius * (1.0 - kTolerance)) return true;
    if (face.plane.isZero(0.0)) return false;
    const double least = inverse * (1.0 + kTolerance + face.doubt) + kTolerance * face.plane.norm();
    if (least_over(face.plane, reach.cap.axis, angle) >= least) return true;
    const DirectionPolygon kept = polygon(face);
    return std::ranges::all_of(kept.points(),
                               [&](const Vec3& u) { return face.plane.dot(u) >= least * u.norm(); });
  };
  const auto beyond = [&](const DirectionFace& face) {  // a face of the ball, no nearer than the radius
    if (face.range.low >= reach.radius * (1.0 + kTolerance)) return true;
    if (face.plane.isZero(0.0)) return false;
    const double most = inverse * (1.0 - kTolerance - face.doubt) - kTolerance * face.plane.norm();
    if (most_over(face.plane, reach.cap.axis, angle) <= most) return true;
    const DirectionPolygon kept = polygon(face);
    return std::ranges::all_of(
        kept.points(), [&](const Vec3& u) { return face.plane.dot(u) <= most * u.dot(reach.cap.axis); });
  };
  const SeenSurface& met = test_.surface(other(of));
  return of == Surface::ball ? met.covers(reach.cap, reach.face, memory_, within)
                             : met.covers(reach.cap, reach.face, memory_, beyond);
}

bool CellSearch::find_reach(const Asked& asked, Surface of, CellHint& hint, double& best) {
  const bool of_ball = of == Surface::ball;
  const CellTest::Side& met = test_.side(other(of));
  const double more = test_.question_.gap_mm - asked.shift;
  const auto take = [&](std::uint32_t v) {
    const Reach reach = reach_at(asked, of, v);
    if (reach.angle > best) {
      best = reach.angle;
      hint.vertex = v;
      hint.of_ball = of_ball;
    }
    if (reach.angle < 0.5 * reach.cap.radius || !blocks(reach, of)) return false;
    hint.vertex = v;
    hint.of_ball = of_ball;
    return true;
  };
  const auto depth_of = [&](const CapBlock& block, std::size_t k) {
    const Vec3 x = (of_ball ? asked.rotation : asked.inverse) * axis_of(block, k);
    if (block.angle[k] < asked.angle.radius) {
      const double reached = met.floor.within(x, asked.angle.radius - block.angle[k]);
      return reached + (of_ball ? block.high[k] : -block.low[k]) + more;
    }
    const double limit = met.limits.within(x, block.angle[k]);
    return of_ball ? block.high[k] + more - limit : limit - block.low[k] - asked.shift;
  };
  return search_deepest(test_.surface(of).vertex_tree(), kMostVertices, depth_of, take);
}

bool CellSearch::may_leave(const Asked& asked) const {
  const MeshHoles& holes = test_.side(Surface::ball).holes;
  const SeenSurface& socket = test_.surface(Surface::socket);
  const double turn = asked.angle.radius + asked.aside;
  const auto meet = [&](std::uint32_t hole, std::uint32_t face) {
    const DirectionCap& cap = holes.caps[hole];
    DirectionFace room;
    return near(seen_face(asked, face, room), {asked.rotation * cap.axis, cap.radius + asked.angle.radius});
  };
  const auto visit = [&](const auto& self, std::uint32_t hole, std::size_t lane, std::uint32_t at) -> bool {
    const CapBlock& of = holes.tree.blocks()[hole];
    const CapBlock& block = socket.face_tree().blocks()[at];
    const Vec3 axis = asked.rotation * axis_of(of, lane);
    for (std::size_t k = 0; k < block.nodes; ++k) {
      if ((axis - axis_of(block, k)).norm() > of.angle[lane] + block.angle[k] + turn) continue;
      if (!of.leaf(lane)) {
        for (std::size_t l = 0; l < holes.tree.blocks()[of.first[lane]].nodes; ++l)
          if (self(self, of.first[lane], l, at)) return true;
        return false;  // the children of the hole were compared with all of the block
      }
      if (!block.leaf(k) && self(self, hole, lane, block.first[k])) return true;
      for (std::uint32_t f = block.first[k]; f < block.first[k] + block.items[k]; ++f)
        for (std::uint32_t h = of.first[lane]; h < of.first[lane] + of.items[lane]; ++h)
          if (meet(h, f)) return true;
    }
    return false;
  };
  for (std::size_t lane = 0; lane < holes.tree.blocks()[0].nodes; ++lane)
    if (visit(visit, 0, lane, 0)) return true;
  return false;
}

bool CellSearch::leaves(const Asked& asked) const {
  const CellTest::Side& ball = test_.side(Surface::ball);
  const CellTest::Side& socket = test_.side(Surface::socket);
  const double turn = asked.angle.radius + kTurnSlack;
  return std::ranges::any_of(ball.holes.empty,
                             [&](const DirectionCap& hole) {
                               return asked.aside == 0.0 && hole.radius >= turn &&
                                      socket.floor.face_along(asked.rotation * hole.axis) !=
                                          DirectionFace::kNone;
                             }) ||
         std::ranges::any_of(socket.seen.vertices(), [&](const Vec3& y) {
           const Vec3 x = asked.inverse * (y - asked.offset);
           return ball.floor.uncovered(x) && !ball.seen.any_near({x.stableNormalized(), turn});
         });
}

CellSearch::Asked CellSearch::asked_of(const NearPoses& poses, const RotationBall& rotations) const {
  const double shift = poses.shift_mm;
  const double r = test_.question_.centre_within_mm;
  const double doubt =
      r == 0.0 ? 0.0 : std::asin(shift / test_.least_ball_) + std::asin(r / test_.least_socket_);
  const double away = poses.offset.norm();
  return {rotations.rotation,
          rotations.rotation.transpose(),
          shift,
          CapAngle(rotations.radius + doubt + kTurnSlack),
          rotations.radius,
          poses.offset,
          away == 0.0 ? 0.0 : std::asin(away / test_.least_socket_) + kTurnSlack};
}

// A cell that is taken apart: what is left of it, in which nothing is known yet.
struct CellSearch::Parted {
  Asked asked;
  CellFrame frame;
  CellPart part{};
  CellPolytope left{};
  std::vector<CellPlane> planes{};  // planes that bound `left`
  std::size_t pairs = 0;            // pairs of faces that needed planes
  CapAngle about{0.0};              // about a face's axis: directions that a face of the socket may come to

  bool clip(const CellPlane& plane) {
    planes.push_back(plane);
    return left.clip(plane, static_cast<std::uint32_t>(5 + planes.size()));
  }
  bool keep(const FormOverCell& form) {
    return left.depth_below(form) == 0.0 || (clip(form.plane()) && !left.empty());
  }
};

void CellSearch::enter(const RotationCell& parent) {
  parent_ = parent;
  NearPoses poses = test_.poses_near(ball_about(parent));
  poses.shift_mm += test_.question_.play_mm;
  left_ = test_.bodies_.left(poses, by_radii());
}

// What may meet in all of the cell that was entered.
const BodyPairs::Left& CellSearch::left_of(const RotationCell* cell) const {
  static const BodyPairs::Left kAll;
  return cell != nullptr && parent_ && cell->level > 0 && parent(*cell) == *parent_ ? left_ : kAll;
}

bool CellSearch::parts_of_bodies(const RotationCell& cell) const {
  return may_be_parted() && cell.level <= kFinestPart && cell.level >= kCoarsestOfBodies;
}

// Looks at bones with an inside, and for the part in which they are apart if the cell may be taken apart.
CellSearch::Seen CellSearch::see(const Asked& asked, const NearPoses& poses, const RotationCell* cell,
                                 CellHint& hint) const {
  Seen seen;
  seen.middle = test_.bodies_.verdict({asked.rotation, asked.offset}).contact;
  if (seen.middle == Contact::yes) return seen;
  seen.apart = !find_pair(asked, hint);
  if (cell == nullptr || !parts_of_bodies(*cell)) return seen;
  seen.clear = std::make_shared<Parted>(Parted{asked, CellFrame(*cell)});
  if (!keep_bodies_apart(*seen.clear, poses, seen.apart, *cell)) seen.clear = nullptr;
  return seen;
}

// Are bones with an inside clear of each other in all of the rotations? Keeps what was seen.
bool CellSearch::clear_of_bodies(const Asked& asked, const NearPoses& poses, const RotationCell* cell,
                                 CellHint& hint) {
  seen_ = see(asked, poses, cell, hint);
  last_ = cell == nullptr ? std::nullopt : std::optional(*cell);
  if (seen_.middle == Contact::yes) return false;
  if (cell != nullptr && parts_of_bodies(*cell)) return seen_.clear && seen_.clear->planes.empty();
  return !test_.bodies_.may_meet(poses, seen_.apart, left_of(cell));
}

CellVerdict CellSearch::of_bodies(const Asked& asked, const NearPoses& poses, const CellHint& from,
                                  const RotationCell* cell) {
  const BodyPairs& bodies = test_.bodies_;
  CellHint hint = from;
  if (clear_of_bodies(asked, poses, cell, hint))
    return {state_of_free(asked), seen_.apart ? hint : CellHint{}};
  if (seen_.middle != Contact::no && bodies.overlap(poses, seen_.apart)) return {CellState::blocked, {}};
  const bool apart = seen_.middle == Contact::yes ? !find_pair(asked, hint) : seen_.apart;
  return {CellState::open, apart ? CellHint{} : hint};  // apart: the main surfaces do not stop it
}

CellVerdict CellSearch::decide(const RotationBall& rotations, const CellHint& hint) {
  return decide(rotations, hint, nullptr);
}

CellVerdict CellSearch::decide(const RotationCell& cell, const CellHint& hint) {
  return decide(ball_about(cell), hint, &cell);
}

CellVerdict CellSearch::decide(const RotationBall& rotations, const CellHint& from,
                               const RotationCell* cell) {
  if (test_.question_.play_mm > 0.0) return decide_with_play(rotations, from, cell);
  const NearPoses poses = test_.poses_near(rotations);
  const double r = test_.question_.centre_within_mm;
  if (r > 0.0 && !(std::min(test_.least_ball_, test_.least_socket_) >
                   std::max(poses.shift_mm, r) + test_.question_.gap_mm))
    return {};
  const Asked asked = asked_of(poses, rotations);
  if (asked.angle.wide) return {};
  if (!by_radii()) return of_bodies(asked, poses, from, cell);
  CellVerdict verdict = facing(asked, from);
  // Radii decide about the main surfaces if a gap counts, or if bones have no inside (limits/body_pairs.hpp).
  const BodyPairs& bodies = test_.bodies_;
  if (verdict.state == CellState::blocked || !bodies.may_meet(poses, true, left_of(cell))) return verdict;
  const bool overlap = bodies.overlap(poses, true);
  if (overlap || verdict.state != CellState::open) verdict.hint = {};  // the main surfaces do not stop it
  verdict.state = overlap ? CellState::blocked : CellState::open;
  return verdict;
}

// Nothing touches. Does the ball's mesh end under the socket?
CellState CellSearch::state_of_free(const Asked& asked) const {
  if (test_.side(Surface::ball).holes.tree.blocks().empty() || !may_leave(asked)) return CellState::free;
  return leaves(asked) ? CellState::unknown : CellState::open;
}

CellVerdict CellSearch::facing(const Asked& asked, const CellHint& from) {
  CellVerdict verdict{CellState::blocked, from};
  const Surface of = from.of_ball ? Surface::ball : Surface::socket;
  double best = -1.0;
  if (from.vertex != CellHint::kNone) {
    const Reach reach = reach_at(asked, of, from.vertex);
    if (blocks(reach, of)) return verdict;
  }
  if (!find_pair(asked, verdict.hint)) {
    verdict.state = state_of_free(asked);
    return verdict;
  }
  if (find_reach(asked, Surface::socket, verdict.hint, best) ||
      find_reach(asked, Surface::ball, verdict.hint, best))
    return verdict;
  verdict.state = CellState::open;
  return verdict;
}

// A half-space in which the vertex blocks: there it is beyond the planes of all faces that it may meet. None
// where that cannot be shown.
std::optional<FormOverCell> CellSearch::block_form(const Parted& at, Surface of, const Reach& reach) {
  if (reach.face == DirectionFace::kNone) return std::nullopt;
  const bool of_ball = of == Surface::ball;
  const Vec3 x = reach.radius * ((of_ball ? at.asked.inverse : at.asked.rotation) * reach.cap.axis);
  std::optional<FormOverCell> all;
  const auto keeps = [&](const DirectionFace& face) {
    if (of_ball ? face.range.high <= reach.radius * (1.0 - kTolerance)
                : face.range.low >= reach.radius * (1.0 + kTolerance))
      return true;
    if (face.plane.isZero(0.0)) return false;
    const double slack = face.doubt + kTolerance * (1.0 + face.plane.norm() * reach.radius);
    const FormOverCell form = of_ball ? at.frame.form(face.plane, x, 1.0, 1.0, slack)
                                      : at.frame.form(x, face.plane, 1.0, -1.0, slack);
    if (!all) all = form;
    const double offset = form.middle + form.least - (form.slope - all->slope).cwiseAbs().sum();
    all->least = std::min(all->least, offset - all->middle);
    return all->middle + all->least + all->corner() > 0.0;
  };
  if (!test_.surface(other(of)).covers(reach.cap, reach.face, memory_, keeps)) return std::nullopt;
  return all;
}

void CellSearch::find_witnesses(const Parted& at, Surface of, std::vector<Reach>& found) {
  const bool of_ball = of == Surface::ball;
  const CellTest::Side& met = test_.side(other(of));
  const auto take = [&](std::uint32_t v) {
    const Reach reach = reach_at(at.asked, of, v);
    if (reach.face != DirectionFace::kNone && reach.angle > -reach.cap.radius) found.push_back(reach);
    return false;
  };
  const double more = test_.question_.gap_mm;
  const auto depth_of = [&](const CapBlock& block, std::size_t k) {
    const Vec3 x = (of_ball ? at.asked.rotation : at.asked.inverse) * axis_of(block, k);
    const double limit = met.limits.within(x, block.angle[k]);
    return of_ball ? block.high[k] + more - limit : limit - block.low[k];
  };
  search_deepest(test_.surface(of).vertex_tree(), kMostVertices, depth_of, take);
}

// Half-spaces in which vertices of the main surfaces block, as forms.
std::vector<FormOverCell> CellSearch::blocked_by_radii(const Parted& at, const CellHint& hint) {
  std::vector<FormOverCell> forms;
  for (const Surface of : kSurfaces) {
    std::vector<Reach> found;
    find_witnesses(at, of, found);
    if (hint.vertex != CellHint::kNone && hint.of_ball == (of == Surface::ball))
      found.push_back(reach_at(at.asked, of, hint.vertex));
    std::stable_sort(found.begin(), found.end(),
                     [](const Reach& a, const Reach& b) { return a.angle > b.angle; });
    found.resize(std::min(found.size(), kMostWitnesses));
    for (const Reach& reach : found)
      if (const auto form = block_form(at, of, reach)) forms.push_back(*form);
  }
  return forms;
}

// Half-spaces in which a point of one body stays in an inner ball of another, as forms:
// |R x - y|^2 = |x|^2 + |y|^2 - 2 y . R x.
std::vector<FormOverCell> CellSearch::blocked_by_bodies(const Parted& at, const NearPoses& poses) const {
  std::vector<FormOverCell> forms;
  for (const auto& [x, y, reach] : test_.bodies_.deepest(poses, by_radii(), kMostWitnesses)) {
    const double squares = x.squaredNorm() + y.squaredNorm();
    forms.push_back(at.frame.form(y, x, 0.5 * (squares - reach * reach), 1.0, kTolerance * squares));
  }
  return forms;
}

// Cuts blocked half-spaces off, the largest first; true if nothing is left.
bool CellSearch::take_blocked(Parted& at, const std::vector<FormOverCell>& forms) {
  std::vector<CellPlane> planes;
  planes.reserve(forms.size());
  for (const FormOverCell& form : forms) planes.push_back(form.plane());
  std::stable_sort(planes.begin(), planes.end(),
                   [](const CellPlane& a, const CellPlane& b) { return a.offset > b.offset; });
  for (const CellPlane& plane : planes) {
    if (at.part.blocked.size() == kMostBlocked) return false;
    CellPolytope piece = at.left;
    if (at.left.farthest(plane) < kLeastGain || !piece.clip(plane, kUnnamed)) continue;
    at.part.blocked_share += piece.share(at.frame);
    at.part.blocked.push_back(plane);
    if (!at.clip(plane.opposite())) return false;
    if (at.left.empty()) return true;
  }
  return false;
}

// Two faces that may overlap in the cell. They do not where n . R x < c <= n . y, c >= 0, for all corners x
// and y (theorem in the header, (vii)).
struct CellSearch::PairForms {
  const PosedFace& socket;
  const DirectionFace& ball;
  DirectionPolygon of_ball;    // the ball's face, clipped to what the socket's face may come to; ball's frame
  DirectionPolygon of_socket;  // the socket's face, clipped likewise; ball's frame
  double slack;

  // The angle of a turn about the centre that moves u by the length `apart` along n, roughly.
  static double as_angle(double apart, const Vec3& n, const Vec3& u) {
    return apart / (n.cross(u).norm() + kLeastSlope * n.norm());
  }
  double by_socket_plane() const {
    double least = HUGE_VAL;
    for (const Vec3& w : of_ball.points())
      least = std::min(least, as_angle((ball.plane - socket.plane).dot(w) / w.norm(), socket.plane, w));
    return least;
  }
  double by_ball_plane() const {
    double least = HUGE_VAL;
    for (const Vec3& u : of_socket.points())
      least = std::min(least, as_angle((ball.plane - socket.plane).dot(u) / u.norm(), ball.plane, u));
    return least;
  }
  // A normal n across an edge of either that keeps the faces apart in the middle of the cell, scaled so that
  // n . y >= 1; zero if there is none.
  Vec3 by_edges() const {
    const std::vector<Vec3> x = corners(of_ball, ball.plane);
    const std::vector<Vec3> y = corners(of_socket, socket.plane);
    Vec3 normal = Vec3::Zero();
    double best = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t j = 0; j < y.size(); ++j) {
        Vec3 n = (x[(i + 1) % x.size()] - x[i]).cross(y[(j + 1) % y.size()] - y[j]);
        if (n.dot(y[j]) < 0.0) n = -n;
        double least = HUGE_VAL;
        double most = -HUGE_VAL;
        for (const Vec3& at : x) most = std::max(most, n.dot(at));
        for (const Vec3& at : y) least = std::min(least, n.dot(at));
        if (!(n.norm() > kLeastNormal) || !(least > 0.0)) continue;
        const double found = as_angle((least - most) / x[i].norm(), n, x[i].normalized());
        if (found <= best) continue;
        best = found;
        normal = n / least;
      }
    }
    return normal;
  }
  static std::vector<Vec3> corners(const DirectionPolygon& polygon, const Vec3& plane) {
    std::vector<Vec3> at;
    for (const Vec3& u : polygon.points()) at.emplace_back(u / plane.dot(u));
    return at;
  }
};

// Clips what is left to where these two faces do not overlap; false if no such place could be shown.
bool CellSearch::keep_apart(Parted& at, const PosedFace& socket, const DirectionFace& ball) const {
  const Asked& asked = at.asked;
  if (ball.range.high < socket.range.low * (1.0 - kTolerance)) return true;
  if ((ball.cap.axis - socket.axis).norm() > ball.cap.radius + socket.radius + asked.angle.radius)
    return true;
  // Is the plane of the ball's face nearer than all of the socket's face, in every rotation of the cell?
  const double ratio = at.about.wide ? 0.0 : least_over(ball.plane, socket.axis, at.about) * socket.range.low;
  if (ratio > 1.0 && ratio > 1.0 + (ball.doubt + kTolerance) * (2.0 + ball.plane.norm() * socket.range.low))
    return true;
  PairForms pair{socket, ball, DirectionPolygon(ball.corner), DirectionPolygon(socket.corner),
                 (ball.doubt + socket.doubt + kTolerance) * (ball.plane.norm() + socket.plane.norm())};
  const double beyond = -asked.angle.sine - kSideSlack;
  for (const Vec3& n : socket.inward) pair.of_ball.clip(n, beyond);
  for (const Vec3& n : ball.inward) pair.of_socket.clip(n, beyond);
  if (pair.of_ball.points().empty() || pair.of_socket.points().empty()) return true;
  if (ball.plane.isZero(0.0) || socket.plane.isZero(0.0)) return false;
  ++at.pairs;
  const double by_socket = pair.by_socket_plane();
  const double by_ball = pair.by_ball_plane();
  if (std::max(by_socket, by_ball) < 0.0) {
    const Vec3 normal = pair.by_edges();
    if (!normal.isZero(0.0)) {
      const Vec3 n = asked.rotation * normal;
      const std::vector<Vec3> corners = PairForms::corners(pair.of_ball, ball.plane);
      return std::ranges::all_of(corners, [&](const Vec3& x) {
        const double slack =
            pair.slack * x.norm() + (kTolerance + socket.doubt + ball.doubt) * (1.0 + n.norm() * x.norm());
        return at.keep(at.frame.form(n, x, 1.0, -1.0, slack));
      });
    }
  }
  if (by_socket >= by_ball) {
    return std::ranges::all_of(pair.of_ball.points(), [&](const Vec3& w) {
      return at.keep(at.frame.form(socket.plane_at_rest, w, ball.plane.dot(w), -1.0, pair.slack));
    });
  }
  return std::ranges::all_of(pair.of_socket.points(), [&](const Vec3& u) {
    return at.keep(at.frame.form(asked.rotation * u, ball.plane, socket.plane.dot(u), 1.0, pair.slack));
  });
}

bool CellSearch::take_free(Parted& at, const CellHint& hint) const {
  const SeenSurface& ball = test_.grown_ball();
  if (hint.socket_face != CellHint::kNone) {
    const PosedFace face = posed(at.asked, hint.socket_face);
    at.about = CapAngle(face.radius + at.asked.angle.radius);
    if (hint.ball_face != CellHint::kNone && !keep_apart(at, face, ball.faces()[hint.ball_face]))
      return false;
  }
  const auto with = [&](std::uint32_t f) {  // may face f touch the ball in all that is left?
    const PosedFace face = posed(at.asked, f);
    at.about = CapAngle(face.radius + at.asked.angle.radius);
    const NearCap near{face.axis.cast<float>(), static_cast<float>(face.radius + at.asked.angle.radius),
                       static_cast<float>(face.range.low * (1.0 - kTolerance))};
    return any_near(ball.face_tree(), near, [&](std::uint32_t g) {
      return !keep_apart(at, face, ball.faces()[g]) || at.pairs > kMostPairs;
    });
  };
  return !any_socket_face(at.asked, with) && !at.left.empty();
}

// Clips what is left to where bodies are apart; false if no such place could be shown.
bool CellSearch::keep_bodies_apart(Parted& at, const NearPoses& poses, bool by_radii,
                                   const RotationCell& cell) const {
  std::size_t taken = 0;
  const double least = kLeastFree * share(cell);
  const auto forms_of = [&](const ClosePair& pair, const ApartPlane& plane) {
    std::array<FormOverCell, 3> forms;
    for (std::size_t k = 0; k < forms.size(); ++k) {
      const Vec3& x = pair.of_ball[k];
      const double slack = kTolerance * std::abs(plane.least) + kTurnSlack * x.norm();
      forms[k] = at.frame.form(plane.normal, x, plane.least, -1.0, slack);
    }
    return forms;
  };
  const auto take = [&](const ClosePair& pair) {
    if (++taken > kMostClose) return false;
    std::array<FormOverCell, 3> best;  // of the plane that cuts least off
    double cut = HUGE_VAL;
    for (std::size_t k = 0; k < ClosePair::kPlanes && cut > 0.0; ++k) {
      const std::optional<ApartPlane> plane = pair.plane(k);
      if (!plane) continue;
      const auto forms = forms_of(pair, *plane);
      double deepest = 0.0;
      for (const FormOverCell& form : forms) deepest = std::max(deepest, at.left.depth_below(form));
      if (deepest >= cut) continue;
      cut = deepest;
      best = forms;
    }
    if (cut == 0.0) return true;
    return cut < HUGE_VAL &&
           std::ranges::all_of(best, [&](const FormOverCell& form) { return at.keep(form); }) &&
           at.left.share(at.frame) >= least;
  };
  return test_.bodies_.each_close(poses, by_radii, take, left_of(&cell));
}

CellPart CellSearch::part_of(const RotationCell& cell, const CellHint& hint) {
  const RotationBall rotations = ball_about(cell);
  const NearPoses poses = test_.poses_near(rotations);
  if (!may_be_parted() || cell.level > kFinestPart ||
      cell.level < (by_radii() ? kCoarsestPart : kCoarsestBlocked))
    return {};
  Parted at{asked_of(poses, rotations), CellFrame(cell)};
  CellHint guess = hint;
  if (!by_radii() && last_ != cell) seen_ = see(at.asked, poses, &cell, guess);
  last_.reset();
  std::vector<FormOverCell> forms;
  if (by_radii() || seen_.middle != Contact::no) forms = blocked_by_bodies(at, poses);
  if (by_radii()) {
    const std::vector<FormOverCell> more = blocked_by_radii(at, hint);
    forms.insert(forms.end(), more.begin(), more.end());
  }
  if (take_blocked(at, forms)) at.part.state = CellState::blocked;
  const bool may_be_free = by_radii() ? !at.left.empty() : forms.empty() && seen_.clear;
  if (!may_be_free || state_of_free(at.asked) != CellState::free) return std::move(at.part);
  if (!by_radii()) at = std::move(*seen_.clear);
  const bool apart = !by_radii() || (keep_bodies_apart(at, poses, true, cell) && take_free(at, hint));
  if (apart && !at.left.empty()) {
    if (at.planes.empty()) at.part.state = CellState::free;
    at.part.free_share = at.left.share(at.frame);
    for (std::size_t k = 0; k < at.planes.size(); ++k)
      if (at.left.bounds(static_cast<std::uint32_t>(6 + k))) at.part.free.push_back(at.planes[k]);
  }
  return std::move(at.part);
}

}  // namespace impinge
