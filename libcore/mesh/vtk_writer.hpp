// SPDX-License-Identifier: GPL-3.0-or-later
// Writes PolyData files of VTK. Coordinates and values are doubles; check_notes() must hold.
#pragma once

#include <string>

#include "mesh/ply_writer.hpp"

namespace impinge {

/// An XML file (.vtp): points and faces as text, since Simbody and OpenSim read nothing else; values in
/// base64, since VTK reads no NaN from text.
std::string vtp_bytes(const TriangleMesh& mesh, const MeshNotes& notes);

/// A legacy file (.vtk), binary, of version 3.0, which releases before VTK 9 read too.
std::string vtk_bytes(const TriangleMesh& mesh, const MeshNotes& notes);

/// A line for each point: `start`, then x y z, as the shortest numbers that read back as the same doubles.
std::string point_lines(const TriangleMesh& mesh, const std::string& start);

}  // namespace impinge
