// SPDX-License-Identifier: GPL-3.0-or-later
// Faces in an order in which those that follow each other are neighbours.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Faces of a mesh in the centre frame along a curve that fills the sphere (Hilbert's, on each face of a
/// cube). Faces whose plane holds the centre are left out. Linear in faces.
std::vector<std::uint32_t> faces_along_curve(const TriangleMesh& mesh);

}  // namespace impinge
