// SPDX-License-Identifier: GPL-3.0-or-later
// Exact verdicts on whether a joint is impinged in a pose.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "gap/certified_gap.hpp"
#include "gap/exact_side.hpp"
#include "gap/overlay.hpp"

namespace impinge {

/// For each vertex of one surface, in order: its gap from the tables (mm, NaN where none is known) and the
/// proven bound on the error of that gap.
struct GapEvidence {
  std::span<const double> gap;    // mm, by vertex
  std::span<const double> bound;  // mm, by vertex
};

/// Counts what gaps and bounds (mm, by vertex) prove of the vertices that have a gap.
VerdictCount count_verdicts(std::span<const double> gap, std::span<const double> bound);

/// Verdicts on the vertices of one surface, before and after the exact test.
struct VertexVerdicts {
  VerdictCount by_bound;        // by gaps and bounds alone
  std::size_t without_gap = 0;  // vertices without a known gap: most have no surface in their direction
  std::size_t impinged = 0;     // vertices impinged by the exact test
  std::size_t refuted = 0;      // verdicts by bound that the exact test contradicts: 0 if the bounds hold
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

/// By bound a vertex is clear if gap - bound > 0, impinged if gap + bound <= 0, else undecided; each vertex
/// is also tested exactly, with or without a gap. Vertices that are not on a surface
/// (mesh/surface_vertices.hpp) are passed over. Meshes in their centre frames, mm.
Certificate certify(const SurfaceOverlay& joint, const Pose& pose, const GapEvidence& ball,
                    const GapEvidence& socket);

}  // namespace impinge
