// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of one pose on a terminal.
#pragma once

#include <optional>
#include <string>

#include "joint/touch.hpp"

namespace impinge {

/// Lines; none where there is nothing to say.
std::string describe(const std::optional<SmallestGapDocument>& gap);
std::string describe(const std::optional<NearestPartDocument>& part);

}  // namespace impinge
