// SPDX-License-Identifier: GPL-3.0-or-later
// Schemes by their precision where not every scheme has every one: a grid of angles must divide 180 degrees.
#pragma once

#include <optional>
#include <stdexcept>

#include "sphere/scheme.hpp"

namespace impinge {

/// The scheme whose entries are so many degrees apart, or nothing where there is none.
template <SamplingScheme S>
std::optional<S> scheme_of_precision(double degrees) {
  try {
    return S::with_precision(degrees);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace impinge
