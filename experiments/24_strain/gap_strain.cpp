// SPDX-License-Identifier: GPL-3.0-or-later
#include "24_strain/gap_strain.hpp"

#include <cassert>
#include <cmath>

namespace impinge::lab {

double gap_strain(double gap, double thickness) {
  if (std::isnan(gap)) return gap;
  if (gap <= 0.0) return 1.0;
  return gap < thickness ? 1.0 - gap / thickness : 0.0;
}

std::vector<double> gap_strains(std::span<const double> gap, std::span<const Vec3> places,
                                const CartilageMap& map) {
  assert(gap.size() == places.size());
  std::vector<double> strains(gap.size());
  for (std::size_t i = 0; i < strains.size(); ++i)
    strains[i] = gap_strain(gap[i], thickness_at(map, places[i]));
  return strains;
}

}  // namespace impinge::lab
