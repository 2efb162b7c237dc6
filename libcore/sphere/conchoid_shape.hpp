// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace impinge {

/// The conchoid r = a + b cos(phi) of the hip (thesis, Eq. 11). Lengths in mm; the default is Menschik's
/// acetabulum (Menschik 1997; thesis, Section 5.1.2).
struct ConchoidShape {
  double a = 20.501;  // r at phi = 90 degrees, above b
  double b = 17.843;  // r is a + b at phi = 0 and a - b at phi = 180 degrees

  friend bool operator==(const ConchoidShape&, const ConchoidShape&) = default;
};

}  // namespace impinge
