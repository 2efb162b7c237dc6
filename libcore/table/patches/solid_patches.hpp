// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of interpolants that are linear on flat triangles or rectangles seen from the centre: bounds on how
// their directions move, and the triangles of the icosahedral grids.
//
// A triangle p, q, r is a rectangle with the point p for one side: x(s, t) = p + s ((1 - t) (q - p) + t (r -
// p)) is straight in s and in t.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

#include "sphere/icosahedral_grid.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/icosahedral_sine.hpp"
#include "table/patches/patch.hpp"

namespace impinge {

/// The corners x(from, from), x(to, from), x(from, to), x(to, to) of a surface patch x(s, t) and bounds on
/// its bending h^2 |d^2 x / ds^2|, h^2 |d^2 x / dt^2|.
struct ProjectedPatch {
  std::array<Vec3, 4> corner;       // see above
  std::array<double, 2> bending{};  // along s and along t
};

/// Bounds on the motion of u = x / |x|. With x' the derivative of x for the whole width, c its largest chord
/// and b its bending,
///   |x'| <= c + b_s / 2 + b_t / 4        (a chord is the mean of x', and changes by its own bending)
///   |u'| <= |x'| / |x|,   |acceleration of u along the sphere| <= b / |x| + 2 |u . x'| |u'| / |x|.
inline PatchMotion projected_motion(const ProjectedPatch& patch) {
  const auto& x = patch.corner;
  const Vec3 middle = 0.25 * (x[0] + x[1] + x[2] + x[3]);
  const std::array<std::array<Vec3, 2>, 2> chord{{{x[1] - x[0], x[3] - x[2]}, {x[2] - x[0], x[3] - x[1]}}};
  std::array<double, 2> rate{};
  for (std::size_t k = 0; k < 2; ++k) {
    rate[k] = std::max(chord[k][0].norm(), chord[k][1].norm()) + 0.5 * patch.bending[k] +
              0.25 * patch.bending[1 - k];
  }
  // How far x can be from the mean of the corners, which is off the middle by a quarter of the bending at
  // most.
  const double spread = 0.5 * (rate[0] + rate[1]) + 0.25 * (patch.bending[0] + patch.bending[1]);
  const double least = middle.norm() - spread;
  PatchMotion motion;
  if (!(least > 0.0)) {
    motion.way = {kPi, kPi};
    motion.smooth = false;
    return motion;
  }
  const Vec3 axis = middle.normalized();
  for (std::size_t k = 0; k < 2; ++k) {
    const double along = std::max(std::abs(axis.dot(chord[k][0])), std::abs(axis.dot(chord[k][1]))) +
                         0.5 * patch.bending[k] + 0.25 * patch.bending[1 - k] + rate[k] * spread / least;
    motion.way[k] = rate[k] / least;
    motion.turn[k] = (patch.bending[k] + 2.0 * std::min(along, rate[k]) * motion.way[k]) / least;
  }
  return motion;
}

/// The triangles of an icosahedral grid. If `flat`, they lie on the flat faces, for the `mesh_exact`
/// interpolant, and at() is a point of the icosahedron; else they lie in the fractions of the warp.
template <class Warp>
class IcosahedralPatches {
 public:
  /// For the grid that divides each edge into so many steps.
  IcosahedralPatches(std::size_t divisions, bool flat) : n_(divisions), flat_(flat || Warp::kFlatCells) {}

  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t face = 0; face < 20; ++face) {
      for (std::size_t i = 0; i < n_; ++i) {
        for (std::size_t j = 0; i + j < n_; ++j) {
          visit(Patch{number(face, i, j, 0), {{0.0, 0.0}, {1.0, 1.0}}});
          if (i + j + 2 <= n_) visit(Patch{number(face, i, j, 1), {{0.0, 0.0}, {1.0, 1.0}}});
        }
      }
    }
  }

  Vec3 at(const Patch& patch, double s, double t) const {
    const auto& corner = Icosahedron::instance().face[face_of(patch)].corner;
    const std::array<Vec3, 3> node = nodes(patch);
    const Vec3 place = node[0] + s * ((1.0 - t) * (node[1] - node[0]) + t * (node[2] - node[0]));
    const Vec3 weight = flat_ ? place : weights(place);
    return weight[0] * corner[0] + weight[1] * corner[1] + weight[2] * corner[2];
  }

  PatchMotion motion(const Patch& patch, const Rect& rect) const {
    ProjectedPatch projected{{at(patch, rect.from[0], rect.from[1]), at(patch, rect.to[0], rect.from[1]),
                              at(patch, rect.from[0], rect.to[1]), at(patch, rect.to[0], rect.to[1])}};
    if (!flat_) projected.bending = bendings(patch, rect);
    return projected_motion(projected);
  }

 private:
  std::size_t number(std::size_t face, std::size_t i, std::size_t j, std::size_t upside_down) const {
    return ((face * n_ + i) * n_ + j) * 2 + upside_down;
  }
  std::size_t face_of(const Patch& patch) const { return patch.part / (2 * n_ * n_); }

  /// Barycentric coordinates of the corners of the patch, on the flat face, or their fractions.
  std::array<Vec3, 3> nodes(const Patch& patch) const {
    const std::size_t place = patch.part / 2;
    const std::size_t i = place / n_ % n_;
    const std::size_t j = place % n_;
    const bool upright = patch.part % 2 == 0;
    return {upright ? node(i, j) : node(i + 1, j + 1), node(i + 1, j), node(i, j + 1)};
  }
  Vec3 node(std::size_t i, std::size_t j) const {
    const std::size_t first = n_ - i - j;
    if (!flat_) {
      return Vec3(static_cast<double>(first), static_cast<double>(i), static_cast<double>(j)) /
             static_cast<double>(n_);
    }
    const Vec3 weight(Warp::weight(first, n_), Warp::weight(i, n_), Warp::weight(j, n_));
    return weight / weight.sum();
  }

  static Vec3 weights(const Vec3& fraction) {
    if constexpr (kSine) {
      return (Warp::kAngle * fraction).array().sin();
    } else {
      return fraction;
    }
  }

  /// x = sum sin(w f_k) c_k bends by at most sum w^2 sin(w f_k) (df_k)^2 along a straight line of f.
  std::array<double, 2> bendings(const Patch& patch, const Rect& rect) const {
    std::array<double, 2> bending{};
    if constexpr (kSine) {
      const std::array<Vec3, 3> f = nodes(patch);
      const Vec3 most = weights(f[0].cwiseMax(f[1]).cwiseMax(f[2]));
      const Vec3 along_s = (f[1] - f[0]).cwiseAbs().cwiseMax((f[2] - f[0]).cwiseAbs()) * rect.width(0);
      const Vec3 along_t = (f[2] - f[1]).cwiseAbs() * (rect.width(1) * rect.to[0]);
      const double square = Warp::kAngle * Warp::kAngle;
      bending = {square * most.dot(along_s.cwiseAbs2()), square * most.dot(along_t.cwiseAbs2())};
    }
    return bending;
  }

  static constexpr bool kSine = std::same_as<Warp, SineIcosahedralWarp>;

  std::size_t n_;
  bool flat_;
};

/// A grid with another curved warp declares flat patches only.
template <class Warp>
requires(Warp::kFlatCells || std::same_as<Warp, SineIcosahedralWarp>)
    IcosahedralPatches<Warp> patches_of(const IcosahedralGrid<Warp>& scheme) {
  return {scheme.divisions(), false};
}

}  // namespace impinge
