// SPDX-License-Identifier: GPL-3.0-or-later
// Messages that stay one line, whatever names and texts of a user they quote.
#pragma once

#include <string>

namespace impinge {

/// Control characters become blanks: a name with a line end, or one that moves the cursor, stays where it is.
std::string one_line(std::string text);

}  // namespace impinge
