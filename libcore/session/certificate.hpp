// SPDX-License-Identifier: GPL-3.0-or-later
// Is a joint impinged in a pose, beyond doubt?
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "gap/certified_gap.hpp"
#include "gap/exact_side.hpp"
#include "gap/overlay.hpp"

namespace impinge {

/// What the tables know of the vertices of one surface, in their order: the gap (mm, NaN where none is known)
/// and the proven bound on its error.
struct GapEvidence {
  std::span<const double> gap;    // mm, by vertex
  std::span<const double> bound;  // mm, by vertex
};

/// Of the vertices that have a gap: what gaps and bounds alone prove, mm.
VerdictCount count_verdicts(std::span<const double> gap, std::span<const double> bound);

/// What is known of the vertices of one surface, before and after the exact look.
struct VertexVerdicts {
  VerdictCount by_bound;        // what the gaps and their bounds alone would say
  std::size_t without_gap = 0;  // of which they say nothing: most have no surface in their direction
  std::size_t impinged = 0;     // exactly
  std::size_t refuted = 0;      // verdicts by bound that are wrong: none if the bounds hold
};

struct Certificate {
  VertexVerdicts ball;                    // of the first scan
  VertexVerdicts socket;                  // of the second scan
  bool surfaces_impinged = false;         // decided exactly, crossings of edges included (gap/overlay.hpp)
  std::optional<OverlayContact> deepest;  // where the surfaces are deepest in each other
  double seconds = 0.0;                   // that it took

  /// Is some vertex impinged, exactly?
  bool vertices_impinged() const { return ball.impinged + socket.impinged > 0; }
};

/// A vertex is clear or impinged where gap - bound > 0 or gap + bound <= 0, and undecided otherwise and where
/// no gap is known; it is then resolved exactly. Vertices of no face belong to no surface and are passed
/// over. Meshes in their centre frames, mm.
Certificate certify(const SurfaceOverlay& joint, const Pose& pose, const GapEvidence& ball,
                    const GapEvidence& socket);

}  // namespace impinge
