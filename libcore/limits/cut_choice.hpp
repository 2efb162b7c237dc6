// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the plane or sphere that leaves the fewest pairs of faces (limits/clear_cuts.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limits/cut_faces.hpp"

namespace impinge {

/// Faces of both bodies.
struct CutNode {
  std::vector<std::uint32_t> ball;    // indices into the ball's CutFaces
  std::vector<std::uint32_t> socket;  // indices into the socket's CutFaces
  double pairs() const { return static_cast<double>(ball.size()) * static_cast<double>(socket.size()); }
  bool proven() const { return ball.empty() || socket.empty(); }
};

/// A node cut by a plane or a sphere.
struct CutChoice {
  ClearCut cut;
  CutNode first;
  CutNode second;
  double pairs() const { return first.pairs() + second.pairs(); }
};

/// A good cut, not always the best one, of a node that is not proven. `axis`: unit axis of the turn.
CutChoice choose_cut(const CutFaces& ball, const CutFaces& socket, const CutNode& node, const Vec3& axis);

/// A cut by a plane between the first face of the ball and the first of the socket, as they are in the middle
/// of the arc. If these are apart, each is in one child alone.
CutChoice cut_between_first(const CutFaces& ball, const CutFaces& socket, const CutNode& node);

}  // namespace impinge
