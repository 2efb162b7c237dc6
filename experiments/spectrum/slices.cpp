// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/slices.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace impinge {

std::vector<Slice> slices_of_sphere(double radius, double thickness) {
  if (!(thickness > 0.0 && thickness <= radius && std::isfinite(radius))) {
    throw std::invalid_argument("slices have a thickness above 0 and at most the radius of the sphere, mm");
  }
  const auto count = static_cast<std::size_t>(radius / thickness * (1.0 + 1e-12)) + 1;
  std::vector<Slice> slices(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double height = std::min(static_cast<double>(i) * thickness, radius);
    slices[i] = {i, height, std::acos(height / radius), 0.0};
    if (i > 0) slices[i].gap = slices[i - 1].phi - slices[i].phi;
  }
  return slices;
}

}  // namespace impinge
