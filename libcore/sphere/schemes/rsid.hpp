// SPDX-License-Identifier: GPL-3.0-or-later
// RSID: the regular grid of spherical angles, LUT[phi][theta] of the thesis (Section 3.1, Eq. 5-6).
//
// Precision p divides 180 degrees: 180 / p + 1 rows of 360 / p columns, poles included, entry (i, j) at
// phi = i p, theta = j p. The two pole rows repeat one direction, as in the thesis. Lookup is bilinear in
// (phi, theta).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "sphere/angular_box.hpp"
#include "sphere/arc_borders.hpp"
#include "sphere/direction.hpp"
#include "sphere/ring_walker.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class Rsid {
 public:
  static constexpr std::string_view name = "rsid";
  static constexpr std::string_view label = "RSID grid";
  static constexpr std::string_view citation = "thesis, Section 3.1, Eq. 5-6";

  class Walker;

  Rsid() = default;
  static Rsid with_precision(double degrees);

  std::size_t rows() const { return divisions_ + 1; }     // of equal phi, poles included
  std::size_t columns() const { return 2 * divisions_; }  // of equal theta
  std::size_t size() const { return rows() * columns(); }
  std::size_t cells() const { return divisions_ * columns(); }
  std::size_t equator_points() const { return columns(); }
  double precision_deg() const { return 180.0 / static_cast<double>(divisions_); }
  double spacing() const { return kPi / static_cast<double>(divisions_); }  // radians

  Vec3 direction(std::size_t entry) const {
    const CosSin phi = row_angle(entry / columns());
    const CosSin theta = row_angle(entry % columns());
    return direction(phi, theta);
  }

  Stencil stencil(const Vec3& x) const {
    const auto [phi, theta] = to_angles(x);
    const double row = phi / spacing();
    const double column = theta / spacing();
    const std::size_t i = std::min(static_cast<std::size_t>(row), divisions_ - 1);
    const std::size_t j = std::min(static_cast<std::size_t>(column), columns() - 1);
    const std::size_t right = j + 1 == columns() ? 0 : j + 1;
    const double a = std::min(row - static_cast<double>(i), 1.0);
    const double b = std::min(column - static_cast<double>(j), 1.0);
    const std::size_t upper = i * columns();
    const std::size_t lower = upper + columns();
    return {{upper + j, upper + right, lower + j, lower + right},
            {(1.0 - a) * (1.0 - b), (1.0 - a) * b, a * (1.0 - b), a * b},
            4,
            upper + j};
  }

  /// Cells lie between parallels and meridians.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const { return latitude_is_monotone(a, b); }

  /// Circumradius of the widest cell, the one at the equator: its corners (phi, +-p/2) and (phi + p, +-p/2)
  /// are equally far from the point at polar angle atan2(cos phi - cos(phi + p), cos(p/2) (sin(phi + p) - sin
  /// phi)).
  double covering_radius() const;

  /// The farthest tap is the far corner of a cell, whose sides are p and at most p.
  double stencil_radius() const { return std::sqrt(2.0) * spacing(); }

  /// The entry's share of the band half a step either way of its row; the entries of a pole share its cap.
  double area(std::size_t entry) const {
    const std::size_t row = entry / columns();
    const bool pole = row == 0 || row == divisions_;
    const double half = std::sin(0.5 * spacing());
    const double quarter = std::sin(0.25 * spacing());
    const double height = pole ? 2.0 * quarter * quarter : 2.0 * row_angle(row).sin * half;
    return 2.0 * kPi * height / static_cast<double>(columns());
  }

  Walker walker() const;

  friend bool operator==(const Rsid&, const Rsid&) = default;

 private:
  static constexpr double kMostDivisions = 1e9;

  explicit Rsid(std::size_t divisions) : divisions_(divisions) {}

  CosSin row_angle(std::size_t k) const {
    return half_turn_fraction(static_cast<long>(k), static_cast<long>(divisions_));
  }
  static Vec3 direction(CosSin phi, CosSin theta) {
    return {phi.sin * theta.cos, phi.sin * theta.sin, phi.cos};
  }

  std::size_t divisions_ = 180;
};

/// Computes the sine and cosine of each grid line once, for all triangles.
class Rsid::Walker {
 public:
  /// Computes the sines and cosines of all rows and columns.
  explicit Walker(const Rsid& scheme) : scheme_(scheme), cos_(scheme.columns()), sin_(scheme.columns()) {
    for (std::size_t k = 0; k < cos_.size(); ++k) {
      const CosSin line = scheme.row_angle(k);
      cos_[k] = line.cos;
      sin_[k] = line.sin;
    }
  }

  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
    const AngularBox box = angular_box(cone.corners(), margin);
    const double spacing = scheme_.spacing();
    const auto top = static_cast<std::size_t>(std::ceil(box.phi_min / spacing - kRingSlack));
    const auto bottom =
        std::min(static_cast<std::size_t>(box.phi_max / spacing + kRingSlack), scheme_.rows() - 1);
    const double from = box.theta_min / spacing;
    const double to = (box.theta_min + box.theta_width) / spacing;
    for_each_part(from, to, scheme_.columns(), [&](std::size_t first, std::size_t count) {
      for (std::size_t i = top; i <= bottom; ++i) {
        const CosSin phi{cos_[i], sin_[i]};
        const auto direction_of = [&](std::size_t k) {
          return direction(phi, {cos_[first + k], sin_[first + k]});
        };
        visit_in_runs(i * scheme_.columns() + first, count, direction_of, visit);
      }
    });
  }

 private:
  Rsid scheme_;
  std::vector<double> cos_;
  std::vector<double> sin_;
};

inline Rsid::Walker Rsid::walker() const { return Walker(*this); }

inline Rsid Rsid::with_precision(double degrees) {
  const double divisions = std::round(180.0 / degrees);
  if (!(degrees > 0.0 && degrees <= 90.0)) {
    throw std::invalid_argument("an RSID precision is above 0 and at most 90 degrees");
  }
  if (divisions > kMostDivisions) throw std::invalid_argument("an RSID precision is at least 1.8e-7 degrees");
  if (std::abs(180.0 / degrees - divisions) > 1e-9 * divisions) {
    throw std::invalid_argument("an RSID precision divides 180 degrees, as 1, 0.5, 0.25, 0.1 or 0.05 do");
  }
  return Rsid(static_cast<std::size_t>(divisions));
}

inline double Rsid::covering_radius() const {
  const std::size_t row = divisions_ % 2 == 0 ? divisions_ / 2 : (divisions_ - 1) / 2;
  const CosSin upper = row_angle(row);
  const CosSin lower = row_angle(row + 1);
  const double half_width = std::cos(spacing() / 2.0);
  // Multiplied out so that a cell symmetric to the equator (sines equal) needs no special case.
  const double phi = std::atan2(upper.cos - lower.cos, half_width * (lower.sin - upper.sin));
  const Vec3 centre = to_direction({phi, spacing() / 2.0});
  return angle_between(centre, direction(upper, {1.0, 0.0}));
}

static_assert(AreaScheme<Rsid>);

}  // namespace impinge
