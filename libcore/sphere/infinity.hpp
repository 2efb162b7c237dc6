// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace impinge {

/// The length of what has no limit, and the start of a search for the least value.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace impinge
