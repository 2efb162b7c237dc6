// SPDX-License-Identifier: GPL-3.0-or-later
// Quoting for the shell.
#pragma once

#include <string>

namespace impinge::lab {

// The text quoted so that a POSIX shell reads it as one word.
inline std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace impinge::lab
