// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how good a sampling scheme is; no number is taken from the scheme's own declarations.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "scheme_metrics/interpolation_error.hpp"
#include "scheme_metrics/scheme_search.hpp"
#include "scheme_metrics/sphere_delaunay.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// A gap with |z| above this counts as one at a pole: within 11.5 degrees of it.
inline constexpr double kAwayFromPoles = 0.98;

/// N rho^2 of the densest covering of the plane by circles, centred on a lattice of equilateral triangles
/// (Kershner 1939). No scheme of many entries is below 8 pi / (3 sqrt(3)) = 4.8368.
inline constexpr double kLeastCoveringConstant = 8.0 * kPi / (3.0 * 1.7320508075688772);

/// The measures of one scheme. Areas are solid angles, steradians.
struct SchemeMetrics {
  std::size_t entries = 0;     // number of entries, with those that repeat a direction
  std::size_t directions = 0;  // number of different directions
  EmptyCircle widest;          // its radius is the covering radius, radians
  EmptyCircle widest_away;     // the widest gap with |z| <= kAwayFromPoles
  /// Largest area divided by the smallest. Entries of one direction share its area, so that repeated entries
  /// show as waste.
  double entry_area_ratio = 0.0;
  double direction_area_ratio = 0.0;  // this ratio without sharing

  /// N rho^2. Linear interpolation errs by at most M rho^2 / 2, M the largest second derivative, so the
  /// memory for a given bound is proportional to it.
  double covering_constant() const { return static_cast<double>(entries) * widest.radius * widest.radius; }
  /// N rho^2 with the widest gap away from the poles.
  double covering_constant_away() const {
    return static_cast<double>(entries) * widest_away.radius * widest_away.radius;
  }
};

/// Unit vectors, in the order of the entries.
template <SamplingScheme S>
std::vector<Vec3> all_directions(const S& scheme) {
  std::vector<Vec3> directions;
  directions.reserve(scheme.size());
  for (std::size_t i = 0; i < scheme.size(); ++i) directions.push_back(scheme.direction(i));
  return directions;
}

/// The triangulation of all entries of the scheme.
template <SamplingScheme S>
SphereDelaunay sphere_delaunay_of(const S& scheme) {
  return sphere_delaunay(all_directions(scheme));
}

/// Measured on the Delaunay triangulation of all entries.
template <SamplingScheme S>
SchemeMetrics measure_scheme(const S& scheme) {
  const SphereDelaunay delaunay = sphere_delaunay_of(scheme);
  const std::vector<double> areas = voronoi_areas(delaunay);
  const std::vector<double> shares = entry_areas(delaunay);
  const auto [least, most] = std::ranges::minmax(shares);
  const auto [smallest, largest] = std::ranges::minmax(areas);
  return {scheme.size(),        delaunay.distinct.direction.size(),
          widest_gap(delaunay), widest_gap(delaunay, kAwayFromPoles),
          most / least,         largest / smallest};
}

// The number of entries that a scheme needs to be as good as a reference table, in several meanings.

/// Radius of the widest gap between entries, radians.
template <SamplingScheme S>
double measured_covering_radius(const S& scheme) {
  return widest_gap(sphere_delaunay_of(scheme)).radius;
}

/// Most entries of a table that is measured.
inline constexpr std::size_t kMostMeasured = 1'000'000;
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();  // a ratio that was not measured

/// A table that is as good as the reference in one meaning. measured_ratio is kUnknown if it is not measured.
struct Saving {
  std::string_view meaning;          // name in results
  std::size_t entries = 0;           // of that table
  double measured_ratio = kUnknown;  // the compared quantity, divided by the reference's
};

/// Percentage of the reference's entries that are saved; negative for more entries.
inline double saved_percent(std::size_t entries, std::size_t reference_entries) {
  return 100.0 * (1.0 - static_cast<double>(entries) / static_cast<double>(reference_entries));
}

/// Equal distances of entries on the equator, the thesis' meaning; this is what with_precision gives.
template <SamplingScheme S>
std::optional<Saving> saving_at_equal_spacing(double precision_deg) {
  const auto scheme = scheme_of_precision<S>(precision_deg);
  if (!scheme) return std::nullopt;
  return Saving{"equator_spacing", scheme->size(), scheme->precision_deg() / precision_deg};
}

/// Equally wide gaps, with which the error bound grows: the smallest table that has no wider gap. The search
/// begins near the size that the declared radii give, from any scheme `near`. Above kMostMeasured entries no
/// table is measured, and the size is the one with the same declared radius.
template <SamplingScheme S>
std::optional<Saving> saving_at_equal_gap(S near, double covering_radius) {
  // If gaps next to the poles differ from the rest, N rho^2 is not quite constant; a few rounds find the
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
/// the error of one table gives the size of the next; this is done twice. A search among many tables would
/// find one whose few largest errors are small by luck.
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
