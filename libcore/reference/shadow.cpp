// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/shadow.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

namespace impinge {
namespace {

constexpr double kShadowSlack = 1e-9;  // in radians and as a share of a radius, far more than rounding

template <class Number>
using Triple = std::array<Number, 3>;

template <class Number>
Triple<Number> exactly(const Vec3& x) {
  return {Number(x.x()), Number(x.y()), Number(x.z())};
}

template <class Number>
Number dot(const Triple<Number>& a, const Triple<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
Triple<Number> minus(const Triple<Number>& a, const Triple<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// The points x with normal . x + offset >= 0.
template <class Number>
struct HalfSpace {
  Triple<Number> normal;
  Number offset;

  Number at(const Triple<Number>& x) const { return dot(normal, x) + offset; }
};

// The four half-spaces that bound a shadow, or a pyramid. Empty for a face whose plane holds the centre.
template <class Number>
std::vector<HalfSpace<Number>> bounds(const Triangle& face, bool shadow) {
  const std::array corner{exactly<Number>(face[0]), exactly<Number>(face[1]), exactly<Number>(face[2])};
  Triple<Number> normal = cross(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
  const CGAL::Sign side = CGAL::sign(dot(normal, corner[0]));
  if (side == CGAL::ZERO) return {};
  const Number turn = Number(side == CGAL::POSITIVE ? 1 : -1);
  std::vector<HalfSpace<Number>> planes;
  for (std::size_t k = 0; k < 3; ++k) {
    Triple<Number> plane = cross(corner[k], corner[(k + 1) % 3]);
    for (Number& component : plane) component = component * turn;
    planes.push_back({plane, Number(0)});
  }
  for (Number& component : normal) component = component * (shadow ? turn : -turn);
  planes.push_back({normal, -dot(normal, corner[0])});
  return planes;
}

template <class Number>
bool holds(const std::vector<HalfSpace<Number>>& planes, const Vec3& x) {
  const auto point = exactly<Number>(x);
  return !planes.empty() && std::ranges::all_of(planes, [&](const auto& plane) {
    const CGAL::Sign sign = CGAL::sign(plane.at(point));
    return sign != CGAL::NEGATIVE;
  });
}

// The part of a convex polygon in the half-space.
template <class Number>
std::vector<Triple<Number>> clipped(const std::vector<Triple<Number>>& polygon,
                                    const HalfSpace<Number>& half_space) {
  std::vector<Triple<Number>> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Triple<Number>& from = polygon[k];
    const Triple<Number>& to = polygon[(k + 1) % polygon.size()];
    const Number at_from = half_space.at(from);
    const Number at_to = half_space.at(to);
    const CGAL::Sign sign_from = CGAL::sign(at_from);
    const CGAL::Sign sign_to = CGAL::sign(at_to);
    if (sign_from != CGAL::NEGATIVE) kept.push_back(from);
    if (sign_from * sign_to != CGAL::NEGATIVE) continue;
    const Number share = at_from / (at_from - at_to);
    const Triple<Number> way = minus(to, from);
    kept.push_back({from[0] + share * way[0], from[1] + share * way[1], from[2] + share * way[2]});
  }
  return kept;
}

// Does the first face have a point in the shadow, or the pyramid, of the second?
template <class Number>
bool meets(const Triangle& cut, const Triangle& of, bool shadow) {
  const auto planes = bounds<Number>(of, shadow);
  std::vector<Triple<Number>> rest{exactly<Number>(cut[0]), exactly<Number>(cut[1]), exactly<Number>(cut[2])};
  for (const auto& plane : planes) rest = clipped(rest, plane);
  return !planes.empty() && !rest.empty();
}

// The answer of ask.template operator()<Number>(), by intervals if they decide, else by rationals.
template <class Ask>
bool answer(const Ask& ask) {
  try {
    const CGAL::Protect_FPU_rounding<true> upwards;
    return ask.template operator()<CGAL::Interval_nt<false>>();
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return ask.template operator()<CGAL::Exact_rational>();
  }
}

}  // namespace

bool in_shadow(const Vec3& x, const Triangle& face) {
  return answer([&]<class Number>() { return holds(bounds<Number>(face, true), x); });
}

bool in_pyramid(const Vec3& x, const Triangle& face) {
  return answer([&]<class Number>() { return holds(bounds<Number>(face, false), x); });
}

bool meets_shadow(const Triangle& ball, const Triangle& socket) {
  return answer([&]<class Number>() { return meets<Number>(ball, socket, true); });
}

bool meets_pyramid(const Triangle& socket, const Triangle& ball) {
  return answer([&]<class Number>() { return meets<Number>(socket, ball, false); });
}

bool covers_directions(const Triangle& face) {
  return answer([&]<class Number>() { return !bounds<Number>(face, true).empty(); });
}

// A corner at the centre has any direction.
ShadowReference::Seen ShadowReference::see(const Triangle& corners) {
  Seen seen{corners, Vec3::Zero(), 0.0, HUGE_VAL, 0.0};
  for (const Vec3& v : corners) seen.axis += v.stableNormalized();
  seen.axis.stableNormalize();
  for (const Vec3& v : corners) {
    seen.angle = std::max(seen.angle, v.isZero(0.0) ? kPi : angle_between(seen.axis, v) + kShadowSlack);
    seen.low = std::min(seen.low, seen.axis.dot(v) * (1.0 - kShadowSlack));
    seen.high = std::max(seen.high, v.norm() * (1.0 + kShadowSlack));
  }
  return seen;
}

// May two faces share directions? Caps of a quarter turn and more, and caps without an axis, may share them
// with any other. An angle is no less than its chord.
bool ShadowReference::share_directions(const Seen& a, const Seen& b) {
  if (a.angle >= 1.5 || b.angle >= 1.5 || a.axis.norm() < 0.5 || b.axis.norm() < 0.5) return true;
  return (a.axis - b.axis).norm() <= a.angle + b.angle;
}

ShadowReference::ShadowReference(const TriangleMesh& ball, const TriangleMesh& socket)
    : ball_vertices_(ball.vertices), socket_vertices_(socket.vertices) {
  for (const Face& f : ball.faces)
    ball_.push_back(see({corner(ball, f, 0), corner(ball, f, 1), corner(ball, f, 2)}));
  for (const Face& f : socket.faces)
    socket_.push_back(see({corner(socket, f, 0), corner(socket, f, 1), corner(socket, f, 2)}));
}

std::vector<bool> ShadowReference::ball_vertices_impinged() const {
  std::vector<bool> impinged(ball_vertices_.size());
  for (std::size_t i = 0; i < impinged.size(); ++i) {
    const Vec3& x = ball_vertices_[i];
    const Seen point = see({x, x, x});
    impinged[i] = !x.isZero(0.0) && std::ranges::any_of(socket_, [&](const Seen& face) {
      return point.high >= face.low && share_directions(point, face) && in_shadow(x, face.corners);
    });
  }
  return impinged;
}

std::vector<bool> ShadowReference::socket_vertices_impinged() const {
  std::vector<bool> impinged(socket_vertices_.size());
  for (std::size_t i = 0; i < impinged.size(); ++i) {
    const Vec3& y = socket_vertices_[i];
    const Seen point = see({y, y, y});
    impinged[i] = std::ranges::any_of(ball_, [&](const Seen& face) {
      return point.low <= face.high && share_directions(point, face) && in_pyramid(y, face.corners);
    });
  }
  return impinged;
}

// Asks about the pairs of faces that may share directions and in which the ball's face is not surely nearer.
template <class Meets>
bool ShadowReference::any_pair(const Meets& meets) const {
  double farthest = 0.0;
  for (const Seen& ball : ball_) farthest = std::max(farthest, ball.high);
  std::vector<Seen> within;  // faces of the socket that some face of the ball may reach
  std::ranges::copy_if(socket_, std::back_inserter(within),
                       [&](const Seen& one) { return one.low <= farthest; });
  double nearest = HUGE_VAL;
  for (const Seen& socket : within) nearest = std::min(nearest, socket.low);
  return std::ranges::any_of(ball_, [&](const Seen& ball) {
    return ball.high >= nearest && std::ranges::any_of(within, [&](const Seen& socket) {
             return ball.high >= socket.low && share_directions(ball, socket) &&
                    meets(ball.corners, socket.corners);
           });
  });
}

bool ShadowReference::ball_beyond_socket() const {
  return any_pair([](const Triangle& ball, const Triangle& socket) { return meets_shadow(ball, socket); });
}

bool ShadowReference::socket_within_ball() const {
  return any_pair([](const Triangle& ball, const Triangle& socket) { return meets_pyramid(socket, ball); });
}

}  // namespace impinge
