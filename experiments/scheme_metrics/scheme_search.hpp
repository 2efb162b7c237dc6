// SPDX-License-Identifier: GPL-3.0-or-later
// Finds schemes by their number of entries. A scheme is made from a precision, which some schemes round and
// some take in certain steps only, so precisions near the wanted one are tried.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "sphere/scheme.hpp"

namespace impinge {

/// Precisions within 4 % of one, in steps of 0.25 %, and those among them that divide 180 degrees, which
/// every grid of angles takes. Coarse ones first, each once.
inline std::vector<double> precisions_near(double degrees) {
  constexpr double kStep = 1.0025;
  constexpr int kSteps = 16;
  std::vector<double> precisions;
  for (int k = -kSteps; k <= kSteps; ++k) precisions.push_back(degrees * std::pow(kStep, k));
  const double divisions = std::round(180.0 / degrees);
  const double around = std::max(std::ceil(0.04 * divisions), 6.0);
  for (double k = std::max(divisions - around, 2.0); k <= divisions + around; k += 1.0) {
    precisions.push_back(180.0 / k);
  }
  std::ranges::sort(precisions, std::greater{});
  precisions.erase(std::unique(precisions.begin(), precisions.end()), precisions.end());
  return precisions;
}

/// The schemes of these precisions, made when asked for, since some take long. Sizes grow with the index.
template <SamplingScheme S>
class SizeLevels {
 public:
  /// Schemes of about so many entries; empty if no precision makes one.
  explicit SizeLevels(std::size_t entries);

  /// The first scheme with at least so many entries, or none.
  std::optional<S> first_of(std::size_t entries) {
    std::size_t low = 0;
    std::size_t high = precisions_.size();
    while (low < high) {
      std::size_t at = low + (high - low) / 2;
      const std::size_t middle = at;
      while (at < high && !make(at)) ++at;
      if (at == high || made_->size() >= entries) {
        high = middle;
      } else {
        low = at + 1;
      }
    }
    place_ = low;
    while (place_ < precisions_.size() && !make(place_)) ++place_;
    return place_ < precisions_.size() ? made_ : std::nullopt;
  }

  /// The next scheme, after the last one returned, with more entries than `than`; or none.
  std::optional<S> larger(std::size_t than) {
    while (++place_ < precisions_.size()) {
      if (make(place_) && made_->size() > than) return made_;
    }
    return std::nullopt;
  }
  /// The next scheme before it with fewer entries, or none.
  std::optional<S> smaller(std::size_t than) {
    while (place_ > 0) {
      if (make(--place_) && made_->size() < than) return made_;
    }
    return std::nullopt;
  }

 private:
  bool make(std::size_t place) {
    made_ = scheme_of_precision<S>(precisions_[place]);
    return made_.has_value();
  }

  std::vector<double> precisions_;
  std::size_t place_ = 0;
  std::optional<S> made_;
};

/// Entries grow with the square of 1 / precision, but for poles and seams.
template <SamplingScheme S>
SizeLevels<S>::SizeLevels(std::size_t entries) {
  double degrees = 1.0;
  std::optional<S> scheme = scheme_of_precision<S>(degrees);
  if (!scheme) return;
  for (int step = 0; step < 4; ++step) {
    degrees *= std::sqrt(static_cast<double>(scheme->size()) / static_cast<double>(entries));
    std::optional<S> next = scheme_of_precision<S>(degrees);
    if (!next) next = scheme_of_precision<S>(180.0 / std::round(180.0 / degrees));
    if (!next) break;
    degrees = next->precision_deg();
    scheme = next;
  }
  precisions_ = precisions_near(degrees);
}

/// The scheme with the nearest number of entries, of two equally near the smaller; none if there is none.
template <SamplingScheme S>
std::optional<S> scheme_nearest_size(std::size_t entries) {
  SizeLevels<S> levels(entries);
  const std::optional<S> above = levels.first_of(entries);
  const std::optional<S> below = levels.smaller(entries);
  if (!above || !below) return above ? above : below;
  return above->size() - entries < entries - below->size() ? above : below;
}

/// The scheme of scheme_nearest_size(). Throws std::runtime_error if there is none.
template <SamplingScheme S>
S scheme_of_size(std::size_t entries) {
  if (const auto scheme = scheme_nearest_size<S>(entries)) return *scheme;
  throw std::runtime_error(std::string(S::name) + ": with_precision makes no table of about " +
                           std::to_string(entries) + " entries");
}

/// A scheme and what was measured on it.
template <SamplingScheme S>
struct MeasuredScheme {
  S scheme;         // the scheme that was measured
  double measured;  // in the unit of the measure
};

/// The smallest scheme of about `estimate` entries for which measure(scheme), which falls with the entries,
/// is at most `target`. Each scheme that is considered is measured. None if no such scheme is within 8 % of
/// the estimate.
template <SamplingScheme S, class Measure>
std::optional<MeasuredScheme<S>> smallest_within(double target, std::size_t estimate, Measure&& measure) {
  SizeLevels<S> levels(estimate);
  std::optional<MeasuredScheme<S>> found;
  const auto meets = [&](const std::optional<S>& scheme) {
    const double measured = measure(*scheme);
    if (measured <= target) found = {*scheme, measured};
    return measured <= target;
  };
  std::optional<S> scheme = levels.first_of(estimate);
  if (!scheme) scheme = levels.smaller(estimate);
  if (!scheme) return std::nullopt;
  if (meets(scheme)) {
    do scheme = levels.smaller(scheme->size());
    while (scheme && meets(scheme));
  } else {
    do scheme = levels.larger(scheme->size());
    while (scheme && !meets(scheme));
  }
  return found;
}

}  // namespace impinge
