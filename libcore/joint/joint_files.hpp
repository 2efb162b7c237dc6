// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of the files written for a pose. Positions are those of the pose, in the input frame, mm.
#pragma once

#include <functional>
#include <string>

#include "joint/gaps.hpp"
#include "mesh/ply_writer.hpp"

namespace impinge {

std::string gaps_csv(const SessionJoint& joint, const GapsAnswer& found);  // as hip/gap_files.hpp has it

/// CSV surface,vertex,gap_mm,distance_lower_mm,distance_upper_mm; `found` must have distances.
std::string distances_csv(const GapsAnswer& found);

/// One surface as `write` makes a file of it, with the values of its vertices: `gap`, `radial_overlap` (how
/// deep the other surface is passed along the ray, 0 where it is not; both NaN where it is not met), mm; and
/// colours of the gaps.
std::string surface_file(const SessionJoint& joint, const GapsAnswer& found, Surface surface,
                         const std::function<std::string(const TriangleMesh&, const MeshNotes&)>& write);

}  // namespace impinge
