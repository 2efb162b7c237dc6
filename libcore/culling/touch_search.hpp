// SPDX-License-Identifier: GPL-3.0-or-later
// Does a vertex of either scan touch the other surface? Whole caps of vertices are decided at once; what is
// left over is asked vertex by vertex, of whoever is given. The answer is that of asking all vertices.
//
// Whoever is asked must keep to the limits: its radii are those of the mesh, or means of radii within the
// margin of the direction (see culling/cap_limits.hpp).
#pragma once

#include <array>
#include <optional>

#include "culling/cap_move.hpp"
#include "culling/culled_scan.hpp"

namespace impinge {

// Who is asked about single vertices: a function object that is borrowed.
class VertexQuestion {
 public:
  // asked(vertex, x), x being where the pose has it, mm, says whether it touches: a gap of 0 or
  // less.
  template <class Asked>
  explicit VertexQuestion(const Asked& asked)
      : asked_(&asked), call_([](const void* self, const ScannedVertex& at, const Vec3& x) {
          return static_cast<bool>((*static_cast<const Asked*>(self))(at, x));
        }) {}

  // The answer.
  bool operator()(const ScannedVertex& at, const Vec3& x) const { return call_(asked_, at, x); }

 private:
  const void* asked_;
  bool (*call_)(const void*, const ScannedVertex&, const Vec3&);
};

// Both scans of a pose: those of the ball's vertices and of the socket's.
struct PosedScans {
  // Scans of the ball and of the socket, which are borrowed.
  PosedScans(const std::array<CulledScan, 2>& of, const Pose& pose)
      : scans(of), moves{CapMove(ScannedSurface::ball, pose), CapMove(ScannedSurface::socket, pose)} {}

  const std::array<CulledScan, 2>& scans;  // borrowed
  std::array<CapMove, 2> moves;            // of their vertices
};

// Among all vertices of both scans: one that touches, if one does.
std::optional<ScannedVertex> touching_vertex(const PosedScans& posed, const VertexQuestion& touches);

}  // namespace impinge
