// SPDX-License-Identifier: GPL-3.0-or-later
// The colours that show a gap (thesis, Section 3.4 and Figure 41), and their thresholds.
//
// The thesis names purple where the bones touch, red, orange and yellow within the thickness of the
// cartilage, and beyond it green on the ball and blue on the socket. It does not say where one colour ends:
// equal thirds of the thickness are our choice. The shades darken steadily towards contact, so that they read
// in grey too.
#pragma once

#include <string_view>
#include <vector>

#include "gap/surface.hpp"
#include "mesh/ply_writer.hpp"

namespace impinge {

/// A range of gaps: above the previous level, up to this one.
struct GapLevel {
  double up_to_mm = 0.0;     // infinite for the last
  std::string_view meaning;  // as a legend says it
  Rgb colour{};              // of vertices with such a gap
};

/// Levels from contact outwards for a cartilage thickness in mm (both layers together): five, or two (contact
/// and no contact) with thickness 0.
std::vector<GapLevel> gap_levels(Surface surface, double cartilage_mm);

/// Colour of a gap; light grey for NaN, where the other surface is not met.
Rgb gap_colour(double gap_mm, const std::vector<GapLevel>& levels);
inline constexpr Rgb kNoGapColour{217, 217, 217};  // light grey

}  // namespace impinge
