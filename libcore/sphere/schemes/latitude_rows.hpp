// SPDX-License-Identifier: GPL-3.0-or-later
// Latitude rows with fewer and fewer entries towards the poles (a reduced grid), so that entries are as far
// apart along a row as rows are.
//
// m rows at phi_i = (i + 1/2) h, h = pi / m; row i has n_i = round(2 pi sin(phi_i) / h) entries, at least 3,
// at theta = 2 pi j / n_i. The first and last row have 3 and are turned by half a step: their gaps then do
// not face gaps of the next row. Lookup is linear along the two rows next to the query and then linear in
// phi. Inside of the first and the last row a pole stands for the missing row, with the mean of its 3
// entries.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "sphere/direction.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/ring_interpolation.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class LatitudeRows : public RingInterpolation<LatitudeRows> {
 public:
  static constexpr std::string_view name = "latitude_rows";
  static constexpr std::string_view label = "Latitude rows";
  static constexpr std::string_view citation =
      "Kurihara 1965; Hortal & Simmons 1991 (reduced grids), Monthly Weather Review";

  LatitudeRows() : LatitudeRows(180) {}
  static LatitudeRows with_precision(double degrees);

  std::size_t rows() const { return rows_; }   // m
  std::size_t rings() const { return rows_; }  // the name of rows() that RingWalker uses
  /// Entry numbers of row i begin at first(i); first(rows()) = size().
  std::size_t first(std::size_t row) const { return (*first_)[row]; }
  std::size_t row_size(std::size_t row) const { return first(row + 1) - first(row); }  // entries of a row
  std::size_t size() const { return first(rows_); }
  std::size_t equator_points() const { return row_size(rows_ / 2); }
  double precision_deg() const { return 180.0 / static_cast<double>(rows_); }
  double row_height() const { return kPi / static_cast<double>(rows_); }  // radians

  /// Row k as a ring, for RingWalker.
  RingRow row(std::size_t k) const { return {first(k), row_size(k), k == 0 || k + 1 == rows_ ? 1U : 0U}; }
  Ring ring(std::size_t k) const { return {row(k), row_angle(k)}; }
  double ring_position(double phi) const { return phi / row_height() - 0.5; }
  double polar_angle(std::size_t k) const { return (static_cast<double>(k) + 0.5) * row_height(); }
  std::size_t ring_of(std::size_t entry) const {
    return static_cast<std::size_t>(std::upper_bound(first_->begin(), first_->end(), entry) -
                                    first_->begin()) -
           1;
  }

  Vec3 direction(std::size_t entry) const {
    const Ring on = ring(ring_of(entry));
    return on.direction(entry - on.first);
  }

  Stencil stencil(const Vec3& x) const {
    const auto [phi, theta] = to_angles(x);
    const double height = ring_position(phi);
    if (height < 0.0) return cap_stencil(0, 2.0 * height + 1.0, theta);
    const std::size_t last = rows_ - 1;
    if (height > static_cast<double>(last))
      return cap_stencil(last, 2.0 * (static_cast<double>(rows_) - phi / row_height()), theta);
    const std::size_t row = std::min(static_cast<std::size_t>(height), last - 1);
    return between(row, theta, std::min(height - static_cast<double>(row), 1.0));
  }

  /// Away from the poles N rho^2 = 2 pi, half the diagonal of a square of h.
  double covering_radius() const { return covering_radius_; }
  double stencil_radius() const { return stencil_radius_; }

  /// The entry's share of the band half a step either way of its row.
  double area(std::size_t entry) const {
    const std::size_t row = ring_of(entry);
    const double height = 2.0 * row_angle(row).sin * std::sin(0.5 * row_height());
    return 2.0 * kPi * height / static_cast<double>(row_size(row));
  }

  friend bool operator==(const LatitudeRows& a, const LatitudeRows& b) { return a.rows_ == b.rows_; }

 private:
  static constexpr std::size_t kMostRows = 1'000'000;  // one number each is kept
  static constexpr std::size_t kPolarRows = 4;         // rows whose gaps are found one by one

  explicit LatitudeRows(std::size_t rows);

  CosSin row_angle(std::size_t row) const {
    return half_turn_fraction(static_cast<long>(2 * row + 1), static_cast<long>(2 * rows_));
  }

  double find_covering_radius() const;

  std::size_t rows_;
  std::shared_ptr<const std::vector<std::size_t>> first_;
  double covering_radius_ = kPi;
  double stencil_radius_ = kPi;
};

inline LatitudeRows LatitudeRows::with_precision(double degrees) {
  if (!(degrees > 0.0 && degrees <= 90.0)) {
    throw std::invalid_argument("latitude rows have a precision above 0 and at most 90 degrees");
  }
  const double rows = std::round(180.0 / degrees);
  if (rows > static_cast<double>(kMostRows)) {
    throw std::invalid_argument("latitude rows have a precision of at least 0.00018 degrees");
  }
  return LatitudeRows(static_cast<std::size_t>(rows));
}

inline LatitudeRows::LatitudeRows(std::size_t rows) : rows_(rows) {
  std::vector<std::size_t> first(rows + 1, 0);
  for (std::size_t row = 0; row < rows; ++row) {
    const double count = std::round(2.0 * kPi * row_angle(row).sin / row_height());
    first[row + 1] = first[row] + std::max<std::size_t>(3, static_cast<std::size_t>(count));
  }
  first_ = std::make_shared<const std::vector<std::size_t>>(std::move(first));
  covering_radius_ = find_covering_radius();
  stencil_radius_ = row_height();  // across a cap; the southern half mirrors the northern one
  for (std::size_t row = 0; row < rows / 2; ++row)
    stencil_radius_ = std::max(stencil_radius_, way_across(row));
}

/// Between two rows a direction is farthest from their entries where it faces a gap of both: the centre of
/// the circle through the four (see Rsid::covering_radius()). Near the pole, where gaps are few, the exact
/// gap.
inline double LatitudeRows::find_covering_radius() const {
  const double h = row_height();
  std::vector<Vec3> polar;
  for (std::size_t i = 0; i < first(std::min(rows_, kPolarRows + 3)); ++i) polar.push_back(direction(i));
  const double cap = std::min(static_cast<double>(kPolarRows) * h, 0.5 * kPi + 0.1 * h);
  double largest = largest_gap(polar, std::cos(cap), h);
  for (std::size_t row = kPolarRows - 1; row < rows_ / 2; ++row) {
    const CosSin upper = row_angle(row);
    const CosSin lower = row_angle(row + 1);
    const double half_gap = kPi / static_cast<double>(row_size(row));
    const double across =
        lower.sin * std::cos(kPi / static_cast<double>(row_size(row + 1))) - upper.sin * std::cos(half_gap);
    const double phi = std::atan2(upper.cos - lower.cos, across);
    largest = std::max(largest, separation(phi, polar_angle(row), half_gap));
  }
  return largest * (1.0 + 1e-9);
}

static_assert(AreaScheme<LatitudeRows>);

}  // namespace impinge
