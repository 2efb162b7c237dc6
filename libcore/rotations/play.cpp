// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/play.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "rotations/cap_search.hpp"
#include "rotations/cell_test.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMostRounds = 6;       // shifts that are tried in a cell
constexpr std::size_t kMostMoves = 300;      // of farthest_from()
constexpr std::size_t kMostAsked = 64;       // vertices of a surface
constexpr std::size_t kKept = 2;             // contacts of a surface, or of two bodies, for one shift
constexpr std::size_t kMostClosePairs = 12;  // of faces, for one shift
constexpr double kSmoothShare = 1e-2;        // share of the play
constexpr double kInside = 1e-9;             // mm, above the rounding of `inside`
constexpr double kLeastMove = 1e-12;         // of a weight

// The weighted mean of half-spaces. Of all shifts up to the play, `inside` is its least n . d - least.
struct MeanHalfSpace {
  std::vector<double> weight;
  Vec3 normal = Vec3::Zero();
  double least = 0.0;

  explicit MeanHalfSpace(std::span<const ShiftHalfSpace> all)
      : weight(all.size(), 1.0 / static_cast<double>(all.size())) {
    sum(all);
  }
  void sum(std::span<const ShiftHalfSpace> all) {
    normal = Vec3::Zero();
    least = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      normal += weight[k] * all[k].normal;
      least += weight[k] * all[k].least;
    }
  }
  double inside(double play_mm) const { return -least - play_mm * normal.norm(); }
  // The weight t that is best moved from one to another: the largest t gain - r (|normal + t way|^2 +
  // smooth)^(1/2).
  double best_move(const ShiftHalfSpace& from, const ShiftHalfSpace& to, double play_mm,
                   double smooth) const {
    const Vec3 way = to.normal - from.normal;
    const double gain = from.least - to.least;
    const double a = way.squaredNorm();
    const double b = normal.dot(way);
    const double left = play_mm * play_mm * a - gain * gain;
    const double bend = a * (normal.squaredNorm() + smooth) - b * b;
    if (!(left > 0.0)) return gain > 0.0 ? 1.0 : 0.0;
    return (gain * std::sqrt(std::max(0.0, bend) / left) - b) / a;
  }
};

}  // namespace

// Weights w >= 0 that sum to 1 prove that every d has n . d - least >= -w . least - r |sum of w n| for some
// half-space. They are moved from the half-space that d is least inside of to the one it is most inside of,
// where d is the shift that the weighted mean of all is farthest from.
FarthestShift farthest_from(std::span<const ShiftHalfSpace> all, double play_mm) {
  FarthestShift found{Vec3::Zero(), -HUGE_VAL};
  if (all.empty()) return found;
  constexpr double kSmooth = kSmoothShare * kSmoothShare;
  MeanHalfSpace mean(all);
  for (std::size_t step = 0;; ++step) {
    found.inside = std::max(found.inside, mean.inside(play_mm));
    found.shift = -play_mm / std::sqrt(mean.normal.squaredNorm() + kSmooth) * mean.normal;
    if (step == kMostMoves) return found;
    std::size_t most = 0;
    std::size_t fewest = all.size();
    const auto inside = [&](std::size_t k) { return all[k].normal.dot(found.shift) - all[k].least; };
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (inside(k) > inside(most)) most = k;
      if (mean.weight[k] > 0.0 && (fewest == all.size() || inside(k) < inside(fewest))) fewest = k;
    }
    if (most == fewest) return found;
    const double t =
        std::clamp(mean.best_move(all[fewest], all[most], play_mm, kSmooth), 0.0, mean.weight[fewest]);
    if (!(t > kLeastMove)) return found;
    mean.weight[most] += t;
    mean.weight[fewest] -= t;
    mean.sum(all);
  }
}

Vec3 shift_of(const ShiftSteps& steps, double play_mm) {
  return play_mm / kShiftSteps * Vec3(steps[0], steps[1], steps[2]);
}

ShiftSteps steps_of(const Vec3& shift, double play_mm) {
  ShiftSteps steps{};
  double squares = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = kShiftSteps / play_mm * shift[static_cast<Eigen::Index>(k)];
    steps[k] = static_cast<std::int16_t>(std::clamp(std::round(at), -kShiftSteps, kShiftSteps));
    squares += static_cast<double>(steps[k]) * steps[k];
  }
  if (squares > kShiftSteps * kShiftSteps) {
    for (std::int16_t& at : steps) at = static_cast<std::int16_t>(at > 0 ? at - 1 : at < 0 ? at + 1 : 0);
  }
  return steps;
}

// A cell of rotations and all shifts.
struct CellSearch::Playing {
  // What one contact says of the shifts: half-spaces across a unit normal, or zero, in mm.
  struct Bound {
    Vec3 normal;
    double blocked;   // they touch in all of the rotations; infinite if none are known to
    double touching;  // they touch in the middle of the cell, about
    double margin;    // about so much more room is needed to be free in all of the rotations
  };
  // A vertex, as a shift brings it near the other surface.
  struct Vertex {
    Surface of;
    std::uint32_t index;
    Vec3 shift;  // mm
  };
  // Where a vertex is in the frame of the other surface, the ball's moved out by the gap.
  struct Place {
    bool of_ball;
    double length;  // mm, of the vertex
    Vec3 at;        // mm, without a shift
    Vec3 seen;      // mm, with its shift
    double most;    // q . z of it at most where it blocks a face q . z = 1 of the ball
  };

  CellSearch& search;
  const RotationBall& rotations;
  const RotationCell* cell;
  CellHint hint;
  const CellTest& test = search.test_;
  double play = test.question_.play_mm;
  double gap = test.question_.gap_mm;
  std::vector<Bound> bounds{};
  std::vector<ShiftSteps> tried{};

  Place place(const Vertex& vertex) const;
  std::optional<Bound> touch(const Vertex& vertex) const;
  Bound way_out(const Vertex& vertex, const Bound& touch) const;
  double blocked_from(const Vertex& vertex, const Vec3& normal) const;
  std::vector<Vertex> deepest(Surface of, const Vec3& shift) const;
  template <class Least>
  FarthestShift farthest(const Least& least_of) const;
  bool all_blocked() const {
    return farthest([](const Bound& b) { return b.blocked; }).inside > kInside;
  }
  bool blocked_at_once();
  void ask_hint();
  CellState with(const ShiftSteps& steps);
  void find_vertices(const Vec3& shift);
  void find_points(const NearPoses& poses);
  void find_close(const NearPoses& poses);
  std::optional<ShiftSteps> next();
};

CellSearch::Playing::Place CellSearch::Playing::place(const Vertex& vertex) const {
  const bool of_ball = vertex.of == Surface::ball;
  const Vec3& x = test.surface(vertex.of).vertices()[vertex.index];
  const double length = x.norm();
  const Eigen::Matrix3d& r = rotations.rotation;
  if (of_ball) {
    const Vec3 at = r * x * (1.0 + gap / length);
    return {true, length, at, at + vertex.shift, 1.0};
  }
  return {false, length, r.transpose() * x, r.transpose() * (x - vertex.shift),
          1.0 / (1.0 - gap / (length + play))};
}

// The face that a vertex meets with its shift in the middle of the cell, and the face's plane.
std::optional<CellSearch::Playing::Bound> CellSearch::Playing::touch(const Vertex& vertex) const {
  const Place x = place(vertex);
  const std::uint32_t f = test.side(other(vertex.of)).floor.face_along(x.seen.normalized());
  if (f == DirectionFace::kNone) return std::nullopt;
  const Vec3& plane = test.surface(other(vertex.of)).faces()[f].plane;
  if (plane.isZero(0.0)) return std::nullopt;
  const double size = plane.norm();
  const double least = (x.of_ball ? x.most - plane.dot(x.at) : plane.dot(x.at) - x.most) / size;
  const Vec3 normal = plane / size;
  return Bound{x.of_ball ? normal : Vec3(rotations.rotation * normal), HUGE_VAL, least,
               rotations.radius * x.at.cross(normal).norm()};
}

// The half-space that is left with the least shift: that of the plane, or the one within the nearest border.
CellSearch::Playing::Bound CellSearch::Playing::way_out(const Vertex& vertex, const Bound& touch) const {
  const Place x = place(vertex);
  const Vec3 u = x.seen.normalized();
  const SeenBorder* nearest = nullptr;
  double least = HUGE_VAL;
  for (const SeenBorder& border : test.side(other(vertex.of)).borders) {
    const double squared = (border.middle - u).squaredNorm();
    if (squared >= least || border.inward.dot(u) < 0.0) continue;
    nearest = &border;
    least = squared;
  }
  if (nearest == nullptr || -nearest->inward.dot(x.at) <= touch.touching) return touch;
  const Vec3& n = nearest->inward;
  return {x.of_ball ? n : Vec3(-(rotations.rotation * n)), HUGE_VAL, -n.dot(x.at),
          rotations.radius * x.length};
}

// The vertex is beyond the planes of all faces that it may meet, in all of the rotations with any shift d, if
// normal . d is what is returned or more (theorem in the header, (ii)).
double CellSearch::Playing::blocked_from(const Vertex& vertex, const Vec3& normal) const {
  const Place x = place(vertex);
  // A gap is along rays from the shifted centre, which the socket may meet from its least radius on.
  const double nearest = x.of_ball && gap > 0.0 ? std::min(x.length, test.least_socket_) : x.length;
  const CapAngle turn(rotations.radius + CellTest::kTurnSlack);
  if (!(nearest > play)) return HUGE_VAL;  // the turn is not wide, or decide() had returned
  const DirectionCap cap{x.at.normalized(), turn.radius + std::asin(play / nearest) + CellTest::kTurnSlack};
  const std::uint32_t from = test.side(other(vertex.of)).floor.face_along(cap.axis);
  if (from == DirectionFace::kNone) return HUGE_VAL;
  const Vec3 across = x.of_ball ? normal : Vec3(rotations.rotation.transpose() * normal);
  // A turn of the ball turns the shift in its frame.
  const double turned = x.of_ball ? 0.0 : 2.0 * std::sin(0.5 * turn.radius) * play;
  double blocked = -2.0 * play;
  const auto keeps = [&](const DirectionFace& face) {
    if (x.of_ball ? face.range.high <= (x.length + gap - play) * (1.0 - CellTest::kTolerance)
                  : face.range.low >= (x.length - gap + play) * (1.0 + CellTest::kTolerance))
      return true;
    if (face.plane.isZero(0.0)) return false;
    const double size = face.plane.norm();
    const double slack = (face.doubt + CellTest::kTolerance) * (1.0 + size * (x.at.norm() + play));
    const double least =
        x.of_ball ? x.most - least_over(face.plane, x.at, turn) : most_over(face.plane, x.at, turn) - x.most;
    blocked = std::max(blocked, (least + slack) / size + turned + play * (face.plane / size - across).norm());
    return blocked < play;
  };
  return test.surface(other(vertex.of)).covers(cap, from, search.memory_, keeps) ? blocked : HUGE_VAL;
}

// Vertices of a surface that are deepest in the other one with this shift: in the middle of the cell, and
// over all directions that they may come to.
std::vector<CellSearch::Playing::Vertex> CellSearch::Playing::deepest(Surface of, const Vec3& shift) const {
  const bool of_ball = of == Surface::ball;
  const Eigen::Matrix3d turned = of_ball ? rotations.rotation : rotations.rotation.transpose();
  const Vec3 moved = of_ball ? shift : Vec3(-(turned * shift));
  const CellTest::Side& met = test.side(other(of));
  const auto depth_of = [&](const CapBlock& block, std::size_t k) {
    const double far = of_ball ? block.high[k] : block.low[k];
    const Vec3 at = turned * axis_of(block, k) * far + moved;
    const double length = at.norm();
    const double limit = met.limits.within(at / length, block.angle[k]);
    return (of_ball ? length - limit : limit - length) + gap + play;
  };
  std::array<std::vector<std::pair<double, std::uint32_t>>, 2> found;
  search_deepest(test.surface(of).vertex_tree(), kMostAsked, depth_of, [&](std::uint32_t v) {
    const Vec3 x = turned * test.surface(of).vertices()[v];
    const Vec3 at = x + moved;
    const double length = x.norm();
    const double far = of_ball ? at.norm() : -at.norm();
    const double turn = rotations.radius + std::asin(std::min(1.0, play / length));
    found[0].emplace_back(met.floor.within(at.normalized(), 0.0) + far, v);
    found[1].emplace_back(met.floor.within(x / length, turn) + far, v);
    return false;
  });
  std::vector<Vertex> vertices;
  for (auto& deep : found) {
    std::ranges::sort(deep, std::greater{});
    deep.resize(std::min(deep.size(), kKept));
    for (const auto& [depth, v] : deep)
      if (depth > -HUGE_VAL) vertices.push_back({of, v, shift});
  }
  return vertices;
}

template <class Least>
FarthestShift CellSearch::Playing::farthest(const Least& least_of) const {
  std::vector<ShiftHalfSpace> all;
  for (const Bound& bound : bounds)
    if (least_of(bound) < HUGE_VAL) all.push_back({bound.normal, least_of(bound)});
  return farthest_from(all, play);
}

// Is one vertex so deep that it blocks all of the rotations with every shift?
bool CellSearch::Playing::blocked_at_once() {
  if (!search.by_radii()) return false;
  Asked asked = search.asked_of(test.poses_near(rotations), rotations);
  asked.shift = play;
  if (gap > 0.0) asked.turn += std::asin(play / test.least_socket_);  // as in blocked_from()
  asked.angle = CapAngle(asked.turn + std::asin(play / test.least_socket_) + CellTest::kTurnSlack);
  if (asked.angle.wide) return false;
  if (hint.vertex != CellHint::kNone) {
    const Surface of = hint.of_ball ? Surface::ball : Surface::socket;
    if (search.blocks(search.reach_at(asked, of, hint.vertex), of)) return true;
  }
  double best = -1.0;
  return search.find_reach(asked, Surface::socket, hint, best) ||
         search.find_reach(asked, Surface::ball, hint, best);
}

void CellSearch::Playing::ask_hint() {
  if (hint.vertex == CellHint::kNone) return;
  const Vertex vertex{hint.of_ball ? Surface::ball : Surface::socket, hint.vertex, shift_of(hint, play)};
  if (const auto bound = touch(vertex))
    bounds.push_back({bound->normal, blocked_from(vertex, bound->normal), HUGE_VAL, 0.0});
}

// Are all of the rotations free with this shift? If not, what touches tells of other shifts.
CellState CellSearch::Playing::with(const ShiftSteps& steps) {
  tried.push_back(steps);
  hint.shift = steps;
  const NearPoses poses = test.poses_near(rotations, shift_of(hint, play));
  const Asked asked = search.asked_of(poses, rotations);
  if (asked.angle.wide) return CellState::open;
  const bool by_radii = search.by_radii();
  const bool apart =
      by_radii && !search.find_pair(asked, hint) && (asked.offset.isZero(0.0) || !search.may_overlap(asked));
  if (by_radii ? apart && !test.bodies_.may_meet(poses, true, search.left_of(cell))
               : search.clear_of_bodies(asked, poses, cell, hint)) {
    const CellState state = search.state_of_free(asked);
    if (state != CellState::open) return state;
  }
  if (apart || (!by_radii && search.seen_.apart)) hint.ball_face = hint.socket_face = CellHint::kNone;
  if (by_radii) find_vertices(poses.offset);
  find_points(poses);
  if (!by_radii && search.seen_.middle != Contact::yes) find_close(poses);
  return CellState::open;
}

// What vertices of the main surfaces tell.
void CellSearch::Playing::find_vertices(const Vec3& shift) {
  double best = play;
  for (const Surface of : kSurfaces) {
    for (const Vertex& vertex : deepest(of, shift)) {
      auto bound = touch(vertex);
      if (!bound) continue;
      bounds.push_back(way_out(vertex, *bound));
      bound->blocked = blocked_from(vertex, bound->normal);
      bound->touching = HUGE_VAL;
      bounds.push_back(*bound);
      if (bound->blocked >= best) continue;
      best = bound->blocked;
      hint.vertex = vertex.index;
      hint.of_ball = of == Surface::ball;
      if (best <= -play) return;  // with every shift
    }
  }
}

// What points in inner balls tell: a shift d with n . d >= least, |d| <= play, is within `reach` of c, as
// |d - c|^2 = |d|^2 - 2 c . d + |c|^2.
void CellSearch::Playing::find_points(const NearPoses& poses) {
  const Eigen::Matrix3d& r = rotations.rotation;
  for (const auto& [x, y, reach] : test.bodies_.deepest(poses, search.by_radii(), kKept)) {
    const Vec3 c = y + poses.offset - r * x;
    const double length = c.norm();
    const Vec3 n = c.stableNormalized();  // zero if c is: then all shifts are alike
    const double turned = 2.0 * std::sin(0.5 * poses.turn) * x.norm();
    const double left =
        (reach - turned) * (1.0 - CellTest::kTolerance) - CellTest::kTolerance * (x.norm() + play);
    const auto least = [&](double within) {
      return within >= play + length ? -2.0 * play
                                     : 0.5 * (play * play + length * length - within * within) / length;
    };
    bounds.push_back(
        {n, left > 0.0 ? least(left) : HUGE_VAL, least(reach), rotations.radius * (r * x).cross(n).norm()});
  }
}

// Faces of bodies that are clear in the middle of the cell tell how far a shift may bring them nearer.
void CellSearch::Playing::find_close(const NearPoses& poses) {
  std::size_t taken = 0;
  const auto take = [&](const ClosePair& pair) {
    std::optional<ApartPlane> best;
    for (std::size_t k = 0; k < ClosePair::kPlanes; ++k) {
      const std::optional<ApartPlane> plane = pair.plane(k);
      if (plane && (!best || plane->angle > best->angle)) best = plane;
    }
    if (!best) return false;
    double most = -HUGE_VAL;
    double arm = 0.0;
    for (const Vec3& x : pair.moved) {
      most = std::max(most, best->normal.dot(x));
      arm = std::max(arm, x.cross(best->normal).norm());
    }
    const double least = best->least + best->normal.dot(poses.offset);
    bounds.push_back({best->normal, HUGE_VAL, least - most, rotations.radius * arm});
    return ++taken < kMostClosePairs;
  };
  test.bodies_.each_close(poses, search.seen_.apart, take, search.left_of(cell));
}

// The shift to try next; none if no other is likely to be free, or to touch. The one that is nearest to being
// free stays in the hint.
std::optional<ShiftSteps> CellSearch::Playing::next() {
  const FarthestShift clear = farthest([](const Bound& b) { return b.touching; });
  if (clear.inside > 0.0) {  // every shift touches, about
    hint.shift = steps_of(clear.shift, play);
    return steps_of(farthest([](const Bound& b) { return b.blocked; }).shift, play);
  }
  const FarthestShift free = farthest([](const Bound& b) { return b.touching - b.margin; });
  hint.shift = steps_of(free.shift, play);
  return free.inside > 0.0 ? std::nullopt : std::optional(hint.shift);
}

CellVerdict CellSearch::decide_with_play(const RotationBall& rotations, const CellHint& from,
                                         const RotationCell* cell) {
  Playing at{*this, rotations, cell, from};
  at.ask_hint();
  if (at.all_blocked() || at.blocked_at_once()) return {CellState::blocked, at.hint};
  std::optional<ShiftSteps> next = ShiftSteps{};
  while (next && at.tried.size() < kMostRounds && std::ranges::find(at.tried, *next) == at.tried.end()) {
    if (const CellState state = at.with(*next); state != CellState::open) return {state, at.hint};
    if (at.all_blocked()) return {CellState::blocked, at.hint};
    next = at.next();
    if (at.tried.size() == 1 && from.shift != ShiftSteps{}) next = from.shift;
  }
  return {CellState::open, at.hint};
}

}  // namespace impinge
