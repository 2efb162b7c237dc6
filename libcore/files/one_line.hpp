// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps messages on one line, whatever user text they quote.
#pragma once

#include <string>

namespace impinge {

/// Control characters become blanks, so that no name can break the line or move the cursor.
std::string one_line(std::string text);

}  // namespace impinge
