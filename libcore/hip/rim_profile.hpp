// SPDX-License-Identifier: GPL-3.0-or-later
// The rim of a socket: where its surface leaves the sphere that fits its inside.
#pragma once

#include <optional>
#include <vector>

#include "hip/hip_measures.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// The rim, relative to the centre of the socket's sphere, mm.
struct RimProfile {
  Vec3 pole = Vec3::UnitX();                // unit vector into the socket
  std::vector<std::optional<Vec3>> points;  // one per meridian about the pole; none where it has no rim
  double coverage = 0.0;                    // share of all directions that are within the rim
};

/// The faces that may bound the socket, about the centre of its sphere.
TriangleMesh near_socket(const TriangleMesh& socket, const SphereFit& sphere);

/// Finds where the surface `near` first leaves the sphere, or ends, along 180 meridians from the middle of
/// the socket; dents of up to 3 degrees are bridged. Of the choices only rim_band and first_meridian are
/// used. Throws std::invalid_argument, one line, if there is no socket or no rim.
RimProfile rim_profile(const TriangleMesh& near, double radius, const MeasureChoices& choices = {});

}  // namespace impinge
