// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a cell of rotations: half-spaces in which something is certain, and what they leave of the cell.
//
// In the coordinates t of a cell, -1 to 1 along each side, a condition n . R x >= k is a quadratic form. It
// is certain in a half-space that is off by the square of the cell's size: Theorem 14 (volume), (vii).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rotations/rotation_cells.hpp"
#include "sphere/direction.hpp"

namespace impinge {

class CellFrame;

/// A half-space of a cell: slope . t + offset >= 0. Rounded inwards: what it stands for holds in all of it.
struct CellPlane {
  std::array<float, 3> slope{};
  float offset = 0.0F;
  /// The n for which n . q has the same sign at a quaternion q of the cell.
  Quaternion4 normal(const CellFrame& frame) const;
  CellPlane opposite() const { return {{-slope[0], -slope[1], -slope[2]}, -offset}; }
  double at(const Vec3& t) const {
    return static_cast<double>(slope[0]) * t[0] + static_cast<double>(slope[1]) * t[1] +
           static_cast<double>(slope[2]) * t[2] + static_cast<double>(offset);
  }
};

/// A lower bound of sign (n . R x - k) |q|^2 over a cell: middle + slope . t + least.
struct FormOverCell {
  double middle = 0.0;  // its value in the middle
  Vec3 slope = Vec3::Zero();
  double least = 0.0;                                       // at most 0: for the quadratic term and rounding
  double corner() const { return slope.cwiseAbs().sum(); }  // the largest slope . t
  CellPlane plane() const;                                  // where the bound is not below 0
};

/// The coordinates of a cell.
class CellFrame {
 public:
  explicit CellFrame(const RotationCell& cell);
  /// The bound of sign (n . R x - k), with `slack` taken off.
  FormOverCell form(const Vec3& n, const Vec3& x, double k, double sign, double slack) const;
  /// The same, quicker and a little lower, for n as the ball's frame has it in the middle of the cell.
  /// product is |n| |x| or more.
  FormOverCell form_in_ball(const Vec3& n, const Vec3& x, double product, double k, double sign,
                            double slack) const;
  /// Coordinates t of a quaternion of any length.
  Vec3 place(const Quaternion4& q) const;
  const Quaternion4& middle() const { return middle_; }
  double half() const { return half_; }  // of a side's length
  /// Unit quaternion along side k of the cell.
  Quaternion4 side(std::size_t k) const { return Quaternion4::Unit(side_[k]); }
  /// Unit quaternion along the coordinate that is 1 on the cube.
  Quaternion4 across() const { return Quaternion4::Unit(cube_); }
  /// The components of q along the three sides.
  Vec3 sides(const Quaternion4& q) const { return {q[side_[0]], q[side_[1]], q[side_[2]]}; }

 private:
  Quaternion4 middle_;
  Eigen::Matrix3d turned_;  // (n x R x) q, in quaternions, along the three sides, of R^T n x x
  double most_;             // the largest |q|^2
  double half_;
  Eigen::Index cube_;
  std::array<Eigen::Index, 3> side_;  // which components go along the three sides
};

/// What planes leave of a cell, a convex polytope.
class CellPolytope {
 public:
  CellPolytope();  // all of the cell
  /// Keeps what is in the half-space; `number`, 6 or more, names its plane. False, and nothing is kept, if
  /// the polytope has too many faces or corners.
  bool clip(const CellPlane& plane, std::uint32_t number);
  bool empty() const { return faces_ == 0; }
  /// How far, in half sides, some of it is beyond the plane where the bound is 0; 0 if it is nowhere below 0.
  /// Not worked out if it is `most` or more.
  double depth_below(const FormOverCell& form, double most = HUGE_VAL) const;
  double farthest(const CellPlane& plane) const;  // largest value of slope . t + offset
  bool bounds(std::uint32_t number) const;        // is some of the plane of that number a face?
  /// The share of all rotations that it holds, rounded down.
  double share(const CellFrame& frame) const;

 private:
  static constexpr std::size_t kMostFaces = 30;
  static constexpr std::size_t kMostCorners = kMostFaces + 2;
  static constexpr std::size_t kMostPoints = 2 * kMostFaces;
  struct Polygon {
    std::array<Vec3, kMostCorners> corner;
    std::size_t corners = 0;
    std::uint32_t number = 0;  // of its plane; 0 to 5 are the sides of the cell
  };
  void find_middle();
  bool close(const CellPlane& plane, std::uint32_t number, std::size_t cut);

  std::array<Polygon, kMostFaces> face_;
  std::size_t faces_ = 0;
  std::array<Vec3, 2 * kMostFaces> cut_;  // scratch: corners of a new face
  std::array<Vec3, kMostPoints> point_;   // all corners, once each
  std::size_t points_ = 0;
  Vec3 middle_ = Vec3::Zero();
  double radius_ = 1.7320508075688774;  // of a ball round all corners
};

/// What is known of all rotations of a cell.
enum class CellState : std::uint8_t { free, blocked, unknown, open };

/// What is known of parts of a cell.
struct CellPart {
  CellState state = CellState::open;  // of the whole cell, where that follows
  std::vector<CellPlane> free;  // rotations in all of these half-spaces are free; none: nothing is known free
  std::vector<CellPlane> blocked;  // rotations in any of these half-spaces are blocked
  double free_share = 0.0;         // share of all rotations that is known to be free here, rounded down
  double blocked_share = 0.0;      // share of all rotations that is known to be blocked here, rounded down

  bool empty() const { return free.empty() && blocked.empty(); }
  bool is_free(const Vec3& t) const;
  bool is_blocked(const Vec3& t) const;
  /// Is all of the cell's eighth k known to be free, or blocked?
  bool frees(std::uint64_t k) const;
  bool blocks(std::uint64_t k) const;
};

}  // namespace impinge
