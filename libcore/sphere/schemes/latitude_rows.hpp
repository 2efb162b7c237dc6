// SPDX-License-Identifier: GPL-3.0-or-later
// Latitude rows with ever fewer entries towards the poles (a reduced grid), so that entries are as far apart
// along a row as rows are.
//
// m rows at phi_i = (i + 1/2) h, h = pi / m; row i has n_i = round(2 pi sin(phi_i) / h) entries, at least 3,
// at theta = 2 pi j / n_i. The first and last row have 3 and are turned by half a step: their gaps then do
// not face those of the next row. Lookup is linear along the two rows next to the query and then linear in
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

#include "sphere/angular_box.hpp"
#include "sphere/arc_borders.hpp"
#include "sphere/direction.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class LatitudeRows {
 public:
  static constexpr std::string_view name = "latitude_rows";
  static constexpr std::string_view label = "Latitude rows";
  static constexpr std::string_view citation =
      "Kurihara 1965; Hortal & Simmons 1991 (reduced grids), Monthly Weather Review";

  class Walker;

  LatitudeRows() : LatitudeRows(180) {}
  static LatitudeRows with_precision(double degrees);

  std::size_t rows() const { return rows_; }  // m, of equal latitude
  /// Entry numbers of row i begin at first(i); first(rows()) = size().
  std::size_t first(std::size_t row) const { return (*first_)[row]; }
  std::size_t row_size(std::size_t row) const { return first(row + 1) - first(row); }  // entries of a row
  std::size_t size() const { return first(rows_); }
  /// One for each cap, and n_i + n_(i+1) between two rows.
  std::size_t cells() const { return 2 * size() - 4; }
  std::size_t equator_points() const { return row_size(rows_ / 2); }
  double precision_deg() const { return 180.0 / static_cast<double>(rows_); }
  double row_height() const { return kPi / static_cast<double>(rows_); }  // radians

  Vec3 direction(std::size_t entry) const {
    const std::size_t row = row_of(entry);
    return direction(row_angle(row), row, entry - first(row));
  }

  Stencil stencil(const Vec3& x) const {
    const auto [phi, theta] = to_angles(x);
    const double height = phi / row_height() - 0.5;
    if (height < 0.0) return cap_stencil(0, 2.0 * height + 1.0, theta, 0);
    const std::size_t last = rows_ - 1;
    if (height > static_cast<double>(last)) {
      const double outwards = 2.0 * (static_cast<double>(rows_) - phi / row_height());
      return cap_stencil(last, std::max(outwards, 0.0), theta, cells() - 1);
    }
    const std::size_t row = std::min(static_cast<std::size_t>(height), last - 1);
    const double down = std::min(height - static_cast<double>(row), 1.0);
    return between(row, on_row(row, theta), on_row(row + 1, theta), down);
  }

  /// Entries of one row do not stand below those of the next, so that a cell reads entries beyond its
  /// corners: from any direction there is a way to each tap, no longer than stencil_radius(), through the
  /// cells that have the same gap above or the same gap below. Calls visit(stencil) for all of these; the
  /// weights are of no meaning.
  template <class Visit>
  void for_each_cell_across(const Stencil& at, Visit&& visit) const {
    if (at.taps == 3) return;
    const std::size_t row = row_of(at.entry[0]);
    for_each_in_gap(row, at.entry[0] - first(row), row + 1,
                    [&](const Between& a, const Between& b) { visit(between(row, a, b, 0.0)); });
    for_each_in_gap(row + 1, at.entry[2] - first(row + 1), row,
                    [&](const Between& b, const Between& a) { visit(between(row, a, b, 0.0)); });
  }

  /// Cells lie between parallels and meridians.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const { return latitude_is_monotone(a, b); }

  /// Away from the poles N rho^2 = 2 pi, half the diagonal of a square of h.
  double covering_radius() const { return covering_radius_; }
  double stencil_radius() const { return stencil_radius_; }

  /// Share of the band half a step either way of the row.
  double area(std::size_t entry) const {
    const std::size_t row = row_of(entry);
    const double height = 2.0 * row_angle(row).sin * std::sin(0.5 * row_height());
    return 2.0 * kPi * height / static_cast<double>(row_size(row));
  }

  Walker walker() const;

  friend bool operator==(const LatitudeRows& a, const LatitudeRows& b) { return a.rows_ == b.rows_; }

 private:
  /// A point of a row: the entries left and right of it, and the steps from theta = 0 to the left one.
  struct Between {
    std::size_t left;
    std::size_t right;
    std::size_t step;
    double share;
  };

  static constexpr std::size_t kMostRows = 1'000'000;  // one number each is kept
  static constexpr std::size_t kPolarRows = 4;         // rows whose gaps are found one by one

  explicit LatitudeRows(std::size_t rows);

  bool is_turned(std::size_t row) const { return row == 0 || row + 1 == rows_; }
  double polar_angle(std::size_t row) const { return (static_cast<double>(row) + 0.5) * row_height(); }
  CosSin row_angle(std::size_t row) const {
    return half_turn_fraction(static_cast<long>(2 * row + 1), static_cast<long>(2 * rows_));
  }
  Vec3 direction(CosSin phi, std::size_t row, std::size_t column) const {
    const CosSin theta = half_turn_fraction(static_cast<long>(2 * column + (is_turned(row) ? 1 : 0)),
                                            static_cast<long>(row_size(row)));
    return {phi.sin * theta.cos, phi.sin * theta.sin, phi.cos};
  }

  std::size_t row_of(std::size_t entry) const {
    return static_cast<std::size_t>(std::upper_bound(first_->begin(), first_->end(), entry) -
                                    first_->begin()) -
           1;
  }

  /// Place of theta in a row, in entries from its first one; a turned row begins half a step after theta = 0.
  double column(std::size_t row, double theta) const {
    return theta / (2.0 * kPi) * static_cast<double>(row_size(row)) - (is_turned(row) ? 0.5 : 0.0);
  }
  Between on_row(std::size_t row, double theta) const;
  Between gap(std::size_t row, std::size_t step, double share) const;
  template <class Visit>
  void for_each_in_gap(std::size_t row, std::size_t left, std::size_t other, Visit&& visit) const;
  Stencil between(std::size_t row, const Between& a, const Between& b, double down) const;
  Stencil cap_stencil(std::size_t row, double outwards, double theta, std::size_t cell) const;
  double find_covering_radius() const;
  double find_stencil_radius() const;

  std::size_t rows_;
  std::shared_ptr<const std::vector<std::size_t>> first_;
  double covering_radius_ = kPi;
  double stencil_radius_ = kPi;
};

/// Holds the sines and cosines of the rows.
class LatitudeRows::Walker {
 public:
  /// Computes the sines and cosines.
  explicit Walker(const LatitudeRows& scheme) : scheme_(scheme), row_angles_(scheme.rows()) {
    for (std::size_t row = 0; row < row_angles_.size(); ++row) row_angles_[row] = scheme.row_angle(row);
  }

  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
    const AngularBox box = angular_box(cone.corners(), margin);
    const double top = std::ceil(box.phi_min / scheme_.row_height() - 0.5 - kSlack);
    const double bottom = std::min(std::floor(box.phi_max / scheme_.row_height() - 0.5 + kSlack),
                                   static_cast<double>(scheme_.rows() - 1));
    for (double row = std::max(top, 0.0); row <= bottom; row += 1.0) {
      visit_range(static_cast<std::size_t>(row), box, visit);
    }
  }

 private:
  static constexpr double kSlack = 1e-6;  // of a step: rounding of the divisions

  template <class Visit>
  void visit_range(std::size_t row, const AngularBox& box, Visit&& visit) const {
    const auto columns = static_cast<long>(scheme_.row_size(row));
    const auto left = static_cast<long>(std::ceil(scheme_.column(row, box.theta_min) - kSlack));
    const auto right =
        std::min(static_cast<long>(std::floor(scheme_.column(row, box.theta_min + box.theta_width) + kSlack)),
                 left + columns - 1);
    if (left > right) return;
    const auto first = static_cast<std::size_t>(((left % columns) + columns) % columns);
    const std::size_t count = static_cast<std::size_t>(right - left) + 1;
    const std::size_t before_seam = std::min(count, scheme_.row_size(row) - first);
    visit_columns(row, first, before_seam, visit);
    visit_columns(row, 0, count - before_seam, visit);
  }

  template <class Visit>
  void visit_columns(std::size_t row, std::size_t column, std::size_t count, Visit&& visit) const {
    DirectionRun run;
    for (std::size_t done = 0; done < count; done += run.count) {
      run.first = scheme_.first(row) + column + done;
      run.count = std::min(count - done, DirectionRun::kMost);
      for (std::size_t k = 0; k < run.count; ++k) {
        const Vec3 u = scheme_.direction(row_angles_[row], row, column + done + k);
        run.x[k] = u.x();
        run.y[k] = u.y();
        run.z[k] = u.z();
      }
      visit(static_cast<const DirectionRun&>(run));
    }
  }

  LatitudeRows scheme_;
  std::vector<CosSin> row_angles_;
};

inline LatitudeRows::Walker LatitudeRows::walker() const { return Walker(*this); }

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
  stencil_radius_ = find_stencil_radius();
}

inline LatitudeRows::Between LatitudeRows::gap(std::size_t row, std::size_t step, double share) const {
  const std::size_t columns = row_size(row);
  const std::size_t left = (step + (is_turned(row) ? columns - 1 : 0)) % columns;
  return {left, (left + 1) % columns, step, share};
}

inline LatitudeRows::Between LatitudeRows::on_row(std::size_t row, double theta) const {
  const double turned = is_turned(row) ? 1.0 : 0.0;
  const double place = column(row, theta);
  const double left = std::min(std::floor(place), static_cast<double>(row_size(row)) - 1.0);
  return gap(row, static_cast<std::size_t>(left + turned), place - left);
}

inline Stencil LatitudeRows::between(std::size_t row, const Between& a, const Between& b, double down) const {
  const std::size_t upper = first(row);
  const std::size_t lower = first(row + 1);
  return {{upper + a.left, upper + a.right, lower + b.left, lower + b.right},
          {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down * (1.0 - b.share), down * b.share},
          4,
          upper + lower - 2 + a.step + b.step};
}

/// Calls visit(gap, gap of the other row) for the gaps of the other row that face the gap right of entry
/// `left`.
template <class Visit>
void LatitudeRows::for_each_in_gap(std::size_t row, std::size_t left, std::size_t other,
                                   Visit&& visit) const {
  const double step = 2.0 * kPi / static_cast<double>(row_size(row));
  const double from = (static_cast<double>(left) + (is_turned(row) ? 0.5 : 0.0)) * step;
  const auto visit_part = [&](double begin, double end) {
    const Between here = on_row(row, 0.5 * (begin + end));
    const std::size_t last = on_row(other, end).step;
    for (std::size_t k = on_row(other, begin).step; k <= last; ++k) visit(here, gap(other, k, 0.0));
  };
  visit_part(from, std::min(from + step, 2.0 * kPi));
  if (from + step > 2.0 * kPi + 1e-9) visit_part(0.0, from + step - 2.0 * kPi);  // on past the seam
}

/// `outwards` from 0 at the pole to 1 on the row.
inline Stencil LatitudeRows::cap_stencil(std::size_t row, double outwards, double theta,
                                         std::size_t cell) const {
  const Between on = on_row(row, theta);
  Stencil stencil{{first(row), first(row) + 1, first(row) + 2, 0}, {}, 3, cell};
  for (std::size_t k = 0; k < 3; ++k) stencil.weight[k] = (1.0 - outwards) / 3.0;
  stencil.weight[on.left] += outwards * (1.0 - on.share);
  stencil.weight[on.right] += outwards * on.share;
  return stencil;
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

/// From an entry to the far corner of the widest stencil, one row and one gap away, without leaving the rows
/// between: along the row nearer to the pole as far as the pole is in the way, and then straight. (The
/// southern half mirrors the northern one.)
inline double LatitudeRows::find_stencil_radius() const {
  double largest = row_height();  // across a cap
  for (std::size_t row = 0; row < rows_ / 2; ++row) {
    const double gap = 2.0 * kPi / static_cast<double>(std::min(row_size(row), row_size(row + 1)));
    const double upper = polar_angle(row);
    const double lower = polar_angle(row + 1);
    const double seen = lower < 0.5 * kPi ? std::acos(std::tan(upper) / std::tan(lower)) : 0.5 * kPi;
    const double straight = std::min(gap, seen);
    largest = std::max(largest, std::sin(upper) * (gap - straight) + separation(upper, lower, straight));
  }
  return largest;
}

static_assert(AreaScheme<LatitudeRows>);

}  // namespace impinge
