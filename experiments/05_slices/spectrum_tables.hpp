// SPDX-License-Identifier: GPL-3.0-or-later
// Tables about band limits: the spectrum of surfaces, and the entries that sampling theorems ask for.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "files/csv.hpp"
#include "spectrum/gauss_grid.hpp"

namespace impinge::lab {

// `own` columns, then band_limit and what each theorem asks for at it, beside a scheme that has
// reference_entries.
struct BandLimitTable {
  Table table;                        // with `own` columns first
  std::size_t reference_entries = 0;  // of the scheme beside it
};
// With its columns, and no row; `reference` is the scheme's name.
BandLimitTable band_limit_table(std::vector<Column> own, std::string_view reference,
                                std::size_t reference_entries);
// Adds a row for a band limit.
void add_band_limit(BandLimitTable& limits, std::vector<Cell> own, std::size_t band_limit);

// A surface sampled on a Gauss grid.
struct NamedSurface {
  std::string name;           // in the results
  std::vector<double> radii;  // mm, of a Gauss grid; NaN where there is no surface
};

// What is asked of a band limit: a share of the power of degrees 1 and up, or that what is left out is no
// more than so many mm (root mean square over the sphere).
inline constexpr std::array kPowerShares{0.99, 0.999, 0.9999};
inline constexpr std::array kRests{0.1, 0.05, 0.02};  // mm

struct SpectrumTables {
  Table spectrum;         // surface, filling, degree, power, cumulative_share
  BandLimitTable limits;  // surface, filling, covered_share, asked, power_share, rest_rms_mm, band_limit ...
};

// A surface with holes has rows for each way of filling them, one without has rows for none.
SpectrumTables spectrum_tables(const GaussGrid& grid, const std::vector<NamedSurface>& surfaces,
                               std::string_view reference, std::size_t reference_entries);

}  // namespace impinge::lab
