// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of two surfaces can meet at all while one of them turns about an axis through the centre.
//
// A turn about +z keeps of every point its height z and its distance r from the centre. So two parts can only
// meet if their boxes of (z, r) overlap, whatever the angle: a few pairs in a thousand.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sphere/direction.hpp"
#include "sphere/lists.hpp"

namespace impinge {

/// Heights and distances from the centre of a part, mm.
struct ProfileBox {
  double z_low = 0.0;   // least height
  double z_high = 0.0;  // largest height
  double r_low = 0.0;   // least distance
  double r_high = 0.0;  // largest distance

  /// Do the boxes have a point in common, borders included?
  bool overlaps(const ProfileBox& other) const {
    return z_low <= other.z_high && other.z_low <= z_high && r_low <= other.r_high && other.r_low <= r_high;
  }
};

/// The box of a point, an edge, a face, rounded outwards by `margin` mm.
ProfileBox profile_of(const Vec3& x, double margin);
ProfileBox profile_of(const Vec3& a, const Vec3& b, double margin);
ProfileBox profile_of(const Vec3& a, const Vec3& b, const Vec3& c, double margin);

/// The smallest box that holds all of them; one that overlaps nothing if there are none.
ProfileBox bounds_of(const std::vector<ProfileBox>& boxes);

/// The parts of one surface by their boxes.
class ProfileIndex {
 public:
  /// Only boxes that overlap `within` are kept; no other part can be asked for.
  ProfileIndex(std::vector<ProfileBox> boxes, const ProfileBox& within);

  /// Calls visit(i) once for every box i that overlaps this one and `within`.
  template <class Visit>
  void visit(const ProfileBox& box, const Visit& visit) const {
    if (!bounds_.overlaps(box)) return;
    const Cells cells = cells_of(box);
    for (std::size_t z = cells.z_low; z <= cells.z_high; ++z) {
      for (std::size_t r = cells.r_low; r <= cells.r_high; ++r) {
        for (const std::uint32_t i : in_cell_[z * kCells + r]) {
          const ProfileBox& own = boxes_[i];
          // In the first cell that both are in, so that no pair comes twice.
          if (own.overlaps(box) && (z == cells.z_low || z == z_cells_.of(own.z_low)) &&
              (r == cells.r_low || r == r_cells_.of(own.r_low)))
            visit(i);
        }
      }
    }
  }

 private:
  static constexpr std::size_t kCells = 48;  // each way
  struct Cells {
    std::size_t z_low, z_high, r_low, r_high;
  };
  struct Axis {
    double low = 0.0, cells_per_mm = 0.0;
    std::size_t of(double value) const {
      if (!(value > low)) return 0;
      return static_cast<std::size_t>(
          std::min(static_cast<double>(kCells - 1), (value - low) * cells_per_mm));
    }
  };
  Cells cells_of(const ProfileBox& box) const;

  std::vector<ProfileBox> boxes_;
  ProfileBox bounds_;
  Axis z_cells_, r_cells_;
  Lists in_cell_;  // boxes
};

}  // namespace impinge
