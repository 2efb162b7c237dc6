// SPDX-License-Identifier: GPL-3.0-or-later
// The icosahedron with its corners on the unit sphere: the poles N and S, U_k at azimuth 72 k degrees and D_k
// at 72 k + 36, z = +-1 / sqrt(5).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "sphere/direction.hpp"

namespace impinge {

/// Two faces make one of ten diamonds with corners A, P, F, Q: faces 2 d and 2 d + 1 are A P Q and F Q P of
/// diamond d. Diamond k = 0..4 is (N, U_k, D_k, U_k+1) and diamond 5 + k is (U_k+1, D_k, S, D_k+1).
struct Icosahedron {
  /// A face, with the vectors that give the place of a direction on it.
  struct Face {
    std::array<Vec3, 3> corner;  // unit vectors, anticlockwise as seen from outside
    std::array<Vec3, 3> dual;    // dual[k] . corner[l] = 1 if k = l, else 0
    Vec3 axis;                   // sum of the duals: along the middle of the face
  };
  std::array<Face, 20> face;  // diamond d has the faces 2 d and 2 d + 1

  /// Angle between the middle of a face and its corners: tan = 3 - sqrt(5).
  static constexpr double kTangent = 0.7639320225002103;
  static constexpr double kCornerAngle = 0.6523581397843682;  // atan(kTangent), radians
  static constexpr double kEdge = 1.0514622242382672;         // length of an edge, 1 / sin 72 degrees

  /// The one icosahedron, made at first use.
  static const Icosahedron& instance();

  /// The face whose middle is nearest to the direction of x.
  std::size_t face_of(const Vec3& x) const {
    std::size_t nearest = 0;
    double largest = -1.0;
    bool behind = false;
    for (std::size_t f = 0; f < 10; ++f) {
      const double along = middle_[f].dot(x);
      if (std::abs(along) > largest) {
        largest = std::abs(along);
        nearest = f;
        behind = along < 0.0;
      }
    }
    return behind ? opposite_[nearest] : nearest;
  }

 private:
  Icosahedron();
  void set_diamond(std::size_t d, const Vec3& a, const Vec3& p, const Vec3& f, const Vec3& q);

  std::array<Vec3, 10> middle_;             // axes of the first ten faces
  std::array<std::size_t, 10> opposite_{};  // the faces opposite to them
};

}  // namespace impinge
