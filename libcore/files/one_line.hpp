// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps messages on one line, whatever user text they quote.
#pragma once

#include <string>

namespace impinge {

/// The text with blanks in place of control characters, so that no name can break the line or move the
/// cursor.
std::string one_line(std::string text);

}  // namespace impinge
