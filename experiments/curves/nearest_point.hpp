// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest of many points: a grid of cubes, searched outwards.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

class NearestPoint {
 public:
  /// The points must live as long as this object. `side` is the edge of a cube, about the distance between
  /// neighbouring points; above zero. std::invalid_argument without a point, or where the cubes would be more
  /// than 2^24.
  NearestPoint(std::span<const Vec3> points, double side);

  /// Index of the nearest point; of several as near, the first.
  std::size_t operator()(const Vec3& x) const;

 private:
  struct Cube {
    int x, y, z;
  };
  struct Best {
    std::size_t point;
    double square;  // of its distance
  };

  Cube cube_of(const Vec3& x) const;
  std::size_t number(int x, int y, int z) const;
  void search(std::size_t cube, const Vec3& x, Best& best) const;
  void search_shell(const Cube& own, int reach, const Vec3& x, Best& best) const;

  std::span<const Vec3> points_;
  double side_;
  Vec3 lowest_;
  Cube last_;                       // cubes are 0 ... last_ in each direction
  std::vector<std::size_t> start_;  // of each cube in order_, and the end
  std::vector<std::size_t> order_;  // points by cube
};

}  // namespace impinge
