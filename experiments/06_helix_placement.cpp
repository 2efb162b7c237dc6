// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Where do the entries of the thesis' helix stand, and how far off is Eq. 10? (Figures 47-48)
// @writes    helix_placement helix_curve helix_neighbours helix_lookup_error
// @timing    no
// @seconds   3 60
// @links     harness curves mesh
//
// "Equally distributed along the curve with a distance dx" has two readings: equal steps of the travelled
// distance of Eq. 10, or equal steps of true arc length.

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "curves/helix_length.hpp"
#include "harness/driver.hpp"
#include "harness/provenance.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/direction.hpp"
#include "sphere/schemes/fibonacci.hpp"
#include "sphere/schemes/usid.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kPointsPerTurn = 72;  // points per turn of a drawn curve

Vec3 on_curve(double turns, double phi) { return to_direction({phi, 2.0 * turns * phi}); }

// helix_curve.csv: the entries of each helix, and points of the curve between them.
Result helix_curve(std::span<const std::size_t> turns) {
  Result result{"helix_curve", "What do the helices of Figure 47 look like?", {}, {}, {}};
  result.table.columns = {{"turns", "1", "k of the helix"},
                          {"kind", "", "entry, or curve for a point between entries"},
                          {"index", "1", "in order along the curve"},
                          {"x", "radius", ""},
                          {"y", "radius", ""},
                          {"z", "radius", ""}};
  for (const std::size_t k : turns) {
    const Usid usid = Usid::with_turns(k);
    const auto add = [&](const char* kind, std::size_t i, const Vec3& u) {
      result.table.add_row({k, kind, i, u.x(), u.y(), u.z()});
    };
    for (std::size_t i = 0; i < usid.size(); ++i) add("entry", i, usid.direction(i));
    for (std::size_t i = 0; i <= kPointsPerTurn * k; ++i) {
      const auto share = static_cast<double>(i) / static_cast<double>(kPointsPerTurn * k);
      add("curve", i, on_curve(static_cast<double>(k), kPi * share));
    }
  }
  return result;
}

// helix_neighbours.csv: the steps of the look-up of a vertex in this direction, and the path from the start
// of the curve to P_b. Throws std::invalid_argument if the vertex has three neighbours.
Result helix_neighbours_of(std::size_t turns, const Vec3& vertex) {
  Result result{
      "helix_neighbours", "Which entries does a look-up at the vertex of Figure 48 read?", {}, {}, {}};
  result.table.columns = {
      {"point", "", "vertex; P_a, P_b on the turns; P_0 ... P_3 entries; path from the start to P_b"},
      {"entry", "1", "index of an entry, else empty"},
      {"phi_deg", "deg", "polar angle"},
      {"travelled", "radius", "Eq. 10; empty for the vertex"},
      {"x", "radius", ""},
      {"y", "radius", ""},
      {"z", "radius", ""}};
  const HelixEntries entries = thesis_entries(turns);
  const auto neighbours = helix_neighbours(entries, vertex);
  if (!neighbours)
    throw std::invalid_argument("the vertex has three neighbours: choose one away from the poles");
  const HelixNeighbours& found = *neighbours;
  const auto add = [&](const std::string& point, const Cell& entry, const Vec3& u, bool on_the_curve) {
    const double phi = to_angles(u).phi;
    const Cell travelled = on_the_curve ? Cell(travelled_distance(entries.turns, phi)) : Cell();
    result.table.add_row({point, entry, phi / kDegree, travelled, u.x(), u.y(), u.z()});
  };
  add("vertex", {}, vertex, false);
  add("P_a", {}, on_curve(entries.turns, found.phi_above), true);
  add("P_b", {}, on_curve(entries.turns, found.phi_below), true);
  for (std::size_t k = 0; k < 4; ++k) {
    const double phi = polar_angle_of_equal_travel(entries, found.entry[k]);
    add("P_" + std::to_string(k), found.entry[k], on_curve(entries.turns, phi), true);
  }
  const int steps = static_cast<int>(found.phi_below * entries.turns / kPi * kPointsPerTurn);
  for (int i = 0; i <= steps; ++i)
    add("path", {}, on_curve(entries.turns, found.phi_below * i / steps), true);
  return result;
}

constexpr double kProbesDeg = 0.7;  // spacing of the directions that are looked up

struct Way {
  std::string_view placement;
  std::string_view lookup;
  double (*polar_angle)(const HelixEntries&, std::size_t);
  HelixIndex index;
};

constexpr std::array kWays{
    Way{"equal_travel", "eq10", polar_angle_of_equal_travel, HelixIndex::eq10_own_spacing},
    Way{"equal_arc", "true_arc", polar_angle_of_equal_arc, HelixIndex::true_arc},
    Way{"equal_arc", "eq10_own_spacing", polar_angle_of_equal_arc, HelixIndex::eq10_own_spacing},
    Way{"equal_arc", "eq10_true_spacing", polar_angle_of_equal_arc, HelixIndex::eq10_true_spacing}};

std::vector<double> radii_of(const HelixEntries& entries,
                             double (*polar_angle)(const HelixEntries&, std::size_t)) {
  std::vector<double> radii(entries.count);
  for (std::size_t i = 0; i < entries.count; ++i) {
    const double phi = polar_angle(entries, i);
    radii[i] = ball_radius(to_direction({phi, 2.0 * entries.turns * phi}));
  }
  return radii;
}

std::vector<Vec3> probes() {
  const Fibonacci lattice = Fibonacci::with_precision(kProbesDeg);
  std::vector<Vec3> directions;
  directions.reserve(lattice.size());
  for (std::size_t i = 0; i < lattice.size(); ++i) directions.push_back(lattice.direction(i));
  return directions;
}

// helix_lookup_error.csv: error of the interpolated radius of the generated ball (its smooth surface, mm) for
// each number of turns, over the directions of a Fibonacci lattice.
Result helix_lookup_errors(std::span<const std::size_t> turns) {
  Result result{
      "helix_lookup_error", "What does Eq. 10's look-up cost, by where the entries stand?", {}, {}, {}};
  result.table.columns = {
      {"turns", "1", "k of the helix"},
      {"entries", "1", "w = k^2"},
      {"placement", "", "entries at equal steps of Eq. 10 (travel) or of true arc length"},
      {"lookup", "", "index by Eq. 10 over its own or the true spacing, or by true arc length"},
      {"largest_mm", "mm", "interpolated minus true radius of the ball, largest size"},
      {"rms_mm", "mm", "its root mean square"}};
  const std::vector<Vec3> directions = probes();
  const auto radius = [](const Vec3& u) { return ball_radius(u); };
  for (const std::size_t k : turns) {
    const HelixEntries entries = thesis_entries(k);
    std::vector<double> radii;
    for (std::size_t n = 0; n < kWays.size(); ++n) {
      const Way& way = kWays[n];
      if (n == 0 || way.polar_angle != kWays[n - 1].polar_angle) radii = radii_of(entries, way.polar_angle);
      const LookupError error = lookup_error(
          radii, [&](const Vec3& u) { return helix_stencil(entries, way.index, u); }, radius, directions);
      result.table.add_row(
          {k, entries.count, way.placement, way.lookup, error.largest, error.root_mean_square});
    }
  }
  result.parameters = {{"surface", "generated ball, default shape, smooth"},
                       {"directions", directions.size()}};
  return result;
}

constexpr std::array<std::size_t, 4> kTurns{229, 458, 2292, 4584};    // Table 6
constexpr std::array<std::size_t, 3> kDrawn{10, 20, 40};              // Figure 47
const Vec3 kVertex = to_direction({48.0 * kDegree, 36.0 * kDegree});  // Figure 48, with kDrawn.front() turns

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
  // Entries at equal arcs are roots and take a few microseconds each. Quick leaves out two helices, full the
  // finest.
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
