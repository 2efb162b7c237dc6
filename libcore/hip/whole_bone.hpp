// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of a whole bone, such as a femur or a pelvis, are the surface of the joint. The rest of it is
// bone like any other, which can be met. Meshes in the centre frame, mm.
#pragma once

#include <vector>

#include "gap/surface.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr double kJointEnds = 1.5;  // head radii from the centre: head and neck, and a socket's wall

/// Does a mesh hold more bone than its surface of the joint? It does if it reaches beyond 4.5 head radii from
/// the centre, or beyond 2, where a cut one ends, and `hidden`, the share of all directions that meet it more
/// than once, is above 0.02: 0.03 to 0.04 of a femur with its trochanters, 0.1 and more of a pelvis, and
/// below 0.01 of a generated hip, whose stump of a shaft ends within 4.4 radii.
bool is_whole_bone(const TriangleMesh& bone, double hidden, double head_radius);

/// By face: is it of the joint? A face of a ball is if it is within kJointEnds of the centre, one of a socket
/// if it looks to the centre, too; and if it is of the largest part by area that is so and connected. A bone
/// whose volume is negative is inside out.
std::vector<bool> faces_of_joint(const TriangleMesh& bone, Surface of, double head_radius);

/// Makes the faces that are marked the main surface of a mesh, and the others its first part, which is called
/// `rest` and goes on from it (MeshPart::of_main); parts it has stay behind. `of_joint` has one value a face
/// of the main surface before, both values among them. Vertices between the two are in both.
void split_bone(TriangleMesh& mesh, std::vector<MeshPart>& parts, const std::vector<bool>& of_joint,
                const std::string& rest);

}  // namespace impinge
