// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A hip measured from its meshes alone, by the definitions of hip_parameters.hpp. Angles in degrees, lengths
/// in mm. Of a generated hip they are its parameters, to 0.5 degrees and 0.05 mm (tested).
#pragma once

#include <array>
#include <optional>

#include "hip/anatomy.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr std::size_t kClockHours = 12;  // positions at which alpha is measured

/// What is measured of a ball.
struct FemurMeasures {
  SphereFit head;                 // the sphere that fits the head
  Vec3 neck_axis = Vec3::Zero();  // from the centre of the head, in the frame of the mesh
  double neck_radius = 0.0;       // mean distance from the axis, of the neck's section at 1.35 head radii
  double head_neck_offset = 0.0;  // mm, radius of the head minus that of the neck
  std::array<double, kClockHours> alpha{};  // at 12, 1, ... 11 o'clock about the neck axis; NaN where the
                                            /// surface does not leave the head
  /// None where there is no straight shaft:
  std::optional<double> neck_shaft_angle;
  std::optional<double> femoral_torsion;  // degrees, as HipParameters::femoral_torsion
};

/// Joint frame (anatomy.hpp). The neck axis goes through the middle of the curve where the surface is 1.35
/// head radii from the centre; the shaft axis is square to the normals of its lower end, best in the least
/// squares sense; alpha as in hip_surface.hpp. std::invalid_argument, one line, where the mesh has no head or
/// no neck.
FemurMeasures measure_femur(const TriangleMesh& ball, Side side);

/// What is measured of a socket.
struct AcetabulumMeasures {
  SphereFit socket;             // the sphere that fits its inside
  Vec3 opening = Vec3::Zero();  // axis, out of the socket
  double inclination = 0.0;     // degrees, as in HipParameters
  double version = 0.0;
  double half_opening = 0.0;
  std::optional<double> lateral_centre_edge;  // none if the rim does not cross the coronal plane
};

/// The rim runs where faces that look to the centre border on nothing, or on faces that do not. Its plane is
/// the one that most of its points lie on within a tenth of a millimetre: a raised or lowered part has no
/// say. `head_centre` is that of the head, for the centre-edge angle. std::invalid_argument as above.
AcetabulumMeasures measure_acetabulum(const TriangleMesh& socket, const Vec3& head_centre, Side side);

}  // namespace impinge
