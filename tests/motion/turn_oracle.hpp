// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of a joint decided by brute force in long double: no tree, no closed form, no code of the library's.
//
// Along a common direction u of two faces n.x = p and m.x = q the ball reaches the socket if p / n.u >=
// q / m.u, a linear inequality in u: it holds somewhere in the common cone if it does at one of its extreme
// rays, which are corners of one face in the cone of the other and crossings of their edges.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/ball_socket_pair.hpp"

namespace impinge::test {

using LongVec = Eigen::Matrix<long double, 3, 1>;
using LongFace = std::array<LongVec, 3>;

// A face and what each pose asks of it again and again.
struct OracleFace {
  LongFace corners;
  LongFace units;    // directions of the corners
  LongFace inwards;  // unit normals of the planes through centre and edge
  LongVec normal;    // of the face, of any length

  explicit OracleFace(const LongFace& face)
      : corners(face), normal((face[1] - face[0]).cross(face[2] - face[0])) {
    const long double side = face[0].dot(face[1].cross(face[2])) > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const LongVec across = side * face[k].cross(face[(k + 1) % 3]);
      units[k] = face[k].normalized();
      inwards[k] = across / std::max(across.norm(), 1e-30L);
    }
  }

  // How far the unit vector u is inside the cone over the face, as a sine.
  long double inside(const LongVec& u) const {
    return std::min({inwards[0].dot(u), inwards[1].dot(u), inwards[2].dot(u)});
  }
  long double radius_on(const LongVec& u) const { return normal.dot(corners[0]) / normal.dot(u); }

  // The plane of an edge has the other face behind it, by far more than any margin.
  bool leaves_out(const OracleFace& other) const {
    constexpr long double kFar = 1e-6L;
    for (const LongVec& inward : inwards) {
      if (std::max({inward.dot(other.units[0]), inward.dot(other.units[1]), inward.dot(other.units[2])}) <
          -kFar)
        return true;
    }
    return false;
  }
};

// Where a joint really turns: both meshes about a common centre, the ball shifted besides.
struct OracleCentre {
  Vec3 centre = Vec3::Zero();  // mm
  Vec3 shift = Vec3::Zero();   // mm
};

// Decides poses of one turn: x -> R(axis, angle) x + shift for the ball, about the centre. Rays start at the
// centre of the socket and, where there is a shift, at that of the ball.
class TurnOracle {
 public:
  static constexpr long double kMargin = 1e-11L;  // of directions
  static constexpr long double kDepth = 1e-8L;    // mm

  TurnOracle(const BallSocketPair& joint, const Vec3& axis, const OracleCentre& at = {})
      : ball_(faces(joint.ball, at.centre)),
        socket_(faces(joint.socket, at.centre)),
        axis_(axis.cast<long double>().normalized()),
        shift_(at.shift.cast<long double>()) {}

  // Deeper than rounding, and inside the faces by more than it.
  bool surely_impinged(double angle_deg, long double margin = kMargin) const {
    return deepest(angle_deg, margin) > kDepth;
  }
  // All but rounding.
  bool perhaps_impinged(double angle_deg, long double margin = kMargin) const {
    return deepest(angle_deg, -margin) > -kDepth;
  }

  // The smallest gap of a vertex; directions within the margin of a border count if it is negative.
  long double smallest_gap(double angle_deg, long double margin) const {
    const std::vector<LongFace> ball = turned(angle_deg);
    long double least = std::numeric_limits<long double>::infinity();
    for (const LongFace& face : ball) {
      for (const LongVec& x : face) least = std::min(least, radius(socket_, x, margin, true) - x.norm());
    }
    for (const LongFace& face : socket_) {
      for (const LongVec& y : face) least = std::min(least, y.norm() - radius(ball, y, margin, false));
    }
    return least;
  }

 private:
  static std::vector<LongFace> faces(const TriangleMesh& mesh, const Vec3& centre) {
    std::vector<LongFace> list;
    for (const Face& face : mesh.faces) {
      LongFace& corners = list.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = corner(mesh, face, k).cast<long double>() - centre.cast<long double>();
    }
    return list;
  }

  std::vector<LongFace> turned(double angle_deg) const {
    const long double t = angle_deg * std::acos(-1.0L) / 180.0L;
    const Eigen::AngleAxis<long double> turn(t, axis_);
    const Eigen::Matrix<long double, 3, 3> rotation = turn.toRotationMatrix();
    std::vector<LongFace> list = ball_;
    for (LongFace& face : list) {
      for (LongVec& x : face) x = rotation * x;
    }
    return list;
  }

  static long double radius(const std::vector<LongFace>& faces, const LongVec& x, long double margin,
                            bool nearest) {
    long double found = nearest ? std::numeric_limits<long double>::infinity() : -1e30L;
    const LongVec u = x.normalized();
    for (const LongFace& corners : faces) {
      const OracleFace face(corners);
      if (!(face.inside(u) > margin)) continue;
      const long double r = face.radius_on(u);
      found = nearest ? std::min(found, r) : std::max(found, r);
    }
    return found;
  }

  static std::vector<LongFace> moved(std::vector<LongFace> faces, const LongVec& by) {
    for (LongFace& face : faces) {
      for (LongVec& x : face) x += by;
    }
    return faces;
  }

  long double deepest(double angle_deg, long double margin) const {
    const std::vector<LongFace> ball = turned(angle_deg);
    if (shift_.isZero(0)) return deepest(ball, socket_, margin);
    return std::max(deepest(moved(ball, shift_), socket_, margin),
                    deepest(ball, moved(socket_, -shift_), margin));
  }

  static long double deepest(const std::vector<LongFace>& balls, const std::vector<LongFace>& sockets,
                             long double margin) {
    const std::vector<OracleFace> others(sockets.begin(), sockets.end());
    long double depth = -std::numeric_limits<long double>::infinity();
    for (const LongFace& corners : balls) {
      const OracleFace ball(corners);
      for (const OracleFace& socket : others) {
        if (!ball.leaves_out(socket) && !socket.leaves_out(ball))
          depth = std::max(depth, deepest(ball, socket, margin));
      }
    }
    return depth;
  }

  static long double deepest(const OracleFace& ball, const OracleFace& socket, long double margin) {
    long double depth = -std::numeric_limits<long double>::infinity();
    const auto ask = [&](const LongVec& u) {
      if (!(ball.inside(u) > margin && socket.inside(u) > margin)) return;
      depth = std::max(depth, ball.radius_on(u) - socket.radius_on(u));
    };
    // Corners and crossings are on borders of the common cone: asked for within it.
    std::vector<LongVec> rays;
    for (std::size_t i = 0; i < 3; ++i) {
      if (socket.inside(ball.units[i]) > margin) rays.push_back(ball.units[i]);
      if (ball.inside(socket.units[i]) > margin) rays.push_back(socket.units[i]);
      for (std::size_t j = 0; j < 3; ++j) add_crossing(ball, i, socket, j, rays);
    }
    LongVec middle = LongVec::Zero();
    for (const LongVec& ray : rays) middle += ray;
    for (const LongVec& ray : rays) {
      ask(ray);
      ask((ray + 1e-9L * middle).normalized());
    }
    return depth;
  }

  static void add_crossing(const OracleFace& a, std::size_t i, const OracleFace& b, std::size_t j,
                           std::vector<LongVec>& rays) {
    const LongVec& a0 = a.corners[i];
    const LongVec& a1 = a.corners[(i + 1) % 3];
    const LongVec& b0 = b.corners[j];
    const LongVec& b1 = b.corners[(j + 1) % 3];
    const LongVec line = a.inwards[i].cross(b.inwards[j]);
    if (!(line.norm() > 1e-12L)) return;
    for (const long double sign : {1.0L, -1.0L}) {
      const LongVec u = sign * line.normalized();
      const bool on_a = a0.cross(u).dot(a0.cross(a1)) >= 0 && u.cross(a1).dot(a0.cross(a1)) >= 0;
      const bool on_b = b0.cross(u).dot(b0.cross(b1)) >= 0 && u.cross(b1).dot(b0.cross(b1)) >= 0;
      if (on_a && on_b) rays.push_back(u);
    }
  }

  std::vector<LongFace> ball_;
  std::vector<LongFace> socket_;
  LongVec axis_;
  LongVec shift_;
};

}  // namespace impinge::test
