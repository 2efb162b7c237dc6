// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in a sentence. (std::format is not in GCC 12.)
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace impinge {

/// As std::snprintf writes it: a sentence of at most 319 characters.
inline std::string formatted(const char* pattern, auto... values) {
  char text[320];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// Ends of what is proven, as a sentence shows them: the nearest decimal number of that many places that is
/// no higher, or no lower, than the value. A number that reads back as the value counts as the value.
inline std::string rounded_down(double value, int places) {
  double shown = std::stod(formatted("%.*f", places, value));
  if (shown > value) shown -= std::pow(10.0, -places);
  return formatted("%.*f", places, shown + 0.0);  // no minus before a zero
}
/// The other end.
inline std::string rounded_up(double value, int places) {
  double shown = std::stod(formatted("%.*f", places, value));
  if (shown < value) shown += std::pow(10.0, -places);
  return formatted("%.*f", places, shown + 0.0);
}

}  // namespace impinge
