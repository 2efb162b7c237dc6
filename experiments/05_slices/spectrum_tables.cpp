// SPDX-License-Identifier: GPL-3.0-or-later
#include "05_slices/spectrum_tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "spectrum/hole_filling.hpp"
#include "spectrum/power_spectrum.hpp"

namespace impinge::lab {

BandLimitTable band_limit_table(std::vector<Column> own, std::string_view reference,
                                std::size_t reference_entries) {
  BandLimitTable limits;
  limits.reference_entries = reference_entries;
  limits.table.columns = std::move(own);
  for (Column column : {Column{"band_limit", "1", "L: degrees below it"},
                        {"optimal", "1", "coefficients, L^2; entries of Khalid, Kennedy and McEwen (2014)"},
                        {"mcewen_wiaux", "1", "entries of McEwen and Wiaux (2011)"},
                        {"driscoll_healy", "1", "entries of Driscoll and Healy (1994)"},
                        {"reference_entries", "1", "entries of " + std::string(reference)},
                        {"oversampling", "1", "those divided by McEwen and Wiaux's"},
                        {"nyquist_deg", "deg", "pi / L"}}) {
    limits.table.columns.push_back(std::move(column));
  }
  return limits;
}

void add_band_limit(BandLimitTable& limits, std::vector<Cell> own, std::size_t band_limit) {
  const std::size_t exact = mcewen_wiaux_entries(band_limit);
  own.emplace_back(band_limit);
  own.emplace_back(optimal_entries(band_limit));
  own.emplace_back(exact);
  own.emplace_back(driscoll_healy_entries(band_limit));
  own.emplace_back(limits.reference_entries);
  own.emplace_back(static_cast<double>(limits.reference_entries) / static_cast<double>(exact));
  own.emplace_back(nyquist_angle_deg(band_limit));
  limits.table.add_row(std::move(own));
}

namespace {

const Column kSurface{"surface", "", "what was sampled"};
const Column kFilling{"filling", "", "of holes: membrane, plate, or none where there is no hole"};

void add_surface(SpectrumTables& tables, const GaussGrid& grid, const NamedSurface& surface,
                 std::string_view filling, const std::vector<double>& filled) {
  const std::vector<double> power = power_by_degree(analyse(grid, filled));
  const std::vector<double> shares = cumulative_shares(power);
  for (std::size_t l = 0; l < power.size(); ++l)
    tables.spectrum.add_row({surface.name, filling, l, power[l], shares[l]});
  const double covered = covered_share(grid, surface.radii);
  const auto add = [&](std::string_view asked, double value, std::size_t limit) {
    add_band_limit(
        tables.limits,
        {surface.name, filling, covered, asked, value, shares[limit - 1], rms_beyond(power, limit)}, limit);
  };
  for (const double share : kPowerShares) add("power_share", share, band_limit(power, share));
  for (const double rest : kRests) add("rest_rms_mm", rest, band_limit_leaving(power, rest));
}

}  // namespace

SpectrumTables spectrum_tables(const GaussGrid& grid, const std::vector<NamedSurface>& surfaces,
                               std::string_view reference, std::size_t reference_entries) {
  SpectrumTables tables;
  tables.spectrum.columns = {
      kSurface,
      kFilling,
      {"degree", "1", "of the spherical harmonics"},
      {"power", "mm^2", "sum of the squared coefficients: its part of the integral over the sphere"},
      {"cumulative_share", "1", "of degrees 1 to this one in the power of degrees 1 and up"}};
  tables.limits =
      band_limit_table({kSurface,
                        kFilling,
                        {"covered_share", "1", "of the sphere in which there is a surface"},
                        {"asked", "", "what the band limit is to reach: power_share or rest_rms_mm"},
                        {"value", "1 or mm", "of what is asked"},
                        {"power_share", "1", "of the power of degrees 1 and up that is carried"},
                        {"rest_rms_mm", "mm", "root mean square over the sphere of what is not carried"}},
                       reference, reference_entries);
  for (const NamedSurface& surface : surfaces) {
    if (std::ranges::none_of(surface.radii, [](double r) { return std::isnan(r); })) {
      add_surface(tables, grid, surface, "none", surface.radii);
      continue;
    }
    for (const Filling filling : {Filling::membrane, Filling::plate})
      add_surface(tables, grid, surface, name_of(filling), fill_holes(grid, surface.radii, filling));
  }
  return tables;
}

}  // namespace impinge::lab
