// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of limits on a terminal.
#pragma once

#include <string>

#include "joint/limits.hpp"

namespace impinge {

/// Lines: of one motion each limit with what it hangs on, of several a table.
std::string describe(const LimitsAnswer& found);

}  // namespace impinge
