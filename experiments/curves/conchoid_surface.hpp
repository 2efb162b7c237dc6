// SPDX-License-Identifier: GPL-3.0-or-later
// Sample points on the surface that a conchoid sweeps about its axis, from the apex to its rim at phi = 90
// degrees, and the area that each one represents. Points in the conchoid frame, mm.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "curves/conchoid.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// A ring of per_ring points at each of these polar angles (radians), from azimuth 0 on, as rays at equal
/// theta sample. A ring at the apex has all of its points in one place, as a latitude grid has.
std::vector<Vec3> conchoid_rings(const ConchoidShape& shape, std::span<const double> angles,
                                 std::size_t per_ring);

/// The equal-area spiral of count >= 1 points. Each point represents the same area of the cap, A(phi_i) = (i
/// + 1/2) A / count. Turns are as far apart along the meridian, h = sqrt(A / count), as points along a turn:
/// theta_i = 2 pi s(phi_i) / h, with s the length of the meridian.
std::vector<Vec3> conchoid_spiral(const ConchoidShape& shape, std::size_t count);

/// Area of the cap that is nearer to each point than to any other (mm^2, Euclidean). Equal small pieces are
/// counted, about pieces_per_point >= 1 per point. Points in one place share their area; all areas sum to the
/// cap's. Throws std::invalid_argument without a point.
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
  std::size_t points = 0;  // points in the band
  double smallest = 0.0;   // mm^2
  double mean = 0.0;       // mm^2
  double largest = 0.0;    // mm^2
};

/// nearest_areas() in bands of equal angle from apex to rim. Leaves out points nearer to the rim than
/// sqrt(area / points), whose area the rim cuts; a band without points is not listed.
std::vector<AreaBand> area_bands(const ConchoidShape& shape, std::span<const Vec3> points,
                                 const AreaBandOptions& options = {});

// The nearest of many points: a grid of cubes, searched outwards.

class NearestPoint {
 public:
  /// The points must outlive this object. `side` is the edge of a cube, above 0, about the distance between
  /// neighbouring points. Throws std::invalid_argument without a point, or for more than 2^24 cubes.
  NearestPoint(std::span<const Vec3> points, double side);

  /// Index of the nearest point; of equally near ones the first.
  std::size_t operator()(const Vec3& x) const;

 private:
  struct Cube {
    int x, y, z;
  };
  struct Best {
    std::size_t point;
    double square;  // squared distance
  };

  Cube cube_of(const Vec3& x) const;
  std::size_t number(int x, int y, int z) const;
  void search(std::size_t cube, const Vec3& x, Best& best) const;
  void search_shell(const Cube& own, int reach, const Vec3& x, Best& best) const;

  std::span<const Vec3> points_;
  double side_;
  Vec3 lowest_;
  Cube last_;                       // indices of cubes run from 0 to last_ in each direction
  std::vector<std::size_t> start_;  // where each cube begins in order_, and the end
  std::vector<std::size_t> order_;  // points by cube
};

}  // namespace impinge
