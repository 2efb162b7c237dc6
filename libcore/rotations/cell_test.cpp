// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/cell_test.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>

#include "files/formatted.hpp"
#include "files/thread_team.hpp"
#include "mesh/surface_vertices.hpp"
#include "rotations/cell_search.hpp"

namespace impinge {
namespace {

constexpr double kTolerance = CellTest::kTolerance;
constexpr std::size_t kMostWalked = 20000;  // faces over caps, for all vertices of a surface that may block

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
  const double turned = Eigen::AngleAxisd(rotations.rotation * question_.rest).angle();
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
  PosedFace at{
      {},        {}, asked.inverse * face.plane, asked.inverse * face.cap.axis, face.range, face.cap.radius,
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
  const CapSquare square(reach.cap.axis, angle);
  const auto polygon = [&](const DirectionFace& face) {
    DirectionPolygon kept(face.corner);
    square.clip(kept);
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
  std::size_t walked = 0;
  const auto take = [&](std::uint32_t v) {
    const Reach reach = reach_at(asked, of, v);
    if (reach.angle > best) {
      best = reach.angle;
      hint.vertex = v;
      hint.of_ball = of_ball;
    }
    if (reach.angle < 0.5 * reach.cap.radius || walked > kMostWalked) return false;
    const bool found = blocks(reach, of);
    walked += memory_.faces.size();
    if (!found) return false;
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
  return any_hole(asked, [](const DirectionCap&, const DirectionFace&) { return true; });
}

// Is a direction without a face of the ball under a face of the socket, in all of the rotations? Either one
// direction of the socket stays over a hole, or one of a hole under the socket.
bool CellSearch::leaves(const Asked& asked) {
  const CellTest::Side& ball = test_.side(Surface::ball);
  const CellTest::Side& socket = test_.side(Surface::socket);
  const double turn = asked.hole + kTurnSlack;
  const bool exact = test_.question_.centre_within_mm == 0.0;
  return std::ranges::any_of(
             ball.holes.empty,
             [&](const DirectionCap& hole) {
               const DirectionCap cap{asked.rotation * hole.axis, turn};
               const std::uint32_t face =
                   asked.aside == 0.0 ? socket.floor.face_along(cap.axis) : DirectionFace::kNone;
               return face != DirectionFace::kNone &&
                      (hole.radius >= turn ||
                       (exact &&
                        socket.seen.covers(cap, face, memory_, [](const DirectionFace&) { return true; })));
             }) ||
         std::ranges::any_of(socket.seen.vertices(), [&](const Vec3& y) {
           const Vec3 x = asked.inverse * (y - asked.offset);
           return ball.floor.uncovered(x) && !ball.seen.any_near({x.stableNormalized(), turn});
         });
}

CellSearch::Asked CellSearch::asked_of(const NearPoses& poses, const RotationBall& rotations) const {
  const double shift = poses.shift_mm;
  const double r = test_.question_.centre_within_mm;
  const double ball = test_.least_ball_;
  const double socket = test_.least_socket_;
  const double doubt = r == 0.0 ? 0.0 : std::asin(shift / ball) + std::asin(r / socket);
  const double hole = r == 0.0 ? 0.0 : std::asin(shift / socket) + std::asin(r / ball);
  const double away = poses.offset.norm();
  return {rotations.rotation,
          rotations.rotation.transpose(),
          shift,
          CapAngle(rotations.radius + doubt + kTurnSlack),
          rotations.radius,
          poses.offset,
          away == 0.0 ? 0.0 : std::asin(away / socket) + kTurnSlack,
          rotations.radius + hole + kTurnSlack};
}

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
CellState CellSearch::state_of_free(const Asked& asked) {
  if (!may_leave(asked)) return CellState::free;
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

}  // namespace impinge
