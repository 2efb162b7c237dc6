// SPDX-License-Identifier: GPL-3.0-or-later
#include "06_helix_placement/helix_drawing.hpp"

#include <stdexcept>
#include <string>

#include "curves/helix_entries.hpp"
#include "curves/helix_length.hpp"
#include "curves/helix_neighbours.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kPointsPerTurn = 72;  // of a drawn curve

Vec3 on_curve(double turns, double phi) { return to_direction({phi, 2.0 * turns * phi}); }

}  // namespace

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

}  // namespace impinge::lab
