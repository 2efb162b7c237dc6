// SPDX-License-Identifier: GPL-3.0-or-later
// Where the entries of the thesis' helix stand (Chapter 4): "equally distributed along the curve with a
// distance dx" has two readings, by Eq. 10's travelled distance T or by true arc length L. And how far the
// look-up index T / dx is off in the second one.
#pragma once

#include <cstddef>

namespace impinge {

/// Entries 0 ... count - 1 on the helix of k turns, one on each pole. k >= 2 and count >= 2, else
/// std::invalid_argument from any function here.
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

/// What the look-up divides T by: the true spacing L(pi) / (count - 1), or that of Eq. 10's own total,
/// (4 k + 1) / (count - 1).
enum class HelixSpacing { true_arc, travelled };

/// T(phi) / dx minus the true place (count - 1) L(phi) / L(pi), in entries: by how much the index of a
/// look-up by Eq. 10 is off at phi when entries stand at equal true arc length.
double index_mismatch(const HelixEntries& entries, HelixSpacing spacing, double phi);

/// By how much an index is off, and where.
struct Mismatch {
  double phi = 0.0;    // radians
  double index = 0.0;  // entries, signed
};

/// The mismatch of largest size over [0, pi]; of two of one size the northern one. The derivative of
/// c (1 - cos phi) / 2 - L(phi) vanishes where sin^2 phi = 1 / (c^2 / 4 - 4 k^2): with the end, phi = pi,
/// these are the only candidates.
Mismatch largest_index_mismatch(const HelixEntries& entries, HelixSpacing spacing);

}  // namespace impinge
