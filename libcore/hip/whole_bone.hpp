// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of a whole bone, such as a femur or a pelvis, are the surface of the joint. The rest is bone
// that can be met like any other. Meshes in the centre frame, mm.
#pragma once

#include <vector>

#include "gap/surface.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr double kJointEnds =
    1.5;  // head radii from the centre: it holds head and neck, and a socket's wall

/// Does a mesh hold more bone than the surface of the joint? It does if it reaches beyond 4.5 head radii from
/// the centre. It also does if it reaches beyond 2, where a cut bone ends, and `hidden`, the share of all
/// directions that meet it more than once, is above 0.02. That share is 0.03 to 0.04 for a femur with its
/// trochanters, 0.1 and more for a pelvis, and below 0.01 for a generated hip, whose shaft ends within 4.4.
bool is_whole_bone(const TriangleMesh& bone, double hidden, double head_radius);

/// For each face: is it of the joint? A face of a ball is if it lies within kJointEnds of the centre; a face
/// of a socket must look to the centre, too. Of these only the largest connected part by area counts. A bone
/// with negative volume is taken as inside out.
std::vector<bool> faces_of_joint(const TriangleMesh& bone, Surface of, double head_radius);

/// Makes the marked faces the main surface of a mesh. The other faces become its first part, called `rest`,
/// which continues the main surface (MeshPart::of_main); earlier parts follow. `of_joint` has one value for
/// each face of the main surface so far, and both values occur. Vertices on the border are in both.
void split_bone(TriangleMesh& mesh, std::vector<MeshPart>& parts, const std::vector<bool>& of_joint,
                const std::string& rest);

}  // namespace impinge
