// SPDX-License-Identifier: GPL-3.0-or-later
// Sample points on the surface that a conchoid sweeps about its axis, from the apex to its rim at phi = 90
// degrees, and how much of the surface each one stands for. Points in the conchoid frame, mm.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "curves/conchoid.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// A ring of per_ring points at each of these polar angles (radians), from azimuth 0 on: what rays at equal
/// theta sample. A ring at the apex has all of its points there, as a latitude grid has.
std::vector<Vec3> conchoid_rings(const ConchoidShape& shape, std::span<const double> angles,
                                 std::size_t per_ring);

/// The equal-area spiral: count >= 1 points, each for the same area of the cap, A(phi_i) = (i + 1/2) A /
/// count, on turns that are as far apart along the meridian, h = sqrt(A / count), as points are along a turn:
/// theta_i = 2 pi s(phi_i) / h, with s the length of the meridian.
std::vector<Vec3> conchoid_spiral(const ConchoidShape& shape, std::size_t count);

/// Area of the cap that is nearer to each point than to any other (mm^2, Euclidean), by counting equal small
/// pieces, about pieces_per_point >= 1 a point. Points in one place share it. The areas sum to the cap's.
/// std::invalid_argument without a point.
std::vector<double> nearest_areas(const ConchoidShape& shape, std::span<const Vec3> points,
                                  std::size_t pieces_per_point);

/// How finely areas are counted, and in how many bands.
struct AreaBandOptions {
  std::size_t pieces_per_point = 400;  // of the area of the cap
  std::size_t bands = 9;               // of equal angle, from apex to rim
};

/// Areas (mm^2) of the points with from_deg <= phi < to_deg.
struct AreaBand {
  double from_deg = 0.0;   // where the band begins
  double to_deg = 0.0;     // where it ends
  std::size_t points = 0;  // that count in the band
  double smallest = 0.0;   // mm^2
  double mean = 0.0;       // mm^2
  double largest = 0.0;    // mm^2
};

/// nearest_areas() in bands of equal angle from apex to rim. Points nearer to the rim than sqrt(area /
/// points), whose area the rim cuts, are left out; a band without a point is not listed.
std::vector<AreaBand> area_bands(const ConchoidShape& shape, std::span<const Vec3> points,
                                 const AreaBandOptions& options = {});

// The nearest of many points: a grid of cubes, searched outwards.

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
