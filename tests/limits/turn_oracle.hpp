// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of a joint decided by brute force in long double: no tree, no closed form, no code of the library's.
//
// Two triangles meet surely where a side of one crosses the other by more than rounding, and perhaps where
// they are no farther apart than rounding: the distance of two triangles that do not cross is that of a
// corner and a face, or of two sides.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/ball_socket_pair.hpp"

namespace impinge::test {

using LongVec = Eigen::Matrix<long double, 3, 1>;

// A triangle and what each pose asks of it again and again.
struct OracleFace {
  std::array<LongVec, 3> corners;
  LongVec normal;                  // unit vector
  std::array<LongVec, 3> inwards;  // unit vectors in its plane, across the sides
  LongVec middle;
  long double radius;  // of a sphere about the middle

  explicit OracleFace(const std::array<LongVec, 3>& at)
      : corners(at),
        normal((at[1] - at[0]).cross(at[2] - at[0]).normalized()),
        middle((at[0] + at[1] + at[2]) / 3.0L),
        radius(0) {
    for (std::size_t k = 0; k < 3; ++k) {
      inwards[k] = normal.cross(at[(k + 1) % 3] - at[k]).normalized();
      radius = std::max(radius, (at[k] - middle).norm());
    }
  }

  OracleFace moved(const Eigen::Matrix<long double, 3, 3>& rotation, const LongVec& shift) const {
    OracleFace face(*this);
    for (LongVec& x : face.corners) x = rotation * x + shift;
    for (LongVec& n : face.inwards) n = rotation * n;
    face.normal = rotation * normal;
    face.middle = rotation * middle + shift;
    return face;
  }

  // How far x, in the plane of the face, is inside of its sides, mm.
  long double inside(const LongVec& x) const {
    return std::min(
        {inwards[0].dot(x - corners[0]), inwards[1].dot(x - corners[1]), inwards[2].dot(x - corners[2])});
  }
  // Does the segment cross the face, by more than a margin of its ends and of the crossing? mm.
  bool crossed_by(const LongVec& p, const LongVec& q, long double margin) const {
    const long double from = normal.dot(p - corners[0]);
    const long double to = normal.dot(q - corners[0]);
    if (!(std::min(from, to) < -margin && std::max(from, to) > margin)) return false;
    return inside(p + from / (from - to) * (q - p)) > margin;
  }
  long double distance(const LongVec& x) const {
    const long double height = normal.dot(x - corners[0]);
    if (inside(x - height * normal) >= 0) return std::abs(height);
    long double least = std::numeric_limits<long double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const LongVec side = corners[(k + 1) % 3] - corners[k];
      const long double share = std::clamp(side.dot(x - corners[k]) / side.squaredNorm(), 0.0L, 1.0L);
      least = std::min(least, (corners[k] + share * side - x).norm());
    }
    return least;
  }
};

inline bool crossing(const OracleFace& a, const OracleFace& b, long double margin) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.crossed_by(b.corners[k], b.corners[(k + 1) % 3], margin) ||
        b.crossed_by(a.corners[k], a.corners[(k + 1) % 3], margin))
      return true;
  }
  return false;
}

// Of the inner points of two sides that are nearest to each other; those with an end are of a corner and a
// face.
inline long double distance_of_sides(const LongVec& p, const LongVec& q, const LongVec& r, const LongVec& s) {
  const LongVec across = (q - p).cross(s - r);
  const long double squared = across.squaredNorm();
  if (!(squared > 0)) return std::numeric_limits<long double>::infinity();
  const long double along = (r - p).cross(s - r).dot(across) / squared;
  const long double other = (r - p).cross(q - p).dot(across) / squared;
  const bool inner = along >= 0 && along <= 1 && other >= 0 && other <= 1;
  return inner ? std::abs(across.dot(r - p)) / std::sqrt(squared)
               : std::numeric_limits<long double>::infinity();
}

inline long double distance(const OracleFace& a, const OracleFace& b) {
  if (crossing(a, b, 0)) return 0;
  long double least = std::numeric_limits<long double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min({least, a.distance(b.corners[k]), b.distance(a.corners[k])});
    for (std::size_t l = 0; l < 3; ++l)
      least = std::min(least, distance_of_sides(a.corners[k], a.corners[(k + 1) % 3], b.corners[l],
                                                b.corners[(l + 1) % 3]));
  }
  return least;
}

// Where a joint really turns: both meshes about a common centre, the ball shifted besides.
struct OracleCentre {
  Vec3 centre = Vec3::Zero();  // mm
  Vec3 shift = Vec3::Zero();   // mm
};

// Decides poses of one turn: x -> R(axis, angle) x + shift for the ball, about the centre.
class TurnOracle {
 public:
  static constexpr long double kMargin = 1e-11L;  // of directions
  static constexpr long double kDepth = 1e-8L;    // mm, more than rounding

  TurnOracle(const BallSocketPair& joint, const Vec3& axis, const OracleCentre& at = {})
      : ball_(faces(joint.ball, at.centre)),
        socket_(faces(joint.socket, at.centre)),
        axis_(axis.cast<long double>().normalized()),
        shift_(at.shift.cast<long double>()) {
    for (const OracleFace& face : ball_) {
      for (const LongVec& x : face.corners) arm_ = std::max(arm_, axis_.cross(x).norm());
    }
  }

  // Deeper than rounding.
  bool surely_meets(double angle_deg) const {
    const std::vector<OracleFace> ball = turned(angle_deg);
    return std::ranges::any_of(ball, [&](const OracleFace& a) {
      return std::ranges::any_of(socket_, [&](const OracleFace& b) {
        return (a.middle - b.middle).norm() <= a.radius + b.radius && crossing(a, b, kDepth);
      });
    });
  }
  // All but rounding.
  bool perhaps_meets(double angle_deg) const { return !(distance(turned(angle_deg)) > kDepth); }

  // Do the surfaces come as near as that, mm, in the turn up to there? No point moves farther than its arm
  // times the angle: what is left of the distance is no contact.
  bool meets_by(double angle_deg, long double near) const {
    long double at = 0;
    for (int steps = 0; at <= angle_deg && steps < kMostSteps; ++steps) {
      const long double apart = distance(turned(static_cast<double>(at)));
      if (apart <= near) return true;
      at += apart / arm_ * 180.0L / std::acos(-1.0L);
    }
    return at <= angle_deg || distance(turned(angle_deg)) <= near;
  }

  // The smallest gap of a vertex; directions within the margin of a border count if it is negative.
  long double smallest_gap(double angle_deg, long double margin) const {
    const std::vector<OracleFace> ball = turned(angle_deg);
    long double least = std::numeric_limits<long double>::infinity();
    for (const OracleFace& face : ball) {
      for (const LongVec& x : face.corners)
        least = std::min(least, radius(socket_, x, margin, true) - x.norm());
    }
    for (const OracleFace& face : socket_) {
      for (const LongVec& y : face.corners)
        least = std::min(least, y.norm() - radius(ball, y, margin, false));
    }
    return least;
  }

 private:
  static constexpr int kMostSteps = 20'000;  // of one turn; then it is not known

  static std::vector<OracleFace> faces(const TriangleMesh& mesh, const Vec3& centre) {
    std::vector<OracleFace> list;
    for (const Face& face : mesh.faces) {
      std::array<LongVec, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = corner(mesh, face, k).cast<long double>() - centre.cast<long double>();
      list.emplace_back(corners);
    }
    return list;
  }

  std::vector<OracleFace> turned(double angle_deg) const {
    const long double t = angle_deg * std::acos(-1.0L) / 180.0L;
    const Eigen::Matrix<long double, 3, 3> rotation =
        Eigen::AngleAxis<long double>(t, axis_).toRotationMatrix();
    std::vector<OracleFace> list;
    for (const OracleFace& face : ball_) list.push_back(face.moved(rotation, shift_));
    return list;
  }

  long double distance(const std::vector<OracleFace>& ball) const {
    long double least = std::numeric_limits<long double>::infinity();
    for (const OracleFace& a : ball) {
      for (const OracleFace& b : socket_) {
        if ((a.middle - b.middle).norm() - a.radius - b.radius < least)
          least = std::min(least, test::distance(a, b));
      }
    }
    return least;
  }

  // Along the ray through x.
  static long double radius(const std::vector<OracleFace>& faces, const LongVec& x, long double margin,
                            bool nearest) {
    long double found = nearest ? std::numeric_limits<long double>::infinity() : -1e30L;
    const LongVec u = x.normalized();
    for (const OracleFace& face : faces) {
      const auto& c = face.corners;
      const long double side = c[0].dot(c[1].cross(c[2])) > 0 ? 1 : -1;
      long double inside = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const LongVec across = side * c[k].cross(c[(k + 1) % 3]);
        inside = std::min(inside, across.dot(u) / std::max(across.norm(), 1e-30L));
      }
      if (!(inside > margin)) continue;
      const long double r = face.normal.dot(c[0]) / face.normal.dot(u);
      found = nearest ? std::min(found, r) : std::max(found, r);
    }
    return found;
  }

  std::vector<OracleFace> ball_;
  std::vector<OracleFace> socket_;
  LongVec axis_;
  LongVec shift_;
  long double arm_ = 1e-30L;  // mm, of the farthest corner from the axis
};

}  // namespace impinge::test
