// SPDX-License-Identifier: GPL-3.0-or-later
// The two surfaces of a joint.
#pragma once

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Ball and socket, each in its own centre frame, mm (README.md, Frames).
struct BallSocketPair {
  TriangleMesh ball;    // normals outwards
  TriangleMesh socket;  // normals towards the origin
};

}  // namespace impinge
