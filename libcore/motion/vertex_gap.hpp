// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest gap of any vertex in a pose, measured on the faces: no table, no interpolation.
#pragma once

#include <optional>

#include "gap/surface.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// A vertex with the smallest gap.
struct VertexGap {
  double gap_mm = 0.0;        // of the vertex
  Vec3 place = Vec3::Zero();  // of the vertex, mm, centre frame of the socket
};

/// Two surfaces made ready to be asked in many poses.
class VertexGaps {
 public:
  /// Meshes in their centre frames, mm; they must outlive this.
  VertexGaps(const TriangleMesh& ball, const TriangleMesh& socket);

  /// The smallest of both scans; none where no vertex meets the other surface. The nearest layer stands for
  /// the socket and the farthest for the ball. A few milliseconds for 12,000 faces.
  std::optional<VertexGap> smallest(const Pose& pose) const;

 private:
  NearFaces ball_;
  NearFaces socket_;
};

}  // namespace impinge
