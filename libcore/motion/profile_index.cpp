// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/profile_index.hpp"

#include <cmath>
#include <utility>

#include "mesh/triangle_distance.hpp"
#include "sphere/infinity.hpp"

namespace impinge {

ProfileBox profile_of(const Vec3& x, double margin) {
  const double r = x.norm();
  return {x.z() - margin, x.z() + margin, r - margin, r + margin};
}

ProfileBox profile_of(const Vec3& a, const Vec3& b, double margin) {
  const double nearest = std::sqrt(squared_distance_to_segment(Vec3::Zero(), a, b));
  return {std::min(a.z(), b.z()) - margin, std::max(a.z(), b.z()) + margin, nearest - margin,
          std::max(a.norm(), b.norm()) + margin};
}

ProfileBox profile_of(const Vec3& a, const Vec3& b, const Vec3& c, double margin) {
  const double nearest = std::sqrt(squared_distance_to_triangle(Vec3::Zero(), a, b, c));
  return {std::min({a.z(), b.z(), c.z()}) - margin, std::max({a.z(), b.z(), c.z()}) + margin,
          nearest - margin, std::max({a.norm(), b.norm(), c.norm()}) + margin};
}

ProfileBox bounds_of(const std::vector<ProfileBox>& boxes) {
  ProfileBox all{kInfinity, -kInfinity, kInfinity, -kInfinity};
  for (const ProfileBox& box : boxes) {
    all.z_low = std::min(all.z_low, box.z_low);
    all.z_high = std::max(all.z_high, box.z_high);
    all.r_low = std::min(all.r_low, box.r_low);
    all.r_high = std::max(all.r_high, box.r_high);
  }
  return all;
}

ProfileIndex::ProfileIndex(std::vector<ProfileBox> boxes, const ProfileBox& within)
    : boxes_(std::move(boxes)), bounds_(bounds_of(boxes_)) {
  bounds_ = {std::max(bounds_.z_low, within.z_low), std::min(bounds_.z_high, within.z_high),
             std::max(bounds_.r_low, within.r_low), std::min(bounds_.r_high, within.r_high)};
  const auto axis = [](double low, double high) {
    return Axis{low, high > low ? static_cast<double>(kCells) / (high - low) : 0.0};
  };
  z_cells_ = axis(bounds_.z_low, bounds_.z_high);
  r_cells_ = axis(bounds_.r_low, bounds_.r_high);
  std::vector<Lists::Pair> pairs;
  for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
    if (!bounds_.overlaps(boxes_[i])) continue;
    const Cells cells = cells_of(boxes_[i]);
    for (std::size_t z = cells.z_low; z <= cells.z_high; ++z) {
      for (std::size_t r = cells.r_low; r <= cells.r_high; ++r)
        pairs.push_back({static_cast<std::uint32_t>(z * kCells + r), i});
    }
  }
  in_cell_ = Lists(kCells * kCells, pairs);
}

ProfileIndex::Cells ProfileIndex::cells_of(const ProfileBox& box) const {
  return {z_cells_.of(box.z_low), z_cells_.of(box.z_high), r_cells_.of(box.r_low), r_cells_.of(box.r_high)};
}

}  // namespace impinge
