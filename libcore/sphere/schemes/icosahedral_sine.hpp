// SPDX-License-Identifier: GPL-3.0-or-later
// The sine-warped icosahedral grid: the node that is (i, j, k) / n of the way to the corners a, b, c of a
// face lies along sin(i w / n) a + sin(j w / n) b + sin(k w / n) c with w = 1.2 rad; see
// sphere/icosahedral_grid.hpp.
//
// With w the angle of an edge (63.4 degrees) edges are divided equally; 1.2 rad evens out the cells: the best
// covering constant of the schemes here, N rho^2 = 5.236 at 52,000 entries, limit 5.224. Lookup solves
//   asin(m l_1) + asin(m l_2) + asin(m l_3) = w
// for m, where l are the barycentric coordinates on the flat face: Newton's method from above falls to the
// root of this convex function. The rows of entries that stand for the equator bulge by up to 0.8 degrees.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "sphere/icosahedral_grid.hpp"

namespace impinge {

/// The warp of IcosahedralGrid that evens out the cells.
struct SineIcosahedralWarp {
  static constexpr std::string_view name = "icosahedral_sine";
  static constexpr std::string_view label = "Icosahedral, sine-warped";
  static constexpr std::string_view citation =
      "spherical linear interpolation of Shoemake 1985 (SIGGRAPH), for three corners and with w = 1.2 rad";

  static constexpr bool kFlatCells = false;
  static constexpr double kAngle = 1.2;  // w, radians

  static double weight(std::size_t k, std::size_t n) {
    return std::sin(kAngle * static_cast<double>(k) / static_cast<double>(n));
  }

  static Vec3 fractions(const Vec3& lambda) {
    const Vec3 angle = angles(lambda, scale(lambda));
    return angle / angle.sum();
  }

  /// First order in the distance from the middle of the range, and a bound on the second derivative for the
  /// rest. With u_k = k-th fraction and c_k = 1 / (w cos(w u_k)),
  ///   du_k = m c_k (dl_k - l_k sum(c dl) / sum(c l)).
  static void widen(TriangleRange& range) {
    const Vec3 sum = range.low + range.high;
    const Vec3 middle = sum / sum.sum();
    const Vec3 half = (range.high - middle).cwiseMax(middle - range.low);
    const double m = scale(middle);
    const Vec3 angle = angles(middle, m);
    const Vec3 c = angle.array().cos().inverse() / kAngle;
    const double mean = c.dot(middle);
    const double rest = 0.5 * kMostBend * half.squaredNorm();
    for (Eigen::Index k = 0; k < 3; ++k) {
      double reach = rest;
      for (Eigen::Index l = 0; l < 3; ++l) {
        reach += m * c[k] * std::abs((k == l ? 1.0 : 0.0) - middle[k] * c[l] / mean) * half[l];
      }
      range.low[k] = std::max(angle[k] / kAngle - reach, 0.0);
      range.high[k] = std::min(angle[k] / kAngle + reach, 1.0);
    }
  }

  /// Largest second derivative of a fraction along a unit step of l over the face, 0.66 at the corners, and a
  /// margin.
  static constexpr double kMostBend = 0.8;

  /// w |a - b| / sin w: edges of cells are longest across from the corners of the icosahedron.
  static constexpr double kLongestWay = kAngle * Icosahedron::kEdge / 0.9320390859672263;

 private:
  static Vec3 angles(const Vec3& lambda, double m) { return (m * lambda).array().asin(); }

  /// Returns m. Newton's method starts at the lesser of two upper bounds, by asin(x) >= x and as no angle is
  /// above w.
  static double scale(const Vec3& lambda) {
    constexpr double sine = 0.9320390859672263;  // sin w
    constexpr double negligible = 1e-9;          // the error is about ten times the square of the last step
    constexpr int most_steps = 20;               // three to five are taken
    double m = std::min(kAngle / lambda.sum(), sine / lambda.maxCoeff());
    for (int step = 0; step < most_steps; ++step) {
      const Vec3 x = m * lambda;
      const double excess = x.array().asin().sum() - kAngle;
      const double slope = (lambda.array() / (1.0 - x.array().square()).sqrt()).sum();
      m -= excess / slope;
      if (std::abs(excess) < negligible * slope) break;
    }
    return m;
  }
};

using IcosahedralSine = IcosahedralGrid<SineIcosahedralWarp>;

static_assert(PlaneExactScheme<IcosahedralSine>);

}  // namespace impinge
