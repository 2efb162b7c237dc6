// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/gauss_grid.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include <gsl/gsl_integration.h>

namespace impinge {
namespace {

struct Node {
  double z = 0.0;
  double weight = 0.0;  // of an integral over [-1, 1]
};

// One step of Newton's method towards the nearest root of the Legendre polynomial of degree n, and the weight
// there: GSL gives nodes beyond its tables to 1e-10 only.
Node polished(double z, std::size_t n) {
  double before = 1.0;
  double here = z;
  for (std::size_t l = 1; l < n; ++l) {
    const auto degree = static_cast<double>(l);
    const double next = ((2.0 * degree + 1.0) * z * here - degree * before) / (degree + 1.0);
    before = here;
    here = next;
  }
  const double span = (1.0 - z) * (1.0 + z);
  const double slope = static_cast<double>(n) * (before - z * here) / span;
  return {z - here / slope, 2.0 / (span * slope * slope)};
}

}  // namespace

GaussGrid::GaussGrid(std::size_t band_limit) {
  constexpr std::size_t most = 4096;
  if (band_limit < 1 || band_limit > most) {
    throw std::invalid_argument("a band limit is 1 to 4096, not " + std::to_string(band_limit));
  }
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> nodes(
      gsl_integration_glfixed_table_alloc(band_limit), &gsl_integration_glfixed_table_free);
  if (!nodes) throw std::bad_alloc();
  z_.resize(band_limit);
  phi_.resize(band_limit);
  weight_.resize(band_limit);
  for (std::size_t i = 0; i < band_limit; ++i) {
    // GSL counts from -1 upwards; the grid goes down from the pole at +1.
    const std::size_t row = band_limit - 1 - i;
    double z = 0.0;
    double weight = 0.0;
    gsl_integration_glfixed_point(-1.0, 1.0, i, &z, &weight, nodes.get());
    const Node node = polished(polished(z, band_limit).z, band_limit);
    z_[row] = node.z;
    weight_[row] = node.weight * kPi / static_cast<double>(band_limit);
    phi_[row] = std::acos(z_[row]);
  }
}

Vec3 GaussGrid::direction(std::size_t row, std::size_t column) const {
  const CosSin theta = half_turn_fraction(static_cast<long>(column), static_cast<long>(rows()));
  const double s = std::sqrt((1.0 - z_[row]) * (1.0 + z_[row]));
  return {s * theta.cos, s * theta.sin, z_[row]};
}

std::vector<double> sample(const GaussGrid& grid, const std::function<double(const Vec3&)>& f) {
  std::vector<double> values;
  values.reserve(grid.size());
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) values.push_back(f(grid.direction(i, j)));
  }
  return values;
}

double covered_share(const GaussGrid& grid, const std::vector<double>& values) {
  double covered = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) {
      all += grid.weight(i);
      if (!std::isnan(values[i * grid.columns() + j])) covered += grid.weight(i);
    }
  }
  return covered / all;
}

}  // namespace impinge
