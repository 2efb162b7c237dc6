// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in a sentence. (std::format is not in GCC 12.)
#pragma once

#include <cstdio>
#include <string>

namespace impinge {

// As std::snprintf writes it: a sentence of at most 319 characters.
inline std::string formatted(const char* pattern, auto... values) {
  char text[320];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

}  // namespace impinge
