// SPDX-License-Identifier: GPL-3.0-or-later
// Patches: how the interpolation of a scheme moves over the sphere, for proven bounds on its error.
//
// A patch is a rectangle of two coordinates (s, t) of the scheme's own choice, within one cell. On it the
// interpolated value is linear in s for each t and linear in t for each s (but for `bend` below), and the
// direction is u(s, t). Patches cover the sphere. A scheme declares them by
//   patches_of(scheme)     the patches of a scheme, in an object with the other three
//   for_each(visit)        calls visit(patch) for every patch
//   at(patch, s, t)        the direction u(s, t), a vector of any length above zero
//   motion(patch, rect)    bounds on how u and the weights move over a part of the patch
// The first is found by argument-dependent lookup. Patches are optional: without them there is still a bound
// of first order (table_bound.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

#include "sphere/direction.hpp"

namespace impinge {

/// A rectangle of the two coordinates.
struct Rect {
  std::array<double, 2> from;                                             // s, t
  std::array<double, 2> to;                                               // s, t
  double width(std::size_t k) const { return to[k] - from[k]; }           // along coordinate k
  double middle(std::size_t k) const { return 0.5 * (from[k] + to[k]); }  // of coordinate k
};

/// One patch of a scheme.
struct Patch {
  std::size_t part = 0;  // of the sphere, such as a face; the scheme gives it its meaning
  Rect rect{};           // of the whole patch
};

/// Bounds over a rectangle, along each of its two coordinates, for a step h as wide as the rectangle.
struct PatchMotion {
  std::array<double, 2> way{};   // h |du/ds|, radians
  std::array<double, 2> turn{};  // h^2 |acceleration of u along the sphere|, radians
  std::array<double, 2> kink{};  // h times the sum of the jumps of du/ds, radians
  std::array<double, 2> bend{};  // h^2 sum |d^2 w_i / ds^2| / 2 over the weights of the taps
  bool smooth = true;            // whether `turn` is finite; else only `way` is of use
};

/// Schemes that declare patches.
template <class S>
concept HasPatches = requires(const S scheme, Patch patch) {
  { patches_of(scheme).at(patch, 0.0, 0.0) } -> std::same_as<Vec3>;
  { patches_of(scheme).motion(patch, patch.rect) } -> std::same_as<PatchMotion>;
};

}  // namespace impinge
