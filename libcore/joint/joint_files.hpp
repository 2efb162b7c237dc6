// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of the files written for a pose. Places are those of the pose, in the input frame, mm.
#pragma once

#include <functional>
#include <string>

#include "joint/gaps.hpp"
#include "mesh/ply_writer.hpp"

namespace impinge {

std::string gaps_csv(const SessionJoint& joint, const GapsAnswer& found);  // see hip/gap_files.hpp

/// CSV text surface,vertex,gap_mm,distance_lower_mm,distance_upper_mm; `found` must have distances.
std::string distances_csv(const GapsAnswer& found);

/// The text that `write` makes of one surface. Values of its vertices are `gap` and `radial_overlap`, mm: how
/// deep a vertex lies behind the other surface along its ray, 0 where it does not. Both are NaN where the
/// other surface is not met. Colours show the gaps.
std::string surface_file(const SessionJoint& joint, const GapsAnswer& found, Surface surface,
                         const std::function<std::string(const TriangleMesh&, const MeshNotes&)>& write);

}  // namespace impinge
