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

  // How far u is inside the cone over the face, as a sine; u a unit vector.
  static long double inside(const LongFace& face, const LongVec& u) {
    const long double side = face[0].dot(face[1].cross(face[2])) > 0 ? 1 : -1;
    long double least = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const LongVec across = face[k].cross(face[(k + 1) % 3]);
      least = std::min(least, side * across.dot(u) / std::max(across.norm(), 1e-30L));
    }
    return least;
  }

  static long double radius_on(const LongFace& face, const LongVec& u) {
    const LongVec normal = (face[1] - face[0]).cross(face[2] - face[0]);
    return normal.dot(face[0]) / normal.dot(u);
  }

  static long double radius(const std::vector<LongFace>& faces, const LongVec& x, long double margin,
                            bool nearest) {
    long double found = nearest ? std::numeric_limits<long double>::infinity() : -1e30L;
    const LongVec u = x.normalized();
    for (const LongFace& face : faces) {
      if (!(inside(face, u) > margin)) continue;
      const long double r = radius_on(face, u);
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
    long double depth = -std::numeric_limits<long double>::infinity();
    for (const LongFace& ball : balls) {
      for (const LongFace& socket : sockets) {
        const auto ask = [&](const LongVec& u) {
          if (!(inside(ball, u) > margin && inside(socket, u) > margin)) return;
          depth = std::max(depth, radius_on(ball, u) - radius_on(socket, u));
        };
        // Corners and crossings are on borders of the common cone: asked for within it.
        std::vector<LongVec> rays;
        for (std::size_t i = 0; i < 3; ++i) {
          if (inside(socket, ball[i].normalized()) > margin) rays.push_back(ball[i].normalized());
          if (inside(ball, socket[i].normalized()) > margin) rays.push_back(socket[i].normalized());
          for (std::size_t j = 0; j < 3; ++j) add_crossing(ball, i, socket, j, rays);
        }
        LongVec middle = LongVec::Zero();
        for (const LongVec& ray : rays) middle += ray;
        for (const LongVec& ray : rays) {
          ask(ray);
          ask((ray + 1e-9L * middle).normalized());
        }
      }
    }
    return depth;
  }

  static void add_crossing(const LongFace& a, std::size_t i, const LongFace& b, std::size_t j,
                           std::vector<LongVec>& rays) {
    const LongVec& a0 = a[i];
    const LongVec& a1 = a[(i + 1) % 3];
    const LongVec& b0 = b[j];
    const LongVec& b1 = b[(j + 1) % 3];
    const LongVec line = a0.cross(a1).normalized().cross(b0.cross(b1).normalized());
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
