// SPDX-License-Identifier: GPL-3.0-or-later
// A whole table as a grey image (Figure 31).
#pragma once

#include <string>

#include "sphere/radial_table.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {

// Radii that an image holds.
struct GreyRange {
  double smallest = 0.0;  // mm, grey 1
  double largest = 0.0;   // mm, grey 255
};
GreyRange grey_range(const RadialTable<Rsid>& table);  // of all radii of the table

// The table as a binary PGM file of 8 bits: a pixel an entry, rows and columns those of the table; 0 where
// there is no surface, else 1 to 255 for the range.
std::string table_image(const RadialTable<Rsid>& table, GreyRange range);

}  // namespace impinge::lab
