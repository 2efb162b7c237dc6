// SPDX-License-Identifier: GPL-3.0-or-later
// Writes numbers into sentences. (GCC 12 has no std::format.)
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace impinge {

/// The text that std::snprintf writes, cut off after 319 characters.
inline std::string formatted(const char* pattern, auto... values) {
  char text[320];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// The value rounded down to so many decimal places: for the lower end of a proven interval. A decimal number
/// that reads back as the value is not rounded further.
inline std::string rounded_down(double value, int places) {
  double shown = std::stod(formatted("%.*f", places, value));
  if (shown > value) shown -= std::pow(10.0, -places);
  return formatted("%.*f", places, shown + 0.0);  // no minus before a zero
}
/// The value rounded up in the same way: for the upper end of a proven interval.
inline std::string rounded_up(double value, int places) {
  double shown = std::stod(formatted("%.*f", places, value));
  if (shown < value) shown += std::pow(10.0, -places);
  return formatted("%.*f", places, shown + 0.0);
}

}  // namespace impinge
