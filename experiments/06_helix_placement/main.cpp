// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Where do the entries of the thesis' helix stand, and what does Eq. 10 do to a look-up? (Figures
// 47-48)
// @writes    helix_placement helix_curve helix_neighbours helix_lookup_error
// @timing    no
// @seconds   3 60
// @links     harness curves mesh
//
// "Equally distributed along the curve with a distance dx" has two readings: equal steps of the travelled
// distance of Eq. 10, and of true arc length.

#include <array>
#include <cmath>
#include <span>

#include "06_helix_placement/helix_drawing.hpp"
#include "06_helix_placement/helix_lookup.hpp"
#include "curves/helix_entries.hpp"
#include "curves/helix_length.hpp"
#include "harness/driver.hpp"
#include "sphere/schemes/usid.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array<std::size_t, 4> kTurns{229, 458, 2292, 4584};  // Table 6
constexpr std::array<std::size_t, 3> kDrawn{10, 20, 40};            // Figure 47
const Vec3 kVertex =
    to_direction({48.0 * kDegree, 36.0 * kDegree});  // of Figure 48, with kDrawn.front() turns

Result placement() {
  Result result{
      "helix_placement", "How far apart are the entries, and how far off is an index by Eq. 10?", {}, {}, {}};
  result.table.columns = {
      {"turns", "1", "k of the helix"},
      {"entries", "1", "w = k^2"},
      {"equator_points", "1", "entries of one turn at the equator"},
      {"along_deg", "deg", "4 / k, spacing along the curve at the equator"},
      {"along_measured_deg", "deg", "angle between the two entries nearest to the equator"},
      {"between_turns_deg", "deg", "pi / k, spacing of turns"},
      {"length", "radius", "true length of the curve"},
      {"length_asymptote", "radius", "4 k + (ln(8 k) + 1/2) / (2 k)"},
      {"length_4k", "radius", "4 k"},
      {"length_eq10", "radius", "4 k + 1, what Eq. 10 takes the length for"},
      {"mismatch_true_spacing", "1", "largest error of an index by Eq. 10 over the true spacing, entries"},
      {"mismatch_true_spacing_deg", "deg", "phi at which it is reached"},
      {"mismatch_eq10_spacing", "1", "the same over Eq. 10's own spacing (4 k + 1) / (w - 1), entries"},
      {"mismatch_eq10_spacing_deg", "deg", "phi at which it is reached"}};
  for (const std::size_t k : kTurns) {
    const Usid usid = Usid::with_turns(k);
    const HelixEntries entries = thesis_entries(k);
    const auto turns = static_cast<double>(k);
    const double measured = angle_between(usid.direction(k * k / 2 - 1), usid.direction(k * k / 2));
    const Mismatch by_arc = largest_index_mismatch(entries, HelixSpacing::true_arc);
    const Mismatch by_travel = largest_index_mismatch(entries, HelixSpacing::travelled);
    result.table.add_row({k, usid.size(), usid.equator_points(), 4.0 / turns / kDegree, measured / kDegree,
                          kPi / turns / kDegree, helix_total_length(turns),
                          helix_total_length_asymptote(turns), 4.0 * turns, total_travelled_distance(turns),
                          by_arc.index, by_arc.phi / kDegree, by_travel.index, by_travel.phi / kDegree});
  }
  return result;
}

void body(DriverRun& run) {
  // The entries at equal arc are roots, a few microseconds each: the finest helix is left out, in quick two.
  const std::span<const std::size_t> looked_up(kTurns.data(), run.quick() ? 2 : 3);
  for (Result result : {placement(), helix_curve(kDrawn), helix_neighbours_of(kDrawn.front(), kVertex),
                        helix_lookup_errors(looked_up)}) {
    result.parameters["helix"] =
        "theta = 2 k phi, k^2 entries at equal steps of Eq. 10 unless a column says otherwise";
    run.write(result);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"06_helix_placement", "Entries of the helix and Eq. 10 (Figures 47-48, Table 6)."}, body);
}
