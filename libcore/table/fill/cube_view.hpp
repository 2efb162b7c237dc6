// SPDX-License-Identifier: GPL-3.0-or-later
// The corners of a mesh as seen from the centre through the faces of a cube map.
//
// A corner v is seen through face f, whose axis is k and whose sign is s, at
//   x = (v_a / d + 1) n / 2,  y = (v_b / d + 1) n / 2,  d = s v_k,
// so that entry (i, j) of the face is at (i, j). A plane has an inverse depth q = 1 / d that is affine in
// (x, y), and an edge is a straight line.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "table/fill/cube_tiles.hpp"

namespace impinge {

/// A corner on the grid of a face of the cube.
struct SeenCorner {
  double x = 0.0;          // cells
  double y = 0.0;          // cells
  double q = 0.0;          // 1 / mm
  std::uint32_t face = 0;  // through which it is seen
};

/// How a face of the mesh is seen through a face of the cube.
struct SeenFace {
  std::array<SeenCorner, 3> corners;  // through that face
  GridWindow window;                  // all entries that it can hold
  bool projected = false;  // are the corners known? Not if one of them is beside or behind the centre
};

/// All corners, each through the face that it is in front of. Corners at the centre are seen through none.
class CubeView {
 public:
  static constexpr double kLeastReach = 1e-6;  // cells, of a window beyond its face: far above rounding

  /// Of a cube map with so many cells along an edge; the mesh, in the centre frame, must outlive this.
  CubeView(const TriangleMesh& mesh, std::size_t divisions);

  /// Must be called for all vertices before anything below; threads may share them out.
  void see(std::size_t first_vertex, std::size_t end_vertex);

  const TriangleMesh& mesh() const { return *mesh_; }   // that is seen
  std::size_t divisions() const { return divisions_; }  // cells along an edge

  /// Is the whole of the face well inside one face of the cube? Then that is the only one it is seen through,
  /// and its corners are known.
  bool inside_one(const Face& face) const {
    return margin_face_[face[0]] != kNone && margin_face_[face[0]] == margin_face_[face[1]] &&
           margin_face_[face[1]] == margin_face_[face[2]];
  }
  /// A corner through the face that it is in front of.
  const SeenCorner& corner(VertexIndex v) const { return corners_[v]; }
  /// Are all corners in front of that face of the cube? Then they are known through it.
  bool in_front(const Face& face, std::size_t through) const {
    return in_front(corners_[face[0]], through) && in_front(corners_[face[1]], through) &&
           in_front(corners_[face[2]], through);
  }
  /// The window of a face that is inside_one().
  GridWindow window_inside(const Face& face) const;

  /// Bit f: the face may be seen through face f of the cube.
  unsigned may_be_seen(const Face& face) const;

  /// How it is seen through a face of the cube whose bit is set in may_be_seen().
  SeenFace seen(const Face& face, std::size_t through) const;

 private:
  static constexpr std::uint8_t kNone = 255;
  static constexpr double kMostInverse = 0x1p500;  // 1 / mm: corners nearer to the centre are not projected

  static bool in_front(const SeenCorner& corner, std::size_t through) {
    return corner.face == through && corner.q < kMostInverse;
  }
  SeenFace seen_across(const Face& face, std::size_t through) const;
  GridWindow window_of(const std::array<SeenCorner, 3>& corners) const;

  const TriangleMesh* mesh_;
  std::size_t divisions_;
  std::vector<SeenCorner> corners_;
  std::vector<std::uint8_t> margin_face_;  // the same as corners_[v].face, kNone near the edges of the cube
};

inline GridWindow CubeView::window_of(const std::array<SeenCorner, 3>& corners) const {
  const auto [a, b, c] = corners;
  const double most = static_cast<double>(divisions_);
  const auto first = [=](double x, double y, double z) {  // rounded up
    const double from = std::clamp(std::min({x, y, z}) - kLeastReach, 0.0, most + 1.0);
    const auto line = static_cast<long>(from);
    return static_cast<double>(line) < from ? line + 1 : line;
  };
  const auto last = [=](double x, double y, double z) {  // rounded down, from -1 on
    return static_cast<long>(std::clamp(std::max({x, y, z}) + kLeastReach, -1.0, most) + 1.0) - 1;
  };
  return {first(a.x, b.x, c.x), last(a.x, b.x, c.x), first(a.y, b.y, c.y), last(a.y, b.y, c.y)};
}

inline GridWindow CubeView::window_inside(const Face& face) const {
  const SeenCorner& a = corners_[face[0]];
  const SeenCorner& b = corners_[face[1]];
  const SeenCorner& c = corners_[face[2]];
  const auto first = [](double x, double y, double z) {  // rounded up
    const double from = std::min(std::min(x, y), z) - kLeastReach;
    const auto line = static_cast<long>(from);
    return line + static_cast<long>(static_cast<double>(line) < from);
  };
  const auto last = [](double x, double y, double z) {
    return static_cast<long>(std::max(std::max(x, y), z) + kLeastReach + 1.0) - 1;
  };
  return {first(a.x, b.x, c.x), last(a.x, b.x, c.x), first(a.y, b.y, c.y), last(a.y, b.y, c.y)};
}

inline SeenFace CubeView::seen(const Face& face, std::size_t through) const {
  if (!in_front(face, through)) return seen_across(face, through);
  const std::array<SeenCorner, 3> own{corners_[face[0]], corners_[face[1]], corners_[face[2]]};
  return {own, window_of(own), true};
}

}  // namespace impinge
