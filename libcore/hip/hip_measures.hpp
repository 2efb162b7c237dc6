// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A hip measured from its meshes alone, by the definitions of hip_parameters.hpp. Angles in degrees, lengths
/// in mm. Of a generated hip they are its parameters, to 0.5 degrees and 0.05 mm (tested).
#pragma once

#include <array>
#include <optional>

#include "hip/anatomy.hpp"
#include "hip/hip_surface.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr std::size_t kClockHours = 12;  // positions at which alpha is measured

/// What somebody who measures has to choose. How far a measure moves when one of these is chosen otherwise is
/// what it can be trusted to (hip/measure_list.hpp).
struct MeasureChoices {
  double trim = 0.06;                // of the spheres, as BallFitOptions::trim
  double neck_section = 1.35;        // where the neck is cut, head radii from the centre
  double alpha_share = kAlphaShare;  // how far a surface is off the head to have left it, head radii
  double alpha_window = 0.3;         // hours to either side of a position, over which alpha is the median
  double shaft_share = 0.35;         // of the mesh beyond the neck that is straight shaft, from its lower end
  double rim_band = 0.15;        // how far the socket's surface may be off its sphere within the rim, radii
  double first_meridian = 0.0;   // of those along which the rim is looked for, in steps
  double plane_tolerance = 1.0;  // of points on the plane of the rim, relative to the least that holds enough
};

/// What is measured of a ball.
struct FemurMeasures {
  SphereFit head;                 // the sphere that fits the head
  Vec3 neck_axis = Vec3::Zero();  // from the centre of the head, in the frame of the mesh
  double neck_radius = 0.0;       // mean distance from the axis, of the neck's section at 1.35 head radii
  double head_neck_offset = 0.0;  // mm, radius of the head minus that of the neck
  std::array<double, kClockHours> alpha{};  // at 12, 1, ... 11 o'clock about the neck axis; NaN where the
                                            /// surface does not leave the head
  double alpha_at_1_30 = 0.0;               // the same half an hour past 1, where most cams are
  /// None where there is no straight shaft:
  std::optional<double> neck_shaft_angle;
  std::optional<double> femoral_torsion;  // degrees, as HipParameters::femoral_torsion
};

/// Joint frame (anatomy.hpp). The neck axis goes through the middle of the curve where the surface is 1.35
/// head radii from the centre; the shaft axis is square to the normals of its lower end, best in the least
/// squares sense, and above six head radii below the centre, where a whole femur widens to the knee; alpha as
/// in hip_surface.hpp, the median within 18 minutes of a position, but that a bump which begins more than 20
/// degrees of head behind the neck is the head's. Torsion is from the transverse axis of the joint frame:
/// that of the knee only where the frame is so. std::invalid_argument, one line, where the mesh has no head
/// or no neck, or ends at the neck.
FemurMeasures measure_femur(const TriangleMesh& ball, Side side, const MeasureChoices& choices = {});

/// What is measured of a socket.
struct AcetabulumMeasures {
  SphereFit socket;             // the sphere that fits its inside
  Vec3 opening = Vec3::Zero();  // axis, out of the socket
  double inclination = 0.0;     // degrees, as in HipParameters
  double version = 0.0;
  double half_opening = 0.0;
  std::optional<double> lateral_centre_edge;  // none if the rim does not cross the coronal plane
  double coverage = 0.0;     // share of all directions from the socket's centre that are within the rim
  double at_mesh_end = 0.0;  // share of the rim's points where the mesh ends: cut there, or made so
};

/// The sphere is that of the faces round the head that look to its centre, whatever else the mesh holds. The
/// rim is where the surface first leaves the sphere, or ends, along 180 meridians from the middle of what is
/// covered, dents of up to 3 degrees aside: the same on a cut socket and on a whole pelvis. Its plane is the
/// one that most of its points lie on within a tenth of a millimetre, or within the least power of two of
/// that which holds a third of them: a raised or lowered part has no say. std::invalid_argument, one line,
/// where there is no socket or no rim.
AcetabulumMeasures measure_acetabulum(const TriangleMesh& socket, const SphereFit& head, Side side,
                                      const MeasureChoices& choices = {});

}  // namespace impinge
