// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a cell of rotations: half-spaces in which something is certain, and what they leave of it.
//
// With a quaternion q = (w, v) of any length, n . R x |q|^2 = (w^2 - v . v) n . x + 2 (v . x) (v . n)
// + 2 w v . (x x n): that a turned point x is beyond a plane, n . R x >= k, is the sign of a quadratic form.
// In the coordinates t of a cell, -1 to 1 along each side, q = c + h t, it is f + g . t + h^2 t . A t. The
// last term is bounded by the entries of A: what is left is a half-space, off by h^2. There is no seam, not
// at half turns either.
//
// Share. In those coordinates the measure is h^3 / (pi^2 s^2), s = |q|^2, no less than its tangent at the
// middle less 2 h^2 t . t / s^3 of the least s of the cell. Of a polytope the integrals of 1, t and t . t are
// sums over tetrahedra.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rotations/rotation_cells.hpp"
#include "sphere/direction.hpp"

namespace impinge {

class CellFrame;

/// Half of a cell: slope . t + offset >= 0. Rounded so that all of it has what it stands for.
struct CellPlane {
  std::array<float, 3> slope{};
  float offset = 0.0F;
  /// n . q, of the same sign for a quaternion of the cell.
  Quaternion4 normal(const CellFrame& frame) const;
  CellPlane opposite() const { return {{-slope[0], -slope[1], -slope[2]}, -offset}; }
  double at(const Vec3& t) const {
    return static_cast<double>(slope[0]) * t[0] + static_cast<double>(slope[1]) * t[1] +
           static_cast<double>(slope[2]) * t[2] + static_cast<double>(offset);
  }
};

/// sign (n . R x - k) over a cell, times |q|^2 > 0: at least middle + slope . t + least.
struct FormOverCell {
  double middle = 0.0;
  Vec3 slope = Vec3::Zero();
  double least = 0.0;
  double corner() const { return slope.cwiseAbs().sum(); }  // slope . t is that at most
  CellPlane plane() const;
};

/// A cell as forms see it.
class CellFrame {
 public:
  explicit CellFrame(const RotationCell& cell);
  /// Of sign (n . R x - k), of which `slack` is taken before it counts as positive.
  FormOverCell form(const Vec3& n, const Vec3& x, double k, double sign, double slack) const;
  /// Coordinates of a quaternion.
  Vec3 place(const Quaternion4& q) const;
  const Quaternion4& middle() const { return middle_; }
  double half() const { return half_; }
  /// Along side k of the cell.
  Quaternion4 side(std::size_t k) const { return Quaternion4::Unit(side_[k]); }
  Quaternion4 across() const { return Quaternion4::Unit(cube_); }
  Vec3 sides(const Quaternion4& q) const { return {q[side_[0]], q[side_[1]], q[side_[2]]}; }

 private:
  Quaternion4 middle_;
  double half_;
  Eigen::Index cube_;
  std::array<Eigen::Index, 3> side_;  // coordinates along the three sides
};

/// What planes leave of a cell, a convex polytope.
class CellPolytope {
 public:
  CellPolytope();  // all of the cell
  /// Keeps the half of a plane; `number`, 6 or more, names it. False, and nothing is kept, if the polytope
  /// has become too complex.
  bool clip(const CellPlane& plane, std::uint32_t number);
  bool empty() const { return faces_ == 0; }
  /// Is some of it where the form may be below 0?
  bool meets(const FormOverCell& form) const;
  double farthest(const CellPlane& plane) const;  // the largest value of its corners
  bool bounds(std::uint32_t number) const;        // is a piece of that plane among its faces?
  /// Share of all rotations, at least.
  double share(const CellFrame& frame) const;

 private:
  static constexpr std::size_t kMostFaces = 30;
  static constexpr std::size_t kMostCorners = kMostFaces + 2;
  struct Polygon {
    std::array<Vec3, kMostCorners> corner;
    std::size_t corners = 0;
    std::uint32_t number = 0;  // of its plane; sides of the cell have the first six
  };
  bool close(const CellPlane& plane, std::uint32_t number, std::size_t cut);

  std::array<Polygon, kMostFaces> face_;
  std::size_t faces_ = 0;
  std::array<Vec3, 2 * kMostFaces> cut_;  // corners of a new face
};

/// What is known of all rotations of a cell.
enum class CellState : std::uint8_t { free, blocked, unknown, open };

/// What is known of parts of a cell.
struct CellPart {
  CellState state = CellState::open;  // of all of it, where that follows
  std::vector<CellPlane> free;     // within all of them every rotation is free; without any, nothing is known
  std::vector<CellPlane> blocked;  // within any of them every rotation is blocked
  double free_share = 0.0;         // of all rotations, at least
  double blocked_share = 0.0;      // the same

  bool empty() const { return free.empty() && blocked.empty(); }
  bool is_free(const Vec3& t) const;
  bool is_blocked(const Vec3& t) const;
  /// Is all of the eighth k of the cell so?
  bool frees(std::uint64_t k) const;
  bool blocks(std::uint64_t k) const;
};

}  // namespace impinge
