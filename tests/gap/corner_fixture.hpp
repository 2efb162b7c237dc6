// SPDX-License-Identifier: GPL-3.0-or-later
// What a table of corners holds, as the library reads it.
#pragma once

#include <cmath>
#include <cstddef>

#include "gap/simd/corner_table.hpp"

namespace impinge::test {

// The number of an entry, 1 / mm.
inline double upper(const CornerTable& table, std::size_t entry) {
  return static_cast<double>(table.smallest) +
         static_cast<double>(table.step) * static_cast<double>(table.words[entry] & CornerTable::kMostCode);
}
// The number of the entry in the next row of the face, 1 / mm.
inline double lower(const CornerTable& table, std::size_t entry) {
  return static_cast<double>(table.smallest) +
         static_cast<double>(table.step) * static_cast<double>(table.words[entry] >> 16U);
}

// What is stored as a table of the library, with the rim cells of another one.
inline RadialTable<CubeGnomonic> stored_radii(const CornerTable& table,
                                              const RadialTable<CubeGnomonic>& from) {
  RadialTable<CubeGnomonic> radii = from;
  const std::size_t n = table.divisions;
  for (std::size_t e = 0; e < radii.radii().size(); ++e) {
    if (std::isnan(radii.radii()[e])) continue;
    const bool last = e / (n + 1) % (n + 1) == n;
    const double q = last ? lower(table, e - n - 1) : upper(table, e);
    radii.radii()[e] = 1.0 / (q * from.scheme().depth(from.scheme().direction(e)));
  }
  return radii;
}

}  // namespace impinge::test
