// SPDX-License-Identifier: GPL-3.0-or-later
// Clips a triangle cone by planes through the centre, for walkers of schemes on the faces of a solid.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sphere/triangle_cone.hpp"

namespace impinge {

/// A convex cone given by the directions of its edges, in order (any length above zero).
class ConePolygon {
 public:
  /// The whole cone.
  explicit ConePolygon(const TriangleCone& cone) : count_(3) {
    corner_.fill(Vec3::Zero());
    for (std::size_t k = 0; k < 3; ++k) corner_[k] = cone.corners()[k].stableNormalized();
  }

  /// The corners that clipping has left, in order; valid until the next clip().
  std::span<const Vec3> corners() const { return {corner_.data(), count_}; }
  bool empty() const { return count_ == 0; }  // nothing is left
  /// Room for four clips: by rounding, each can make half as many corners again at the worst.
  static constexpr std::size_t kMostCorners = 14;

  /// Keeps the part with plane . x >= 0 (Sutherland and Hodgman 1974; a spherical polygon is clipped like a
  /// flat one). Corners have length one at first; their rounding is of the order of 1e-15.
  void clip(const Vec3& plane) {
    std::size_t above = 0;
    for (std::size_t k = 0; k < count_; ++k) above += plane.dot(corner_[k]) >= 0.0 ? 1U : 0U;
    if (above == count_) return;
    if (above == 0) {
      count_ = 0;
      return;
    }
    const ConePolygon whole = *this;
    count_ = 0;
    for (std::size_t k = 0; k < whole.count_; ++k) {
      const Vec3& from = whole.corner_[k];
      const Vec3& to = whole.corner_[k + 1 == whole.count_ ? 0 : k + 1];
      const double above_from = plane.dot(from);
      const double above_to = plane.dot(to);
      if (above_from >= 0.0) corner_[count_++] = from;
      if ((above_from >= 0.0) != (above_to >= 0.0))
        corner_[count_++] = from + above_from / (above_from - above_to) * (to - from);
    }
  }

 private:
  std::array<Vec3, kMostCorners> corner_;
  std::size_t count_;
};

}  // namespace impinge
