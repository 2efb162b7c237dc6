// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace impinge {

/// What an empty range ends at, and a length that has no limit.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace impinge
