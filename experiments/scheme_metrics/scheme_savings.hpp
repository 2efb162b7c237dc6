// SPDX-License-Identifier: GPL-3.0-or-later
// How many entries a scheme needs to be as good as a reference table, in several meanings of "as good".
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "scheme_metrics/interpolation_error.hpp"
#include "scheme_metrics/scheme_metrics.hpp"
#include "scheme_metrics/scheme_search.hpp"

namespace impinge {

/// Radius of the widest gap between entries, radians.
template <SamplingScheme S>
double measured_covering_radius(const S& scheme) {
  return widest_gap(sphere_delaunay_of(scheme)).radius;
}

/// Most entries of a table that is measured.
inline constexpr std::size_t kMostMeasured = 1'000'000;
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();  // a ratio that was not measured

/// A table that is as good as the reference in one meaning. measured_ratio is kUnknown if it was not
/// measured.
struct Saving {
  std::string_view meaning;          // name of what is equal, in tables of results
  std::size_t entries = 0;           // of that table
  double measured_ratio = kUnknown;  // of what is to be equal, over that of the reference
};

/// What fewer entries save, in percent of the reference; less than 0 for more.
inline double saved_percent(std::size_t entries, std::size_t reference_entries) {
  return 100.0 * (1.0 - static_cast<double>(entries) / static_cast<double>(reference_entries));
}

/// Entries at equal distances on the equator, the thesis' meaning: what with_precision gives.
template <SamplingScheme S>
std::optional<Saving> saving_at_equal_spacing(double precision_deg) {
  const auto scheme = scheme_of_precision<S>(precision_deg);
  if (!scheme) return std::nullopt;
  return Saving{"equator_spacing", scheme->size(), scheme->precision_deg() / precision_deg};
}

/// Equally wide gaps, with which the bound on errors grows: the smallest table that leaves none wider.
/// Declared radii lead to about its size, from any scheme `near`; there the search begins. Beyond
/// kMostMeasured entries no table is measured: the size is the one at which the declared radius is as large.
template <SamplingScheme S>
std::optional<Saving> saving_at_equal_gap(S near, double covering_radius) {
  // Where gaps next to the poles differ from the rest N rho^2 is not quite constant: a few rounds find the
  // size.
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    const double wider = near.covering_radius() / covering_radius;
    const double entries = std::round(static_cast<double>(near.size()) * wider * wider);
    near = scheme_of_size<S>(static_cast<std::size_t>(entries));
  }
  if (near.size() > kMostMeasured) return Saving{"covering_radius", near.size(), kUnknown};
  const auto found = smallest_within<S>(covering_radius, near.size(), measured_covering_radius<S>);
  if (!found) return std::nullopt;
  return Saving{"covering_radius", found->scheme.size(), found->measured / covering_radius};
}

/// Equal errors of interpolating the functions of the probe. An error falls with the number of entries, so
/// that of one table tells the size of the next, twice. There is no search: among many tables it would find
/// one whose few largest errors are small by luck.
template <SamplingScheme S>
std::vector<Saving> savings_at_equal_error(const S& near, const InterpolationError& target,
                                           const ErrorProbe& probe) {
  struct Meaning {
    std::string_view name;
    double InterpolationError::*error;
  };
  const InterpolationError own = interpolation_error(near, probe);
  std::vector<Saving> savings;
  for (const Meaning& meaning : {Meaning{"interpolation_p9999", &InterpolationError::p9999},
                                 Meaning{"interpolation_rms", &InterpolationError::rms}}) {
    Saving saving{meaning.name, near.size(), own.*meaning.error / target.*meaning.error};
    for (int step = 0; step < 2; ++step) {
      const double entries = std::round(static_cast<double>(saving.entries) * saving.measured_ratio);
      const S scheme = scheme_of_size<S>(static_cast<std::size_t>(entries));
      if (scheme.size() == saving.entries) break;
      const InterpolationError error = interpolation_error(scheme, probe);
      saving = {meaning.name, scheme.size(), error.*meaning.error / target.*meaning.error};
    }
    savings.push_back(saving);
  }
  return savings;
}

}  // namespace impinge
