// SPDX-License-Identifier: GPL-3.0-or-later
// Steps down to 1e-9 degrees, at which no machine holds a whole table. Every scheme is asked for single
// entries, and for look-ups whose few taps are worked out on the spot.
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/bodies.hpp"
#include "sphere/direction.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/table_size.hpp"
#include "sphere/uniform_directions.hpp"
#include "stress/azimuth_steps.hpp"
#include "stress/family.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kTinyStepSteps{1.0,  1e-1, 1e-2, 4e-3, 1e-3, 1e-4,
                                    1e-5, 1e-6, 1e-7, 1e-8, 1e-9};  // degrees
constexpr double kTinyStepRadius =
    26.0;  // mm, of the octahedron whose radius R / |u|_1 is known to 3 roundings

// Threshold for where a look-up sees an entry, in units of u: sine and cosine 2 each and their products, 4
// per component, 7 per direction; back to angles 2 pi, and 2 for hypot and atan2; their division by the
// spacing and the difference from the whole number pi and 2 pi each; this for two angles, and again for the
// four taps' directions and weights: 7 + 2 * (2 pi + 2 + 2 pi) + 7 + 4. An azimuth on a spiral is 2 pi times
// its turns times the polar angle, which is its condition; on a grid it has none.
constexpr double kTinyStepThreshold = 48.0;

template <class S>
double condition(const S& scheme) {
  if constexpr (requires { scheme.placement().turns(); }) return 1.0 + 2.0 * kPi * scheme.placement().turns();
  return 1.0;
}

// The first and last entries, those on both sides of 2^31 and 2^32, and as many at random.
std::vector<std::size_t> sample_entries(std::size_t size, std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> entries{0, 1, size - 2, size - 1};
  for (const std::size_t border : {std::size_t{1} << 31U, std::size_t{1} << 32U}) {
    for (const std::size_t entry : {border - 1, border, border + 1}) {
      if (entry < size) entries.push_back(entry);
    }
  }
  std::mt19937_64 random(seed);
  for (std::size_t k = 0; k < count; ++k) entries.push_back(random() % size);
  return entries;
}

// `kept` are the bits that an entry's number keeps.
template <class S>
void ask_entries(const S& scheme, const std::vector<std::size_t>& entries, StabilityCase& row,
                 std::size_t kept = ~std::size_t{0}) {
  for (const std::size_t entry : entries) {
    const Vec3 u = scheme.direction(entry);
    const Stencil stencil = scheme.stencil(u);
    Vec3 seen = Vec3::Zero();
    for (std::size_t k = 0; k < stencil.taps; ++k)
      seen += stencil.weight[k] * scheme.direction(stencil.entry[k] & kept);
    const double off = (seen - u).norm();
    include_error(row, off, row.condition);
  }
}

// On an octahedron tan psi is at most sqrt(2), so a tap within s radians is off by r (exp(sqrt(2) s) - 1),
// plus the errors of the taps' directions.
template <class S>
void ask_windows(const S& scheme, std::size_t count, StabilityCase& row) {
  const double slope = std::sqrt(2.0);
  const double rounding = (1.0 + slope) * row.threshold * row.condition * unit_roundoff(row.scalar);
  row.bound_um = 1e3 * kTinyStepRadius * (std::expm1(slope * scheme.stencil_radius()) + rounding);
  row.error_um = 0.0;
  for (const Vec3& u : uniform_directions(count, 5)) {
    const Stencil stencil = scheme.stencil(u);
    double answer = 0.0;
    for (std::size_t k = 0; k < stencil.taps; ++k)
      answer +=
          stencil.weight[k] * octahedron_mesh_radius(scheme.direction(stencil.entry[k]), kTinyStepRadius);
    if (!std::isfinite(answer)) ++row.nan;
    const double error = std::abs(answer - octahedron_mesh_radius(u, kTinyStepRadius));
    row.error_um = std::fmax(row.error_um, 1e3 * error);
  }
}

template <class S>
StabilityCase window_case(double step, const StabilityRun& run) {
  StabilityCase row;
  row.magnitude = row.precision_deg = step;
  row.method = S::name;
  row.kind = "ours";
  row.threshold = kTinyStepThreshold;
  try {
    const S scheme = S::with_precision(step);
    row.condition = condition(scheme);
    ask_entries(scheme, sample_entries(scheme.size(), run.quick ? 60 : 1000, run.seed), row);
    ask_windows(scheme, run.quick ? 60 : 1000, row);
  } catch (const std::invalid_argument& error) {
    row.refused = error.what();
  }
  return row;
}

// As above, with entries numbered in 32 bits.
StabilityCase short_numbers(double step, const StabilityRun& run) {
  StabilityCase row;
  row.magnitude = row.precision_deg = step;
  row.method = "mutated";
  row.kind = "mutated";
  row.threshold = kTinyStepThreshold;
  try {
    const Rsid scheme = Rsid::with_precision(step);
    row.condition = condition(scheme);
    ask_entries(scheme, sample_entries(scheme.size(), 60, run.seed), row, 0xffffffffU);
  } catch (const std::invalid_argument& error) {
    row.refused = error.what();
  }
  return row;
}

// A whole table must be refused, with its bytes, before memory is asked for.
template <class S>
void add_table_case(double step, std::vector<StabilityCase>& rows) {
  StabilityCase row;
  row.magnitude = row.precision_deg = step;
  row.method = std::string(S::name) + "_whole_table";
  row.kind = "ours";
  row.questions = 1;
  try {
    const std::size_t size = S::with_precision(step).size();
    if (size <= kMostTableEntries) return;
    static_cast<void>(require_table_size(S::name, size));
    row.wrong = 1;
  } catch (const std::invalid_argument& error) {
    row.refused = error.what();
  }
  rows.push_back(row);
}

std::vector<StabilityCase> run_tiny_step(const StabilityRun& options) {
  std::vector<StabilityCase> rows;
  for (const double step : kTinyStepSteps) {
    for_each_scheme([&]<class S>() {
      rows.push_back(window_case<S>(step, options));
      add_table_case<S>(step, rows);
    });
    rows.push_back(short_numbers(step, options));
    rows.push_back(float_azimuths(step, kTinyStepThreshold));
    rows.push_back(summed_azimuths(step, kTinyStepThreshold));
  }
  return rows;
}

}  // namespace

StabilityFamily tiny_step_family() {
  StabilityFamily family;
  family.name = "tiny_step";
  family.parameter = "precision of the scheme";
  family.unit = "degree";
  family.expected =
      "an entry is found where it stands whatever its number, 2^31 and 2^32 passed, and look-ups in a window "
      "come as "
      "near to the surface as the step; whole tables above 1 TiB and steps below a scheme's finest are "
      "refused in "
      "one line with what they would take";
  family.threshold = kTinyStepThreshold;
  family.derivation =
      "roundings of an entry's direction, of its angles, of their place between entries and of the taps; on "
      "a spiral "
      "times 2 pi its turns, the condition of its azimuth";
  family.mutation = "entries numbered in 32 bits (a tolerance)";
  family.seen = {12.0, 0.0};
  family.run = run_tiny_step;
  return family;
}

}  // namespace impinge::lab
