// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in a sentence. (std::format is not in GCC 12.)
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace impinge {

/// As std::snprintf writes it, cut off after 319 characters.
inline std::string formatted(const char* pattern, auto... values) {
  char text[320];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// The lower end of what is proven, for a sentence: the largest decimal number of that many places that is
/// not above the value. A number that reads back as the value counts as the value.
inline std::string rounded_down(double value, int places) {
  double shown = std::stod(formatted("%.*f", places, value));
  if (shown > value) shown -= std::pow(10.0, -places);
  return formatted("%.*f", places, shown + 0.0);  // no minus before a zero
}
/// The upper end likewise: the least such number that is not below the value.
inline std::string rounded_up(double value, int places) {
  double shown = std::stod(formatted("%.*f", places, value));
  if (shown < value) shown += std::pow(10.0, -places);
  return formatted("%.*f", places, shown + 0.0);
}

}  // namespace impinge
