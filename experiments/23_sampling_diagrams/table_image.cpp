// SPDX-License-Identifier: GPL-3.0-or-later
#include "23_sampling_diagrams/table_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace impinge::lab {

GreyRange grey_range(const RadialTable<Rsid>& table) {
  GreyRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double r : table.radii()) {
    if (std::isnan(r)) continue;
    range.smallest = std::min(range.smallest, r);
    range.largest = std::max(range.largest, r);
  }
  return range;
}

std::string table_image(const RadialTable<Rsid>& table, GreyRange range) {
  const Rsid& scheme = table.scheme();
  std::string image =
      "P5\n" + std::to_string(scheme.columns()) + " " + std::to_string(scheme.rows()) + "\n255\n";
  image.reserve(image.size() + scheme.size());
  const double scale = range.largest > range.smallest ? 254.0 / (range.largest - range.smallest) : 0.0;
  for (const double r : table.radii()) {
    const double grey = std::isnan(r) ? 0.0 : 1.0 + std::round(scale * (r - range.smallest));
    image.push_back(static_cast<char>(static_cast<unsigned char>(grey)));
  }
  return image;
}

}  // namespace impinge::lab
