// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/near_poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "contact/part_distance.hpp"
#include "mesh/meeting_faces.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

constexpr double kRounding = 1e-9;  // share of a length
constexpr double kSquared = 1e-13;  // share of the square of a length
constexpr double kTouches = 1e-6;   // share of a ball's radius by which it may reach beyond the surface
constexpr double kLeastArm = 0.1;   // mm, added to an arm that a distance is divided by
constexpr int kMostShrinks = 30;    // of one ball

double farthest(const TurnFace& face) {
  return std::sqrt(
      std::max({face.corner[0].squaredNorm(), face.corner[1].squaredNorm(), face.corner[2].squaredNorm()}));
}

}  // namespace

NearBodies::NearBodies(const NearPoses& poses, double gap_mm)
    : poses_(poses),
      cosine_(std::cos(std::min(poses.turn, kPi))),
      sine_(std::sin(std::min(poses.turn, kPi))),
      chord_(2.0 * std::sin(0.5 * std::min(poses.turn, kPi))),
      more_(poses.shift_mm + gap_mm),
      gap_(gap_mm),
      away_(poses.offset.norm()) {}

TurnFace NearBodies::turned(const TurnFace& face) const {
  return turn_face(turned(face.corner[0]), turned(face.corner[1]), turned(face.corner[2]));
}

TurnFace NearBodies::seen(TurnFace face) const {
  for (Vec3& y : face.corner) y = seen(y);
  return face;
}

double NearBodies::least_squared(const Vec3& p, const Vec3& y) const {
  const double along = p.dot(y);
  const double across = p.cross(y).norm();
  const double both = p.squaredNorm() + y.squaredNorm();
  const double product = across * cosine_ <= along * sine_ ? std::sqrt(p.squaredNorm() * y.squaredNorm())
                                                           : along * cosine_ + across * sine_;
  return both * (1.0 - kSquared) - 2.0 * product;
}

double NearBodies::most_squared(const Vec3& p, const Vec3& y) const {
  const double along = p.dot(y);
  const double across = p.cross(y).norm();
  const double both = p.squaredNorm() + y.squaredNorm();
  const double product = across * cosine_ + along * sine_ <= 0.0
                             ? -std::sqrt(p.squaredNorm() * y.squaredNorm())
                             : along * cosine_ - across * sine_;
  return both * (1.0 + kSquared) - 2.0 * product;
}

double NearBodies::most_along(const Vec3& n, const Vec3& p) const {
  const double along = n.dot(p);
  const double across = n.cross(p).norm();
  return across * cosine_ <= along * sine_ ? p.norm() : along * cosine_ + across * sine_;
}

// Does a plane across unit n keep the two faces apart in all of the poses?
bool NearBodies::apart_along(const Vec3& n, const TurnFace& moved, const TurnFace& face, double slack) const {
  const double low = std::min({n.dot(face.corner[0]), n.dot(face.corner[1]), n.dot(face.corner[2])});
  return std::ranges::all_of(moved.corner, [&](const Vec3& p) { return low - most_along(n, p) > slack; });
}

// The kth direction, towards the second face, across which a plane may keep the faces apart: the line between
// their middles after a turn that brings these as near as it can, and both normals.
Vec3 NearBodies::way(std::size_t k, const TurnFace& moved, const TurnFace& face) const {
  const Vec3 middle = (moved.corner[0] + moved.corner[1] + moved.corner[2]) / 3.0;
  const Vec3 to = (face.corner[0] + face.corner[1] + face.corner[2]) / 3.0 - middle;
  if (k > 0) {
    const Vec3 n = (k == 1 ? face : moved).normal.stableNormalized();
    return n.dot(to) < 0.0 ? Vec3(-n) : n;
  }
  const double far = middle.norm();
  const Vec3 out = far > 0.0 ? Vec3(middle / far) : to;
  const Vec3 along = to.dot(out) * out;
  const double side = (to - along).norm();
  const double left = std::max(0.0, side - far * poses_.turn);
  return (far > 0.0 && side > 0.0 ? Vec3(along + left / side * (to - along)) : out).stableNormalized();
}

bool NearBodies::apart(const TurnFace& moved, const TurnFace& face, Ways& ways) const {
  const double slack = more_ + kRounding * (farthest(moved) + farthest(face));
  for (std::size_t k = 0; k < ways.size(); ++k) {
    ways[k] = way(k, moved, face);
    if (apart_along(ways[k], moved, face, slack)) return true;
  }
  const double reach = chord_ * farthest(moved) + slack;
  for (const Vec3& x : moved.corner)
    for (const Vec3& y : face.corner)
      if ((x - y).squaredNorm() <= reach * reach) return false;
  return farther_than(moved, face, reach) && !faces_meet(moved.corner, face.corner);
}

// Are all parts below two nodes farther apart than the gap in all of the poses, or told about?
bool NearBodies::apart(const Asked& asked, std::uint32_t p, std::uint32_t q) const {
  const SweptParts::Node& a = asked.ball.nodes()[p];
  const SweptParts::Node& b = asked.socket.nodes()[q];
  const double slack = more_ + kRounding * (a.farthest + b.farthest);
  if (std::max(a.nearest - b.farthest, b.nearest - a.farthest) > slack + away_) return true;
  const double reach = a.radius + b.radius + slack;
  const Vec3 x = turned(a.centre);
  const Vec3 y = seen(b.centre);
  // Most pairs are decided by their distance in the middle pose, and by how far a turn may move a point.
  const double squared = (x - y).squaredNorm();
  const double farther = reach + chord_ * a.farthest;
  const bool are_apart =
      squared > farther * farther || (squared > reach * reach && least_squared(x, y) > reach * reach);
  return are_apart || (asked.told && asked.told(p, q));
}

NodePairs NearBodies::left(const Asked& asked, std::size_t most) const {
  NodePairs kept;
  if (asked.ball.empty() || asked.socket.empty()) return kept;
  NodePairs queue = asked.pairs;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const auto [p, q] = queue[k];
    if (apart(asked, p, q)) continue;
    const bool leaves = asked.ball.nodes()[p].leaf && asked.socket.nodes()[q].leaf;
    if (leaves || kept.size() + queue.size() - k >= most)
      kept.push_back(queue[k]);
    else
      open_pair(asked.ball, asked.socket, {p, q}, queue);
  }
  return kept;
}

// Calls meet(face of the ball, that face turned by R, face of the socket, ways) for pairs that may come as
// near as the gap, until it is true; returns whether it was.
template <class Meet>
bool NearBodies::any_close(const Asked& asked, const Meet& meet) const {
  const auto are_apart = [&](std::uint32_t p, std::uint32_t q) { return apart(asked, p, q); };
  const auto meets = [&](std::uint32_t p, std::uint32_t q) {
    const TurnFace face = seen(asked.socket.parts()[q]);
    const TurnFace moved = turned(asked.ball.parts()[p]);
    Ways ways;
    return !apart(moved, face, ways) && meet(asked.ball.parts()[p], moved, face, ways);
  };
  return any_pair(asked.ball, asked.socket, are_apart, meets, asked.pairs);
}

bool NearBodies::may_meet(const Asked& asked) const {
  return any_close(asked,
                   [](const TurnFace&, const TurnFace&, const TurnFace&, const Ways&) { return true; });
}

std::optional<ApartPlane> ClosePair::plane(std::size_t k) const {
  ApartPlane plane{Vec3::Zero(), HUGE_VAL, 0.0};
  if (k < ways.size()) {
    plane.normal = ways[k];
  } else {
    const std::size_t i = k / 3 - 1;
    const std::size_t j = k % 3;
    const Vec3 n = (moved[(i + 1) % 3] - moved[i]).cross(of_socket[(j + 1) % 3] - of_socket[j]);
    plane.normal = (n.dot(of_socket[j] - moved[i]) < 0.0 ? Vec3(-n) : n).stableNormalized();
  }
  double most = -HUGE_VAL;  // of the ball
  for (const Vec3& x : moved) most = std::max(most, plane.normal.dot(x));
  for (const Vec3& y : of_socket) plane.least = std::min(plane.least, plane.normal.dot(y) - gap);
  plane.angle = (plane.least - most) / (plane.normal.cross(moved[0]).norm() + kLeastArm);
  return plane.angle > kRounding ? std::optional(plane) : std::nullopt;
}

bool NearBodies::each_close(const Asked& asked, const TakeClose& take) const {
  const auto stops = [&](const TurnFace& a, const TurnFace& moved, const TurnFace& face, const Ways& ways) {
    return !take({a.corner, moved.corner, face.corner, ways, more_});
  };
  std::vector<std::pair<double, NodePairs::value_type>> nearest;
  for (const auto& pair : asked.ball.empty() || asked.socket.empty() ? NodePairs() : asked.pairs) {
    const SweptParts::Node& a = asked.ball.nodes()[pair.first];
    const SweptParts::Node& b = asked.socket.nodes()[pair.second];
    nearest.emplace_back((turned(a.centre) - seen(b.centre)).norm() - a.radius - b.radius, pair);
  }
  std::ranges::sort(nearest, std::greater());  // the search takes the last one first
  NodePairs pairs;
  for (const auto& [distance, pair] : nearest) pairs.push_back(pair);
  return !any_close({asked.ball, asked.socket, asked.told, pairs}, stops);
}

// Calls take(points) for a point of each face and each inner ball until it is true; returns whether it was.
// Nodes with the centres p, as R turns it, and y are left out where far(p, y, reach).
template <class Far, class Take>
bool NearBodies::any_within_reach(const BodyTrees& ball, const BodyTrees& socket, const Far& far,
                                  const Take& take) const {
  const double more = gap_ - poses_.shift_mm;
  const auto any = [&](const SweptParts& of_ball, const SweptParts& of_socket, const auto& points) {
    const auto apart = [&](std::uint32_t p, std::uint32_t q) {
      const SweptParts::Node& a = of_ball.nodes()[p];
      const SweptParts::Node& b = of_socket.nodes()[q];
      const double reach = a.radius + b.radius + more;
      return reach < 0.0 ||
             std::max(a.nearest - b.farthest, b.nearest - a.farthest) > std::max(0.0, more) + away_ ||
             far(turned(a.centre), seen(b.centre), reach);
    };
    return any_pair(of_ball, of_socket, apart, [&](std::uint32_t p, std::uint32_t q) {
      const WithinReach at = points(of_ball.parts()[p], seen(of_socket.parts()[q]));
      return at.reach > 0.0 && take(at);
    });
  };
  const auto of_inner = [&](const TurnFace& inner, const TurnFace& face) -> WithinReach {
    const Vec3 c = turned(inner.corner[0]);
    return {inner.corner[0], nearest_point(c, face.corner), inner.doubt + more};
  };
  const auto in_inner = [&](const TurnFace& face, const TurnFace& inner) -> WithinReach {
    const Vec3& c = inner.corner[0];
    const Triangle at{turned(face.corner[0]), turned(face.corner[1]), turned(face.corner[2])};
    return {poses_.rotation.transpose() * nearest_point(c, at), c, inner.doubt + more};
  };
  return any(ball.inner, socket.faces, of_inner) || any(ball.faces, socket.inner, in_inner);
}

bool NearBodies::stay_in_contact(const BodyTrees& ball, const BodyTrees& socket) const {
  const auto far = [&](const Vec3& p, const Vec3& y, double reach) {
    return (p - y).squaredNorm() > reach * reach || most_squared(p, y) > reach * reach;
  };
  return any_within_reach(ball, socket, far, [&](const WithinReach& at) {
    return most_squared(turned(at.of_ball), at.of_socket) <= at.reach * at.reach;
  });
}

std::vector<WithinReach> NearBodies::deepest(const BodyTrees& ball, const BodyTrees& socket,
                                             std::size_t most) const {
  std::vector<WithinReach> found;
  std::vector<double> depth;
  double least = 0.0;
  const auto far = [&](const Vec3& p, const Vec3& y, double reach) {
    const double wanted = reach - least;
    return (p - y).squaredNorm() > wanted * wanted;  // below 0 nothing is deeper, as is found later
  };
  const auto same_ball = [&](const WithinReach& a, const WithinReach& b) {
    return a.reach == b.reach && (a.of_ball == b.of_ball || a.of_socket == b.of_socket);
  };
  any_within_reach(ball, socket, far, [&](const WithinReach& at) {
    const double deep = at.reach - (turned(at.of_ball) - at.of_socket).norm();
    if (deep <= least) return false;
    std::size_t k = 0;
    while (k < found.size() && !same_ball(found[k], at)) ++k;
    if (k == found.size() && k == most)
      k = static_cast<std::size_t>(std::min_element(depth.begin(), depth.end()) - depth.begin());
    if (k == found.size()) {
      found.push_back(at);
      depth.push_back(deep);
    } else if (deep > depth[k]) {
      found[k] = at;
      depth[k] = deep;
    }
    if (found.size() == most) least = *std::min_element(depth.begin(), depth.end());
    return false;
  });
  return found;
}

namespace {

// The point of the faces that is nearest to x, if it is nearer than `within`.
std::optional<Vec3> nearest_within(const SweptParts& faces, const Vec3& x, double within) {
  std::optional<Vec3> found;
  std::vector<std::uint32_t> pending{0};
  while (!pending.empty()) {
    const SweptParts::Node& node = faces.nodes()[pending.back()];
    pending.pop_back();
    const double reach = within + node.radius;
    if ((node.centre - x).squaredNorm() >= reach * reach) continue;
    if (!node.leaf) {
      const bool first = (faces.nodes()[node.at].centre - x).squaredNorm() <
                         (faces.nodes()[node.at + 1].centre - x).squaredNorm();
      pending.push_back(first ? node.at + 1 : node.at);
      pending.push_back(first ? node.at : node.at + 1);
      continue;
    }
    const Vec3 y = nearest_point(x, faces.parts()[node.at].corner);
    const double distance = (y - x).norm();
    if (distance >= within) continue;
    within = distance;
    found = y;
  }
  return found;
}

// A ball that touches a surface.
struct TouchingBall {
  Vec3 at;  // where it touches
  Vec3 centre;
  double radius;  // mm
};

// Finds balls that touch a surface and hold no point of it, up to kTouches.
class TouchingBalls {
 public:
  explicit TouchingBalls(const SweptParts& faces) : faces_(faces) {
    const std::size_t step = 1 + faces.parts().size() / kFirstLook;
    for (std::size_t f = 0; f < faces.parts().size(); f += step) some_.push_back(faces.parts()[f].corner[0]);
  }

  // The largest ball that touches at v and lies on the side of the unit normal `side`.
  TouchingBall at(const Vec3& v, const Vec3& side) const {
    TouchingBall ball{v, v, faces_.nodes()[0].radius};
    for (const Vec3& y : some_) shrink(ball, side, y);
    for (int k = 0; k < kMostShrinks; ++k) {
      const auto y = nearest_within(faces_, v + ball.radius * side, ball.radius * (1.0 - kTouches));
      if (!y) break;
      shrink(ball, side, *y);
    }
    ball.centre = v + ball.radius * side;
    return ball;
  }

 private:
  static constexpr std::size_t kFirstLook = 500;  // points
  static void shrink(TouchingBall& ball, const Vec3& side, const Vec3& y) {
    const double height = side.dot(y - ball.at);
    if (height > 0.0) ball.radius = std::min(ball.radius, (y - ball.at).squaredNorm() / (2.0 * height));
  }

  const SweptParts& faces_;
  std::vector<Vec3> some_;
};

// Is the place within `near` of one of these balls?
template <class Balls>
bool is_near(const Vec3& at, const Balls& balls, double near) {
  return std::any_of(balls.begin(), balls.end(), [&](const TouchingBall& ball) {
    const double reach = ball.radius + near;
    return (at - ball.centre).squaredNorm() <= reach * reach;
  });
}

// Keeps so many of the balls, the largest first, that each other one touches the surface within `near` of a
// kept one.
SweptParts covering(std::span<const TouchingBall> balls, double near) {
  std::vector<TouchingBall> kept;
  std::vector<TurnFace> points;
  for (const TouchingBall& ball : balls) {
    if (is_near(ball.at, kept, near)) continue;
    kept.push_back(ball);
    points.push_back(turn_point(ball.centre));
    points.back().doubt = ball.radius;
  }
  return SweptParts(std::move(points));
}

}  // namespace

InnerBalls::InnerBalls(const SweptParts& faces, const BodyInside& inside) {
  if (faces.empty()) return;
  const double size = faces.nodes()[0].radius;
  const TouchingBalls touching(faces);
  const double finest = kNear.back() * size;
  std::vector<TouchingBall> balls;
  const auto measured = [&](const Vec3& v, const Vec3& c) -> std::optional<TouchingBall> {
    if (!is_near(c, balls, 0.0) && !inside.holds(c)) return std::nullopt;  // a point of a ball is inside
    const auto nearest = nearest_within(faces, c, HUGE_VAL);
    TouchingBall ball{v, c, std::min((*nearest - c).norm(), inside.to_opening(c))};
    faces.visit_near(c, ball.radius, [&](std::uint32_t f) {
      ball.radius = std::min(ball.radius, least_distance(c, faces.parts()[f]));
    });
    ball.radius -= kRounding * (c.norm() + size);
    return ball;
  };
  const auto take = [&](const Vec3& v, const Vec3& side) {
    if (!inside.holds) return false;
    // Starts a little below the surface: beside v the faces may be bent towards the ball.
    const TouchingBall touches = touching.at(v + 2.0 * finest * side, side);
    const auto ball = touches.radius > finest ? measured(v, touches.centre) : std::nullopt;
    if (ball && ball->radius > finest) balls.push_back(*ball);
    return ball.has_value();
  };
  const std::size_t step = 1 + faces.parts().size() / kMostAsked;
  std::vector<TouchingBall> bare;
  for (std::size_t f = 0; f < faces.parts().size(); f += step) {
    const TurnFace& face = faces.parts()[f];
    const double length = face.normal.norm();
    if (!(length > 0.0)) continue;
    const Vec3 v = (face.corner[0] + face.corner[1] + face.corner[2]) / 3.0;
    const Vec3 side = face.normal / length;
    if (is_near(v, balls, finest)) continue;
    if (!take(v, -side) && !take(v, side)) bare.push_back({v, v, 0.0});
  }
  if (balls.empty()) balls = std::move(bare);
  std::stable_sort(balls.begin(), balls.end(),
                   [](const TouchingBall& a, const TouchingBall& b) { return a.radius > b.radius; });
  // No rotation moves the ball about the centre. It comes first, so that every level has it.
  const auto still = inside.holds ? measured(Vec3::Zero(), Vec3::Zero()) : std::nullopt;
  if (still && still->radius > finest)
    balls.insert(balls.begin(),
                 {*nearest_within(faces, Vec3::Zero(), HUGE_VAL), still->centre, still->radius});
  for (std::size_t k = 0; k < kNear.size(); ++k) levels_[k] = covering(balls, kNear[k] * size);
}

const SweptParts& InnerBalls::of(double turn) const {
  std::size_t level = 0;
  while (level + 1 < kNear.size() && kNear[level] > kOfWay * turn) ++level;
  return levels_[level];
}

}  // namespace impinge
