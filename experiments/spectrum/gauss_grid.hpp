// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of directions on which spherical harmonics are summed exactly.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/direction.hpp"
#include "table/layer.hpp"

namespace impinge {

/// L rows at the Gauss-Legendre nodes of z = cos(phi), downwards from the +z pole, where phi is the angle
/// from it. Each row has 2 L equally spaced columns, beginning at azimuth theta = 0. For products of two
/// functions of band limit L (degrees below L) sums over the grid are integrals over the sphere.
class GaussGrid {
 public:
  /// Throws std::invalid_argument unless 1 <= band_limit <= 4096.
  explicit GaussGrid(std::size_t band_limit);

  std::size_t band_limit() const { return z_.size(); }     // L
  std::size_t rows() const { return z_.size(); }           // L, of equal z
  std::size_t columns() const { return 2 * z_.size(); }    // 2 L, of equal theta
  std::size_t size() const { return rows() * columns(); }  // number of directions

  double z(std::size_t row) const { return z_[row]; }      // cos(phi) of a row
  double phi(std::size_t row) const { return phi_[row]; }  // radians
  /// Solid angle that an entry of the row represents, steradians; all sum to 4 pi.
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

// The radii of a mesh along the directions of a Gauss grid.

/// Radii of a mesh in the centre frame, mm; kNoSurface where no face is met. They equal RayCaster's but for
/// rounding, in a time that grows with faces + directions instead of their product.
std::vector<double> grid_radii(const GaussGrid& grid, const TriangleMesh& mesh, Layer layer);

// A sphere cut into parallel slices, as in CT (thesis, Section 3.5.2, Figure 45).

/// Slice i lies i thicknesses above the middle plane, which holds the centre.
struct Slice {
  std::size_t index = 0;  // i, from the middle slice
  double height = 0.0;    // mm
  double phi = 0.0;  // angle from the axis at which the slice cuts the sphere, arccos(height / r), radians
  double gap = 0.0;  // phi minus that of the slice below, radians; 0 for slice 0
};

/// The slices of the upper half with height <= radius (mm), the middle one first. The whole sphere has twice
/// as many less one. Throws std::invalid_argument unless 0 < thickness <= radius.
std::vector<Slice> slices_of_sphere(double radius, double thickness);

// Continues a surface with holes, such as a femoral head cut off at its neck, over all directions.

/// How a hole is filled; existing values do not change.
///   membrane  zero Laplacian in the hole, equal to the values round it, as a steady temperature. Of all
///             continuous fillings it has the least sum l (l + 1) |a_lm|^2, and no extreme of its own. It has
///             a kink at the edge, which puts power into high degrees.
///   plate     least integral of the squared Laplacian, so the least sum l^2 (l + 1)^2 |a_lm|^2: a bent plate
///             that continues the slope of the surface without a kink. It may overshoot.
enum class Filling { membrane, plate };

std::string_view name_of(Filling filling);  // "membrane" or "plate"

/// Replaces the NaNs among `values`, which has one value per direction of the grid, row by row. Uses finite
/// volumes on the grid, solved directly. Throws std::invalid_argument for another number of values or if all
/// are NaN, std::runtime_error if the equations cannot be solved.
std::vector<double> fill_holes(const GaussGrid& grid, std::vector<double> values, Filling filling);

}  // namespace impinge
