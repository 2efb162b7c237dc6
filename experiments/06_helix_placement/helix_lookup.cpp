// SPDX-License-Identifier: GPL-3.0-or-later
#include "06_helix_placement/helix_lookup.hpp"

#include <array>
#include <string_view>
#include <vector>

#include "curves/helix_entries.hpp"
#include "curves/helix_stencil.hpp"
#include "curves/lookup_error.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/fibonacci.hpp"

namespace impinge::lab {
namespace {

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

}  // namespace

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

}  // namespace impinge::lab
