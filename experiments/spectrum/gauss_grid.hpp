// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of directions on which spherical harmonics are summed exactly.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

/// L rows at the Gauss-Legendre nodes of z = cos(phi), from the +z pole down, phi the angle from it, of 2 L
/// equally spaced columns from theta = 0, the azimuth. Sums over it are integrals over the sphere for
/// products of two functions of band limit L (degrees below L).
class GaussGrid {
 public:
  /// std::invalid_argument unless 1 <= band_limit <= 4096.
  explicit GaussGrid(std::size_t band_limit);

  std::size_t band_limit() const { return z_.size(); }     // L
  std::size_t rows() const { return z_.size(); }           // L, of equal z
  std::size_t columns() const { return 2 * z_.size(); }    // 2 L, of equal theta
  std::size_t size() const { return rows() * columns(); }  // of directions

  double z(std::size_t row) const { return z_[row]; }      // cos(phi) of a row
  double phi(std::size_t row) const { return phi_[row]; }  // radians
  /// Solid angle that an entry of the row stands for, steradians; they sum to 4 pi.
  double weight(std::size_t row) const { return weight_[row]; }
  Vec3 direction(std::size_t row, std::size_t column) const;  // unit vector

 private:
  std::vector<double> z_;
  std::vector<double> phi_;
  std::vector<double> weight_;
};

/// Values of f at the directions of the grid, row by row.
std::vector<double> sample(const GaussGrid& grid, const std::function<double(const Vec3&)>& f);

/// Share of the sphere, by solid angle, on which the values are numbers.
double covered_share(const GaussGrid& grid, const std::vector<double>& values);

}  // namespace impinge
