// SPDX-License-Identifier: GPL-3.0-or-later
// The plane or sphere that leaves the fewest pairs of faces (limits/clear_cuts.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limits/cut_faces.hpp"

namespace impinge {

/// Faces of both bodies.
struct CutNode {
  std::vector<std::uint32_t> ball;  // places in their CutFaces
  std::vector<std::uint32_t> socket;
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

/// A good one, not always the best; no node may be proven. `axis`: of the turn.
CutChoice choose_cut(const CutFaces& ball, const CutFaces& socket, const CutNode& node, const Vec3& axis);

/// By a plane between the first face of each, as the middle of the arc has them. Each is in one part alone,
/// if they are apart.
CutChoice cut_between_first(const CutFaces& ball, const CutFaces& socket, const CutNode& node);

}  // namespace impinge
