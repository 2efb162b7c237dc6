// SPDX-License-Identifier: GPL-3.0-or-later
// When do two surfaces, one of which turns about an axis, first come within a distance of each other that
// depends on the angle?
//
// Both are trees of spheres. Two spheres whose centres are at heights z and y above the plane across the
// axis, at a and b from it and at azimuths f + t and g are D apart where
//   4 a b sin^2((f + t - g) / 2) = D^2 - (z - y)^2 - (a - b)^2,
// which gives the angles at which their contents may be that near, whatever they are. No turn changes a
// distance from the origin: where one is farther out than the other by more than that, as a socket is than
// most of the head, they never are. The pair that may be first is opened next; two triangles in the end have
// their span of angles halved. The search ends when no pair can be earlier than what was found.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "motion/sinusoid.hpp"
#include "motion/turn_surface.hpp"

namespace impinge {

/// Triangles (a point is one without extent), in a tree. `doubt` of a part, mm, is by how much nearer it may
/// be than it is drawn.
class SweptParts {
 public:
  /// A sphere that holds one part, or two nodes further on.
  struct Node {
    Vec3 centre;            // mm
    double radius = 0.0;    // mm, doubt included
    std::uint32_t at = 0;   // of the part, or of the first of the two nodes
    bool leaf = true;       // is it one part?
    double nearest = 0.0;   // mm, of the parts from the origin, doubt included
    double farthest = 0.0;  // mm, the same
  };

  explicit SweptParts(std::vector<TurnFace> parts);  // in their centre frame, mm; takes n log n

  const std::vector<TurnFace>& parts() const { return parts_; }  // in their order
  const std::vector<Node>& nodes() const { return nodes_; }      // the root first; none without parts
  /// The same parts after a rotation.
  SweptParts rotated(const Eigen::Matrix3d& rotation) const;
  /// Is every part farther than `distance` from x? mm.
  bool farther_than(double distance, const Vec3& x) const;
  /// Is a point of one no farther than that from x, up to rounding? mm.
  bool within(double distance, const Vec3& x) const;

 private:
  template <class Found>
  bool any_part(double distance, const Vec3& x, const Found& found) const;
  void split(std::uint32_t* first, std::uint32_t* last, std::uint32_t node);

  std::vector<TurnFace> parts_;
  std::vector<Node> nodes_;
};

/// Are these farther apart than `distance`, mm? Of no use where they pierce each other.
bool farther_than(const TurnFace& s, const TurnFace& t, double distance);

/// The largest distance that is asked for in a span of angles, mm.
using WithinSpan = std::function<double(const AngleSpan&)>;

/// The first angle up to `largest` at which the turning parts may be within that distance of those at rest;
/// no pair is before, and what is returned is early by the way of 1e-5 rad at most unless parts stay about as
/// near as that; `largest` if there is none. +z is the axis; largest in [0, 2 pi].
/// Parts that pierce each other at the start may go unseen: distances are those of corners and edges.
double first_within(const SweptParts& turning, const SweptParts& resting, const WithinSpan& within,
                    double largest);

}  // namespace impinge
