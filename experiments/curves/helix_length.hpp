// SPDX-License-Identifier: GPL-3.0-or-later
// The spherical helix theta = 2 k phi (thesis, Eq. 9) as a curve: its length on the unit sphere, exactly and
// by Eq. 10. phi runs from 0 to pi (radians); k >= 2 is the number of turns; lengths are in radii. All
// functions throw std::invalid_argument for a k below 2 or not finite, a phi outside [0, pi], and a length
// beyond the curve.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "sphere/direction.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// L(phi) = integral_0^phi sqrt(1 + 4 k^2 sin^2 t) dt = E(phi | m = -4 k^2), Legendre's incomplete elliptic
/// integral of the second kind.
double helix_length(double turns, double phi);

/// L(pi) = 2 E(m = -4 k^2).
double helix_total_length(double turns);

/// Asymptote of L(pi) for large k: 4 k + (ln(8 k) + 1/2) / (2 k). The rest is of order ln(k) / k^3.
double helix_total_length_asymptote(double turns);

/// Eq. 10, the "travelled distance" T(phi) = (4 k + 1) (1 - cos phi) / 2, which the thesis fitted to data.
double travelled_distance(double turns, double phi);

/// 4 k + 1, Eq. 10 at phi = pi.
double total_travelled_distance(double turns);

/// Inverse of helix_length(). A length that rounding has put past the end counts as the end.
double polar_angle_at_length(double turns, double length);

/// Inverse of travelled_distance(). A distance that rounding has put past the end counts as the end.
double polar_angle_at_travelled_distance(double turns, double distance);

// Positions of the entries on the thesis' helix (Chapter 4). "Equally distributed along the curve with a
// distance dx" has two readings: by Eq. 10's travelled distance T, or by true arc length L. In the second
// reading the look-up index T / dx is off; this says by how much.

/// Entries 0 ... count - 1 on the helix of k turns, one on each pole. All functions here throw
/// std::invalid_argument unless k >= 2 and count >= 2.
struct HelixEntries {
  double turns = 229.0;       // k
  std::size_t count = 52441;  // the thesis: k^2
};

/// The k^2 entries of the thesis' helix.
HelixEntries thesis_entries(std::size_t turns);

/// count - 1: the index of the entry on the south pole, and the number of steps.
double last_index(const HelixEntries& entries);

/// phi of entry i at equal steps of T: cos(phi_i) = 1 - 2 i / (count - 1). T / dx is then i itself.
double polar_angle_of_equal_travel(const HelixEntries& entries, std::size_t i);

/// phi of entry i at equal steps of L (a root is found).
double polar_angle_of_equal_arc(const HelixEntries& entries, std::size_t i);

/// The spacing by which the look-up divides T: the true one, L(pi) / (count - 1), or that of Eq. 10's own
/// total, (4 k + 1) / (count - 1).
enum class HelixSpacing { true_arc, travelled };

/// T(phi) / dx minus the true position (count - 1) L(phi) / L(pi), in entries: the error of the index from
/// Eq. 10 at phi if entries are at equal true arc length.
double index_mismatch(const HelixEntries& entries, HelixSpacing spacing, double phi);

/// The error of an index, and where it occurs.
struct Mismatch {
  double phi = 0.0;    // radians
  double index = 0.0;  // entries, signed
};

/// The largest absolute mismatch over [0, pi]; of two equal ones the northern one. The derivative of c (1 -
/// cos phi) / 2 - L(phi) vanishes where sin^2 phi = 1 / (c^2 / 4 - 4 k^2). These points and the end, phi =
/// pi, are the only candidates.
Mismatch largest_index_mismatch(const HelixEntries& entries, HelixSpacing spacing);

// The look-up of the thesis' helix step by step (Section 4.3, Figure 48), for entries at equal travelled
// distance. It keeps what a figure shows; the scheme Usid does the same at once.

struct HelixNeighbours {
  double phi_above = 0.0;              // P_a, where the half plane of the vertex' theta meets the turn above
  double phi_below = 0.0;              // P_b, on the turn below; radians
  double travelled_above = 0.0;        // T of P_a (Eq. 10), radii
  double travelled_below = 0.0;        // T of P_b
  std::array<std::size_t, 4> entry{};  // P_0 and P_1 round P_a, P_2 and P_3 round P_b
};

/// Neighbours of a vertex in direction x (of any length above 0). None above the first turn and below the
/// last one, where a vertex has three.
std::optional<HelixNeighbours> helix_neighbours(const HelixEntries& entries, const Vec3& x);

// Algorithm 3's look-up on the thesis' helix, with each way to find the index of a point on the curve. It is
// slow and plain; tables use the schemes of sphere/.

/// How a position on the curve is counted in entries. True arc length is right for entries at equal arc. T /
/// dx of Eq. 10 is right for entries at equal travel; dx is the true spacing or Eq. 10's own.
enum class HelixIndex { true_arc, eq10_true_spacing, eq10_own_spacing };

/// The position, in [0, count - 1]. With the true spacing T / dx runs past the table and is cut there.
double helix_place(const HelixEntries& entries, HelixIndex index, double phi);

/// Two entries on the turn above the direction x and two on the turn below, linear along the turns and
/// between them; three above the first turn and below the last. The cell stays 0.
Stencil helix_stencil(const HelixEntries& entries, HelixIndex index, const Vec3& x);

// The error of a way to look up entries, on a surface that is known exactly.

/// Interpolated radius minus true radius, mm.
struct LookupError {
  double largest = 0.0;           // largest absolute error
  double root_mean_square = 0.0;  // over the directions
};

/// Interpolates the radii of the entries with stencil(u) -> Stencil in each direction u (unit vectors, at
/// least one) and compares with radius(u). All radii in mm.
template <class StencilOf>
LookupError lookup_error(std::span<const double> radii, StencilOf&& stencil,
                         const std::function<double(const Vec3&)>& radius, std::span<const Vec3> directions) {
  LookupError error;
  double sum = 0.0;
  for (const Vec3& u : directions) {
    const Stencil taps = stencil(u);
    double interpolated = 0.0;
    for (std::size_t k = 0; k < taps.taps; ++k) interpolated += taps.weight[k] * radii[taps.entry[k]];
    const double off = interpolated - radius(u);
    error.largest = std::max(error.largest, std::abs(off));
    sum += off * off;
  }
  error.root_mean_square = std::sqrt(sum / static_cast<double>(directions.size()));
  return error;
}

}  // namespace impinge
