// SPDX-License-Identifier: GPL-3.0-or-later
// PolyData files of VTK. Coordinates and values are doubles; check_notes() must hold.
#pragma once

#include <string>

#include "mesh/ply_writer.hpp"

namespace impinge {

/// XML (.vtp): points and faces as text, which Simbody and OpenSim read alone; the values in base64, since
/// VTK reads no NaN from text.
std::string vtp_bytes(const TriangleMesh& mesh, const MeshNotes& notes);

/// Legacy (.vtk), binary, of version 3.0, which releases before VTK 9 read too.
std::string vtk_bytes(const TriangleMesh& mesh, const MeshNotes& notes);

/// A line of each point: `start`, then x y z, the shortest numbers that read back as the same doubles.
std::string point_lines(const TriangleMesh& mesh, const std::string& start);

}  // namespace impinge
