// SPDX-License-Identifier: GPL-3.0-or-later
// Open cells are taken apart: Theorem 14 (volume), (vii).
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "rotations/cell_search.hpp"

namespace impinge {
namespace {

constexpr std::uint32_t kCoarsestPart = 5;     // cells from this level on are taken apart
constexpr std::uint32_t kCoarsestBlocked = 3;  // and for blocked parts of bones with an inside
constexpr std::uint32_t kFinestPart = 10;      // beyond this level planes in floats are too coarse
constexpr std::size_t kMostWitnesses = 4;      // vertices, or points of bodies, that may block part of a cell
constexpr std::size_t kMostBlocked = 6;        // blocked half-spaces of a cell
constexpr std::uint32_t kUnnamed = 0xffffU;    // number of a plane that only bounds a piece
constexpr double kLeastGain = 0.05;        // a half-space that reaches less far, in half sides, is left out
constexpr double kLeastSlope = 1e-3;       // least share of a normal across a direction, as a divisor
constexpr std::size_t kMostPairs = 4000;   // pairs of faces in a cell
constexpr std::size_t kMostClose = 10000;  // pairs of faces of bodies in a cell
constexpr std::size_t kMostTries = 2;      // ways to keep a pair of faces apart that are worked out
constexpr double kLeastAlong = 0.1;        // of a direction along the axis of a cap that it is near
constexpr double kLeastFree = 0.4;         // a smaller share of a cell is not worth its time

}  // namespace

bool CellSearch::parts_of_bodies(const RotationCell& cell) const {
  return may_be_parted() && cell.level <= kFinestPart && cell.level >= kCoarsestPart;
}

// Looks at bones with an inside, and for the part in which they are apart if the cell may be taken apart.
CellSearch::Seen CellSearch::see(const Asked& asked, const NearPoses& poses, const RotationCell* cell,
                                 CellHint& hint) const {
  Seen seen;
  seen.middle = test_.bodies_.verdict({asked.rotation, asked.offset}).contact;
  if (seen.middle == Contact::yes) return seen;
  seen.apart = !find_pair(asked, hint);
  if (cell == nullptr || !parts_of_bodies(*cell)) return seen;
  seen.clear = std::make_shared<Parted>(Parted{asked, CellFrame(*cell), kLeastFree * share(*cell)});
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

// A half-space in which the vertex blocks. It leaves out all directions of the cap in which the other surface
// ends, or is not reached. None where that cannot be shown.
std::optional<FormOverCell> CellSearch::block_form(const Parted& at, Surface of, const Reach& reach) {
  const CapAngle angle(reach.cap.radius);  // not wide in a cell of kCoarsestPart
  if (reach.face == DirectionFace::kNone) return std::nullopt;
  const bool of_ball = of == Surface::ball;
  const Vec3& axis = reach.cap.axis;
  const CapSquare square(axis, angle);
  const double inverse = 1.0 / reach.radius;
  std::vector<Vec3> open;  // corners, 1 along the axis, of polygons that hold these directions
  const auto take = [&](DirectionPolygon polygon) {
    square.clip(polygon);
    for (const Vec3& u : polygon.points()) {
      const double along = axis.dot(u);
      if (!(along > kLeastAlong)) return false;
      open.push_back(u / along);
    }
    return true;
  };
  Vec3 mean = Vec3::Zero();
  const auto keeps = [&](const DirectionFace& face) {
    mean += face.plane;
    if (of_ball ? face.range.high <= reach.radius * (1.0 - kTolerance)
                : face.range.low >= reach.radius * (1.0 + kTolerance))
      return true;
    DirectionPolygon polygon(face.corner);
    if (!face.plane.isZero(0.0)) {
      const double slack = inverse * (kTolerance + face.doubt) + kTolerance * face.plane.norm();
      polygon.clip(of_ball ? Vec3((inverse + slack) / angle.cosine * axis - face.plane)
                           : Vec3(face.plane - (inverse - slack) * axis),
                   -kSideSlack * inverse);
    }
    return take(polygon);
  };
  const auto ends = [&](const Vec3& inward) {
    const Vec3 a = angle.tangent * square.across;
    const Vec3 b = angle.tangent * square.up;
    DirectionPolygon polygon(
        std::array<Vec3, 3>{axis - 2.0 * (a + b), axis + 4.0 * a - 2.0 * b, axis + 4.0 * b - 2.0 * a});
    polygon.clip(-inward, -kSideSlack);
    return take(polygon);  // all of the cap where the side has no plane
  };
  const SeenSurface& met = test_.surface(other(of));
  if (!met.covers(reach.cap, reach.face, memory_, keeps, ends)) return std::nullopt;
  std::optional<FormOverCell> best;
  double farthest = -HUGE_VAL;
  const Vec3 x = reach.radius * ((of_ball ? at.asked.inverse : at.asked.rotation) * axis);
  for (const Vec3& n : {met.faces()[reach.face].plane, Vec3(inverse * mean.normalized())}) {
    double level = n.dot(axis) + (of_ball ? -2.0 : 2.0) * n.norm() * angle.sine;  // beyond all of the cap
    for (const Vec3& u : open) {
      const double along = n.dot(u);
      level = of_ball ? std::max({level, along, along * angle.cosine})
                      : std::min({level, along, along * angle.cosine});
    }
    const double slack = kTolerance * (1.0 + n.norm() * reach.radius);
    const FormOverCell form = of_ball ? at.frame.form(n, x, level * reach.radius, 1.0, slack)
                                      : at.frame.form(x, n, level * reach.radius, -1.0, slack);
    const double reached = (form.middle + form.least) / std::max(form.slope.norm(), 1e-300);
    if (reached <= farthest || !(form.middle + form.least + form.corner() > 0.0)) continue;
    farthest = reached;
    best = form;
  }
  return best;
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

// A normal n across an edge of either face that keeps the two apart in the middle of the cell: of n . y >= 1
// for the socket's corners, with n . x < 1 for the ball's; zero if there is none.
static Vec3 normal_across_edges(std::span<const Vec3> of_ball, std::span<const Vec3> of_socket) {
  Vec3 normal = Vec3::Zero();
  double best = 0.0;  // radians, of a turn about the centre that brings them together, roughly
  for (std::size_t i = 0; i < of_ball.size(); ++i) {
    for (std::size_t j = 0; j < of_socket.size(); ++j) {
      Vec3 n = (of_ball[(i + 1) % of_ball.size()] - of_ball[i])
                   .cross(of_socket[(j + 1) % of_socket.size()] - of_socket[j]);
      if (n.dot(of_socket[j]) < 0.0) n = -n;
      double least = HUGE_VAL;
      double most = -HUGE_VAL;
      for (const Vec3& x : of_ball) most = std::max(most, n.dot(x));
      for (const Vec3& y : of_socket) least = std::min(least, n.dot(y));
      const double length = n.norm();
      if (!(least > 0.0) || !(least > most)) continue;
      const double found = (least - most) / (n.cross(of_ball[i]).norm() + kLeastSlope * length);
      if (found <= best) continue;
      best = found;
      normal = n / least;
    }
  }
  return normal;
}

// Half-spaces in which two faces do not overlap, those that cut least off what is left. They do not overlap
// where n . R x < c <= n . y, c >= 0, for all corners x and y (theorem in the header, (vii)).
CellSearch::LeastCut CellSearch::least_cut(Parted& at, const PosedFace& socket,
                                           const DirectionFace& ball) const {
  const Asked& asked = at.asked;
  LeastCut best;
  best.cut = 0.0;
  if (ball.range.high < socket.range.low * (1.0 - kTolerance)) return best;
  if ((ball.cap.axis - socket.axis).norm() > ball.cap.radius + socket.radius + asked.angle.radius)
    return best;
  const double length = ball.plane.norm();
  // Is the plane of the ball's face nearer than all of the socket's face, in every rotation of the cell?
  const double ratio = at.about.wide ? 0.0 : least_over(ball.plane, socket.axis, at.about) * socket.range.low;
  if (ratio > 1.0 + (ball.doubt + kTolerance) * (2.0 + length * socket.range.low)) return best;
  const bool planes = !ball.plane.isZero(0.0) && !socket.plane.isZero(0.0);
  best.cut = HUGE_VAL;
  LeastCut tried;
  const auto attempt = [&](std::span<const Vec3> points, const auto& form_of) {
    double deepest = 0.0;
    for (std::size_t k = 0; k < points.size() && deepest < best.cut; ++k) {
      tried.forms[k] = form_of(points[k]);
      deepest = std::max(deepest, at.left.depth_below(tried.forms[k], best.cut));
    }
    if (deepest >= best.cut) return false;
    tried.cut = deepest;
    tried.count = points.size();
    best = tried;
    return deepest == 0.0;
  };
  const double steep = socket.plane.norm();
  const double slack = (ball.doubt + socket.doubt + kTolerance) * (length + steep);
  DirectionPolygon of_ball(ball.corner);      // what the socket's face may come to
  DirectionPolygon of_socket(socket.corner);  // what the ball's may come to
  const double beyond = -asked.angle.sine - kSideSlack;
  for (const Vec3& n : socket.inward) of_ball.clip(n, beyond);
  for (const Vec3& n : ball.inward) of_socket.clip(n, beyond);
  if (of_ball.points().empty() || of_socket.points().empty()) {
    best.cut = 0.0;
    return best;
  }
  ++at.pairs;
  // By the plane and the sides of either face, those first that keep the two farthest apart in the middle.
  struct Way {
    double angle;  // radians, roughly
    const Vec3* n;
    bool of_socket;  // is n the socket's?
    bool plane;      // is it a plane, not a side?
  };
  std::array<Way, 8> ways;
  std::size_t count = 0;
  const auto add = [&](const Vec3& n, bool by_socket, bool plane, double arm) {
    if (n.isZero(0.0) || (plane && !planes)) return;
    double least = HUGE_VAL;
    for (const Vec3& u : by_socket ? of_ball.points() : of_socket.points())
      least = std::min(least, plane ? ball.plane.dot(u) - socket.plane.dot(u) : -n.dot(u));
    ways[count++] = {least / arm, &n, by_socket, plane};
  };
  add(socket.plane, true, true, socket.plane.cross(ball.corner[0]).norm() + kLeastSlope * steep);
  add(ball.plane, false, true, ball.plane.cross(socket.corner[0]).norm() + kLeastSlope * length);
  for (const Vec3& n : socket.inward) add(n, true, false, 1.0);
  for (const Vec3& n : ball.inward) add(n, false, false, 1.0);
  const std::size_t tries = std::min(count, kMostTries);
  std::partial_sort(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(tries),
                    ways.begin() + static_cast<std::ptrdiff_t>(count),
                    [](const Way& a, const Way& b) { return a.angle > b.angle; });
  for (std::size_t k = 0; k < tries; ++k) {
    const Way& way = ways[k];
    const double product = !way.plane ? 1.0 : way.of_socket ? steep : length;
    const double off = way.plane ? slack : kSideSlack;
    if (attempt(way.of_socket ? of_ball.points() : of_socket.points(), [&](const Vec3& u) {
          return way.of_socket
                     ? at.frame.form_in_ball(*way.n, u, product, way.plane ? ball.plane.dot(u) : 0.0, -1.0,
                                             off)
                     : at.frame.form_in_ball(u, *way.n, product, way.plane ? socket.plane.dot(u) : 0.0,
                                             way.plane ? 1.0 : -1.0, off);
        }))
      return best;
  }
  if (!planes) return best;
  const auto points = [](const DirectionPolygon& polygon, const Vec3& plane, auto& of) {
    std::size_t corners = 0;
    for (const Vec3& u : polygon.points()) of[corners++] = u / plane.dot(u);
    return std::span<const Vec3>(of.data(), corners);
  };
  std::array<Vec3, DirectionPolygon::kMost> room;
  std::array<Vec3, DirectionPolygon::kMost> room_of_socket;
  const std::span<const Vec3> x = points(of_ball, ball.plane, room);
  const Vec3 n = normal_across_edges(x, points(of_socket, socket.plane, room_of_socket));
  if (n.isZero(0.0)) return best;
  attempt(x, [&](const Vec3& at_x) {
    const double product = n.norm() * at_x.norm();
    return at.frame.form_in_ball(
        n, at_x, product, 1.0, -1.0,
        slack * at_x.norm() + (kTolerance + socket.doubt + ball.doubt) * (1.0 + product));
  });
  return best;
}

// Clips what is left to where these two faces do not overlap; false if no such place could be shown.
bool CellSearch::keep_apart(Parted& at, const PosedFace& socket, const DirectionFace& ball) const {
  const LeastCut best = least_cut(at, socket, ball);
  return best.cut == 0.0 ||
         (best.cut < HUGE_VAL &&
          std::all_of(best.forms.begin(), best.forms.begin() + static_cast<std::ptrdiff_t>(best.count),
                      [&](const FormOverCell& form) { return at.keep(form); }));
}

bool CellSearch::take_free(Parted& at, const CellHint& hint) {
  const SeenSurface& ball = test_.grown_ball();
  if (hint.socket_face != CellHint::kNone) {
    const PosedFace face = posed(at.asked, hint.socket_face);
    at.about = CapAngle(face.radius + at.asked.angle.radius);
    if (hint.ball_face != CellHint::kNone && !keep_apart(at, face, ball.faces()[hint.ball_face]))
      return false;
  }
  below_.resize(ball.vertices().size());
  // Is vertex v of the ball within the plane (way 0) of the face, or beyond one of its sides (1 to 3), in all
  // that is left?
  const auto is_below = [&](const PosedFace& face, double steep, std::uint32_t v, std::size_t way) {
    if (v == DirectionFace::kNone) return false;
    Below& found = below_[v];
    if (found.face != faces_asked_) found = {faces_asked_, 0, 0};
    const auto bit = static_cast<std::uint8_t>(1U << way);
    if ((found.asked & bit) == 0) {
      found.asked |= bit;
      const Vec3& x = ball.vertices()[v];
      const double length = x.norm();
      const double product = steep * length;
      const FormOverCell form =
          way == 0 ? at.frame.form_in_ball(face.plane, x, product, 1.0, -1.0,
                                           (face.doubt + kTolerance) * (1.0 + product))
                   : at.frame.form_in_ball(face.inward[way - 1], x, length, 0.0, -1.0, kSideSlack * length);
      if (at.left.depth_below(form, 0.0) == 0.0) found.is |= bit;
    }
    return (found.is & bit) != 0;
  };
  const auto with = [&](std::uint32_t f) {  // may face f touch the ball in all that is left?
    const PosedFace face = posed(at.asked, f);
    const double steep = face.plane.norm();
    at.about = CapAngle(face.radius + at.asked.angle.radius);
    ++faces_asked_;
    const auto all_below = [&](std::uint32_t g) {
      const std::array<std::uint32_t, 3>& corners = ball.corners(g);
      const bool no_plane = ball.faces()[g].plane.isZero(0.0);  // it may reach beyond its moved corners
      for (std::size_t way = no_plane ? 1 : 0; way < 4; ++way) {
        if ((way == 0 ? face.plane : face.inward[way - 1]).isZero(0.0)) continue;
        if (is_below(face, steep, corners[0], way) && is_below(face, steep, corners[1], way) &&
            is_below(face, steep, corners[2], way))
          return true;
      }
      return false;
    };
    const NearCap near{face.axis.cast<float>(), static_cast<float>(face.radius + at.asked.angle.radius),
                       static_cast<float>(face.range.low * (1.0 - kTolerance))};
    const std::size_t cuts = at.planes.size();
    return any_near(ball.face_tree(), near,
                    [&](std::uint32_t g) {
                      return !all_below(g) &&
                             (!keep_apart(at, face, ball.faces()[g]) || at.pairs > kMostPairs);
                    }) ||
           (at.planes.size() > cuts && at.left.share(at.frame) < at.enough);
  };
  return !any_socket_face(at.asked, with);
}

// Clips what is left to where no hole of the ball's mesh is under the socket; false if no such place could be
// shown.
bool CellSearch::keep_covered(Parted& at) const {
  return !any_hole(at.asked, [&](const DirectionCap& hole, const DirectionFace& face) {
    const Vec3 h = at.asked.rotation * hole.axis;
    FormOverCell best;
    double cut = HUGE_VAL;
    const auto attempt = [&](const Vec3& n) {  // of n . y >= 0 for all y of the face, to within kSideSlack
      const double sine = std::sin(hole.radius) + 2.0 * kSideSlack;
      const FormOverCell form = at.frame.form(n, hole.axis, -sine, -1.0, kSideSlack);
      const double deepest = at.left.depth_below(form, cut);
      if (deepest >= cut) return;
      cut = deepest;
      best = form;
    };
    for (const Vec3& n : face.inward)
      if (cut > 0.0) attempt(n);
    for (const Vec3& y : face.corner) {  // across the way from the corner to the hole
      const Vec3 n = (h.dot(y) * y - h).stableNormalized();
      const bool faces_it =
          std::ranges::all_of(face.corner, [&](const Vec3& z) { return n.dot(z) >= -kSideSlack; });
      if (cut > 0.0 && faces_it) attempt(n);
    }
    return !at.keep(best);
  });
}

// Clips what is left to where bodies are apart; false if no such place could be shown.
bool CellSearch::keep_bodies_apart(Parted& at, const NearPoses& poses, bool by_radii,
                                   const RotationCell& cell) const {
  std::size_t taken = 0;
  const auto take = [&](const ClosePair& pair) {
    if (++taken > kMostClose) return false;
    std::array<FormOverCell, 3> best;  // of the plane that cuts least off
    double cut = HUGE_VAL;
    for (std::size_t k = 0; k < ClosePair::kPlanes && cut > 0.0; ++k) {
      const std::optional<ApartPlane> plane = pair.plane(k);
      if (!plane) continue;
      std::array<FormOverCell, 3> forms;
      double deepest = 0.0;
      for (std::size_t l = 0; l < forms.size() && deepest < cut; ++l) {
        const Vec3& x = pair.of_ball[l];
        const double slack = kTolerance * std::abs(plane->least) + kTurnSlack * x.norm();
        forms[l] = at.frame.form(plane->normal, x, plane->least, -1.0, slack);
        deepest = std::max(deepest, at.left.depth_below(forms[l], cut));
      }
      if (deepest >= cut) continue;
      cut = deepest;
      best = forms;
    }
    if (cut == 0.0) return true;
    if (!(cut < HUGE_VAL)) return false;
    for (const FormOverCell& form : best) at.keep(form);
    return at.left.share(at.frame) >= at.enough;
  };
  return test_.bodies_.each_close(poses, by_radii, take, left_of(&cell));
}

CellPart CellSearch::part_of(const RotationCell& cell, const CellHint& hint, bool free) {
  const RotationBall rotations = ball_about(cell);
  const NearPoses poses = test_.poses_near(rotations);
  if (!may_be_parted() || cell.level > kFinestPart ||
      cell.level < (by_radii() ? kCoarsestPart : kCoarsestBlocked))
    return {};
  Parted at{asked_of(poses, rotations), CellFrame(cell), kLeastFree * share(cell)};
  CellHint guess = hint;
  if (!by_radii() && last_ != cell) seen_ = see(at.asked, poses, &cell, guess);
  last_.reset();
  std::vector<FormOverCell> forms;
  if (by_radii() || seen_.middle != Contact::no) forms = blocked_by_bodies(at, poses);
  if (by_radii()) {
    const std::vector<FormOverCell> more = blocked_by_radii(at, hint);
    forms.insert(forms.end(), more.begin(), more.end());
  }
  if (take_blocked(at, forms)) {
    at.part.state = CellState::blocked;
    return std::move(at.part);
  }
  const bool may_be_free = by_radii() ? free : forms.empty() && seen_.clear;
  if (!may_be_free) return std::move(at.part);
  if (!by_radii()) at = std::move(*seen_.clear);
  const bool apart = !by_radii() || (keep_bodies_apart(at, poses, true, cell) && take_free(at, hint));
  if (apart && keep_covered(at)) {
    if (at.planes.empty()) at.part.state = CellState::free;
    at.part.free_share = at.left.share(at.frame);
    for (std::size_t k = 0; k < at.planes.size(); ++k)
      if (at.left.bounds(static_cast<std::uint32_t>(6 + k))) at.part.free.push_back(at.planes[k]);
  }
  return std::move(at.part);
}

}  // namespace impinge
