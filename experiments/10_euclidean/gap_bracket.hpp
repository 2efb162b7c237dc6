// SPDX-License-Identifier: GPL-3.0-or-later
// What radial gaps say about the Euclidean distance d from a point x to a surface, proven:
//
//   min(D, m / L) <= d <= m,   m = min(|g_1|, |g_2|, ..., e),   L = root(1 + k^2 tan^2 psi)
//
// g_1, g_2, ... are the gaps |x| - r along the direction of x, one for each layer of the surface there; e is
// the distance from x to the nearest jump edge, where a layer ends (mesh/jump_edges.hpp). D < |x| is any
// length; psi is the largest angle between direction and normal over all faces that are seen within
// asin(D / |x|) of x, and k bounds the ratio r / |y| of the radii of the surface and of a point y between x
// and its nearest point. L grows with D, so that the best D is the one that equals m / L. Next to a smooth
// surface L is close to 1 / cos psi: inside a socket the gap and the distance differ by a few per cent; at a
// neck the gap is the larger by far, and beyond a rim e counts.
//
// Proof. The ends of g_1, ... and e lie on the surface: d <= m. For the other side let z be the point of the
// surface nearest to x, and d <= D, else there is nothing to show. Go from z straight to x and follow, on the
// surface, what is seen in the direction of each point y of the way, from face to face across every edge that
// is no jump edge. The radius r of this layer is continuous along the way, and G(y) = |y| - r(y / |y|) has
//   |grad G| = root(1 + (r / |y|)^2 tan^2 psi) <= L,
// as all of the way lies in the ball about x of radius D, which is seen within asin(D / |x|). Either the
// layer reaches the direction of x. Then one of the gaps is its own: |g_i| = |G(x) - G(z)| <= L d. Or it ends
// in a point p of a jump edge, seen in the direction of some y of the way. Then |x - p| <= |x - y| + |y - p|
// and |y - p| = |G(y) - G(z)| <= L |y - z|, together <= L d as L >= 1.
// The bound k: in that ball |y| >= |x| - D, so that k = R / (|x| - D) will do, R the largest radius of those
// faces. And as G(z) = 0, r / |y| <= 1 + L D / (|x| - D) with the L of the largest ratio met so far; a ratio
// that is 1 in z cannot pass the root of k = 1 + q root(1 + k^2 tan^2 psi), q = D / (|x| - D), which there is
// for q tan psi < 1. The smaller of the two counts.
//
// A bound with the slope at x alone, with the layer of a table alone, or without e is wrong: where a cliff is
// near, beneath a fold, and next to a rim.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "table/direction_index.hpp"

namespace impinge::lab {

/// Ends of a Euclidean distance, and what they were made of. Lengths in mm; infinite where there is none.
struct DistanceEnds {
  double lower_mm = 0.0;                                     // d is no less
  double upper_mm = 0.0;                                     // d is no more
  double gap_mm = std::numeric_limits<double>::infinity();   // least of |g_1|, |g_2|, ...
  double slope = 0.0;                                        // tan psi where that gap ends
  double edge_mm = std::numeric_limits<double>::infinity();  // e
};

/// Allowance for rounding at both ends, of |x| + R, R the farthest corner of all faces. With u = 2^-53 and T
/// = tan psi a radius is off by 84 u (1 + T) of itself (table/error_bound.hpp): by 1e-10 for T up to 1e4. The
/// gap of a steeper face is replaced by the distances of its corners. At the lower end it is divided by L >=
/// root(1 + k^2 T^2), k >= min(1, r / |x|), so that 168 u (|x| + R) of it are left at any T. Distances from
/// corners and jump edges are off by 20 u (|x| + R). L itself is made from outside.
inline constexpr double kDistanceAllowance = 1e-9;

/// A mesh made ready for many points: what is near each entry of a grid of about a degree. A point costs what
/// the entries within asin(m / |x|) of it and all jump edges do.
class GapBracket {
 public:
  /// mesh in its centre frame, mm; copied. Throws std::invalid_argument for one without faces.
  explicit GapBracket(TriangleMesh mesh);

  /// Bracket of the distance from x (mm, in the frame of the mesh) to the nearest point of any face. A face
  /// whose plane holds the centre has no slope: the lower end is below the distance of a ball round it.
  DistanceEnds at(const Vec3& x) const;

 private:
  struct Segment {
    Vec3 from;
    Vec3 to;
  };
  struct Ball {
    Vec3 middle;
    double radius;
  };
  /// Some jump edges, and a ball that holds them.
  struct Clump {
    Ball round;
    std::size_t first;  // of jumps_
    std::size_t last;   // one beyond
  };
  /// Of the faces within the covering radius of an entry. Lengths in mm.
  struct Near {
    double slope = 0.0;   // largest tan psi
    double radius = 0.0;  // largest
    /// Of the crossings along the entry itself.
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0.0;
  };
  /// What counts once D has this length, mm.
  struct Slope {
    double from;
    double slope;
    double radius;
  };

  void clump_jumps();
  void list_face(std::size_t f);
  std::size_t entry_next_to(const Vec3& u) const;
  DistanceEnds gap_and_edge(const Vec3& x, const Vec3& u) const;
  double shortened(const Vec3& x, double upper) const;
  std::vector<Slope> slopes_near(const Vec3& x, double farthest) const;
  double lower_end(const Vec3& x, const DistanceEnds& found) const;

  template <class Visit>
  void for_each_within(const Vec3& u, double angle, Visit&& visit) const;

  TriangleMesh mesh_;
  double farthest_corner_ = 0.0;  // mm
  DirectionIndex index_;
  double listed_within_;        // radians
  std::vector<Near> near_;      // of each entry of the grid
  std::vector<Segment> jumps_;  // jump edges
  std::vector<Clump> clumps_;   // of them
  std::vector<Ball> edge_on_;   // round the faces whose plane holds the centre
};

}  // namespace impinge::lab
