// SPDX-License-Identifier: GPL-3.0-or-later
// Exact verdicts on whether a joint is impinged in a pose.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <tuple>

#include "files/fields.hpp"
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

/// Counts the verdicts that gaps and bounds (mm, by vertex) prove, over the vertices that have a gap.
VerdictCount count_verdicts(std::span<const double> gap, std::span<const double> bound);

/// Verdicts on the vertices of one surface, before and after the exact test.
struct VertexVerdicts {
  VerdictCount by_bound;        // by gaps and bounds alone
  std::size_t without_gap = 0;  // vertices without a known gap: most have no surface in their direction
  std::size_t impinged = 0;     // vertices impinged by the exact test
  std::size_t refuted = 0;      // verdicts by bound that the exact test contradicts: 0 if the bounds hold

  static constexpr std::tuple fields{
      Field{"impinged", "1", "vertices with a gap of 0 or less, exactly", &VertexVerdicts::impinged},
      Field{"clear_by_bound", "1", "vertices that gap and bound prove clear",
            via(&VertexVerdicts::by_bound, &VerdictCount::clear)},
      Field{"impinged_by_bound", "1", "vertices that they prove impinged",
            via(&VertexVerdicts::by_bound, &VerdictCount::impinged)},
      Field{"undecided_by_bound", "1", "vertices that they leave undecided",
            via(&VertexVerdicts::by_bound, &VerdictCount::undecided)},
      Field{"without_gap", "1", "vertices without a gap", &VertexVerdicts::without_gap},
      Field{"bounds_refuted", "1", "verdicts by bound that the exact test contradicts",
            &VertexVerdicts::refuted}};
};

/// Verdicts on the main surfaces, along rays from the centre. They alone do not decide contact.
struct Certificate {
  VertexVerdicts ball;                    // of the first scan
  VertexVerdicts socket;                  // of the second scan
  bool surfaces_impinged = false;         // decided exactly, crossings of edges included (gap/overlay.hpp)
  std::optional<OverlayContact> deepest;  // where the surfaces are deepest in each other

  /// Is some vertex impinged, exactly?
  bool vertices_impinged() const { return ball.impinged + socket.impinged > 0; }

  static constexpr std::tuple fields{
      Field{"overlap", "", "does the ball reach the socket along some ray? Exact, between vertices too",
            &Certificate::surfaces_impinged},
      Field{"deepest_mm", "mm", "along a ray; null without overlap",
            via(&Certificate::deepest, &OverlayContact::depth)},
      Field{"deepest_at", "", "what is there", via(&Certificate::deepest, &OverlayContact::kind)},
      Field{"ball", "", "of its vertices", &Certificate::ball},
      Field{"socket", "", "of its vertices", &Certificate::socket}};
};

/// By bound a vertex is clear if gap - bound > 0, impinged if gap + bound <= 0, else undecided. Each vertex
/// is also tested exactly, with or without a gap. Vertices that are on no face (mesh/surface_vertices.hpp)
/// are passed over. Meshes in their centre frames, mm.
Certificate certify(const SurfaceOverlay& joint, const Pose& pose, const GapEvidence& ball,
                    const GapEvidence& socket);

}  // namespace impinge
