// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to a mesh by brute force in numbers of more than 200 bits (MPFR), rounded to double once.
//
// A determinant of three vectors of doubles needs 159 bits and a few more where their exponents differ: with
// coordinates of one scale its sign is that of the exact value.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include <boost/multiprecision/mpfr.hpp>

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "table/layer.hpp"

namespace impinge::test {

using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<75>,
                                              boost::multiprecision::et_off>;
using PreciseVec = std::array<Precise, 3>;

inline PreciseVec precise(const Vec3& x) { return {Precise(x.x()), Precise(x.y()), Precise(x.z())}; }

inline PreciseVec minus(const PreciseVec& a, const PreciseVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline PreciseVec cross(const PreciseVec& a, const PreciseVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Precise dot(const PreciseVec& a, const PreciseVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Precise det(const PreciseVec& a, const PreciseVec& b, const PreciseVec& c) {
  return dot(a, cross(b, c));
}

// t with t u on the closed face, by Cramer's rule: u = sum of w_k times corner k, t = 1 / (w_0 + w_1 + w_2).
inline std::optional<Precise> place_on_face(const TriangleMesh& mesh, const Face& face, const Vec3& u) {
  const PreciseVec a = precise(corner(mesh, face, 0));
  const PreciseVec b = precise(corner(mesh, face, 1));
  const PreciseVec c = precise(corner(mesh, face, 2));
  const PreciseVec d = precise(u);
  const Precise whole = det(a, b, c);
  if (whole == 0) return std::nullopt;
  const std::array<Precise, 3> weight{det(d, b, c) / whole, det(a, d, c) / whole, det(a, b, d) / whole};
  for (const Precise& w : weight) {
    if (w < 0) return std::nullopt;
  }
  return 1 / (weight[0] + weight[1] + weight[2]);
}

inline double precise_radius(const TriangleMesh& mesh, const Vec3& u, Layer layer) {
  std::optional<Precise> kept;
  for (const Face& face : mesh.faces) {
    const auto t = place_on_face(mesh, face, u);
    if (!t) continue;
    if (!kept || (layer == Layer::nearest ? *t < *kept : *t > *kept)) kept = t;
  }
  if (!kept) return kNoSurface;
  return Precise(*kept * sqrt(dot(precise(u), precise(u)))).convert_to<double>();
}

// Squared distance from a segment: the foot on the line, held between the ends.
inline Precise squared_distance(const PreciseVec& x, const PreciseVec& from, const PreciseVec& to) {
  const PreciseVec e = minus(to, from);
  const Precise length = dot(e, e);
  Precise share = length == 0 ? Precise(0) : Precise(dot(e, minus(x, from)) / length);
  if (share < 0) share = 0;
  if (share > 1) share = 1;
  const PreciseVec foot{from[0] + share * e[0], from[1] + share * e[1], from[2] + share * e[2]};
  return dot(minus(x, foot), minus(x, foot));
}

// Squared distance from a face: that of the nearest side, or of the plane if the foot on it has three weights
// above zero.
inline Precise squared_distance(const PreciseVec& x, const std::array<PreciseVec, 3>& c) {
  Precise least = squared_distance(x, c[0], c[1]);
  for (std::size_t k = 1; k < 3; ++k) {
    const Precise side = squared_distance(x, c[k], c[(k + 1) % 3]);
    if (side < least) least = side;
  }
  const PreciseVec n = cross(minus(c[1], c[0]), minus(c[2], c[0]));
  const Precise area = dot(n, n);
  for (std::size_t k = 0; k < 3; ++k) {
    const PreciseVec across = cross(minus(c[(k + 1) % 3], c[k]), minus(x, c[k]));
    if (dot(across, n) <= 0) return least;
  }
  const Precise height = dot(n, minus(x, c[0]));
  return height * height / area;
}

inline double precise_distance(const TriangleMesh& mesh, const Vec3& x) {
  std::optional<Precise> least;
  for (const Face& face : mesh.faces) {
    const Precise here = squared_distance(
        precise(x),
        {precise(corner(mesh, face, 0)), precise(corner(mesh, face, 1)), precise(corner(mesh, face, 2))});
    if (!least || here < *least) least = here;
  }
  return Precise(sqrt(*least)).convert_to<double>();
}

}  // namespace impinge::test
