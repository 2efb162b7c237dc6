// SPDX-License-Identifier: GPL-3.0-or-later
// How deep in bone is a ray from the centre, as the faces that it crosses say? Bone of two shells that
// overlap counts twice.
#pragma once

#include <optional>

#include "table/near_faces.hpp"

namespace impinge {

/// Counted from outside, where there is no bone: 1 more at a face with its outside away from the centre, 1
/// less at any other.
struct BoneAlongRay {
  int least = 0;      // below 0, some faces are the other way round than others
  int at_centre = 0;  // how often the centre is in bone
};

/// Along unit u; with `inside_out` all faces are taken the other way round. None where u passes an edge
/// within rounding.
std::optional<BoneAlongRay> bone_along(const NearFaces& faces, const Vec3& u, bool inside_out);

/// Is the mesh, mm about the centre, closed and of one orientation, with the centre outside of its bone? A
/// shell that is inside out beside others has to show along a ray through the middle of some face. (A cavity
/// in the bone of another shell is no such shell.)
bool is_bone_beside_centre(const TriangleMesh& mesh);

}  // namespace impinge
