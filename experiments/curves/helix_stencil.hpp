// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 3's look-up on the thesis' helix with each way of finding the index of a point of the curve. Slow
// and plain: the schemes of sphere/ are what a table uses.
#pragma once

#include "curves/helix_entries.hpp"
#include "sphere/direction.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// How the place of a point of the curve is counted in entries: by true arc length, which is right for
/// entries at equal arc, or as T / dx of Eq. 10 with dx the true spacing or Eq. 10's own, which is right for
/// entries at equal travel.
enum class HelixIndex { true_arc, eq10_true_spacing, eq10_own_spacing };

/// The place, in [0, count - 1]: T / dx with the true spacing runs past the table and is cut there.
double helix_place(const HelixEntries& entries, HelixIndex index, double phi);

/// Two entries on the turn above the direction x and two on the one below, linear along the turns and between
/// them; above the first turn and below the last one three. The cell is left 0.
Stencil helix_stencil(const HelixEntries& entries, HelixIndex index, const Vec3& x);

}  // namespace impinge
