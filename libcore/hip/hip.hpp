// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A hip made from parameters: femoral head, neck and a stump of the shaft; acetabulum with its rim.
#pragma once

#include <cstddef>
#include <vector>

#include "hip/hip_parameters.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

struct Hip {
  TriangleMesh ball;  // closed, outward normals; star-shaped about the centre up to the bend of the shaft, or
                      // everywhere if shaft_length is 0
  TriangleMesh socket;  // normals towards the centre; open and star-shaped, or with a wall a closed shell
  /// Closed bodies at the end of each mesh (mesh/mesh_parts.hpp). The comments above describe the meshes
  /// without them.
  std::vector<MeshPart> ball_parts;
  std::vector<MeshPart> socket_parts;  // closed bodies of the socket
};

inline constexpr std::size_t kHipFaces = 12000;  // faces per surface, as in the thesis

inline constexpr std::size_t kFewestHipFaces = 500;  // fewest faces per surface that make_hip() accepts
/// The ball and the socket with these parameters: joint frame, mm, the centre of the head as origin. Vertices
/// lie on the smooth surfaces of hip_surface.hpp, closer together where head and neck meet; one ring of them
/// is the rim. Each surface has about `faces` faces (within 3 %); edges of the parts are about twice as long.
/// The left hip is the mirror image of the right one. Throws std::invalid_argument for fewer than
/// kFewestHipFaces faces and for parameters that make no hip (hip_checks.hpp).
Hip make_hip(const HipParameters& parameters, std::size_t faces = kHipFaces);

/// Ball and socket without their parts.
BallSocketPair main_surfaces(const Hip& hip);

}  // namespace impinge
