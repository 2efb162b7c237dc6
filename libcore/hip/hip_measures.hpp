// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A hip measured from its meshes alone, by the definitions of hip_parameters.hpp. Angles in degrees, lengths
/// in mm. On a generated hip the measures equal its parameters to 0.5 degrees (alpha_notzli to 0.8) and 0.05
/// mm (tested).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hip/anatomy.hpp"
#include "hip/hip_surface.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/sphere_section.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr std::size_t kClockHours = 12;  // positions at which alpha is measured

/// Choices that a measurement has to make. How far a measure moves when one of them is varied is its
/// uncertainty (hip/measure_list.hpp).
struct MeasureChoices {
  double trim = 0.06;                // of both spheres, see BallFitOptions::trim
  double neck_section = 1.35;        // where the neck is cut, head radii from the centre
  double alpha_share = kAlphaShare;  // where the surface is this far off the head it has left it, head radii
  double alpha_window = 0.3;         // alpha is the median over these many hours to either side of a position
  double shaft_share = 0.35;  // share of the mesh beyond the neck that is straight shaft, from its lower end
  double rim_band = 0.15;     // the socket's surface is at most this far off its sphere within the rim, radii
  double first_meridian = 0.0;   // offset of the meridians on which the rim is sought, in their spacing
  double plane_tolerance = 1.0;  // factor on the tolerance of the rim's plane, see measure_acetabulum()
};

/// What is measured of a ball.
struct FemurMeasures {
  SphereFit head;                           // the sphere that fits the head
  Vec3 neck_axis = Vec3::Zero();            // from the centre of the head, in the frame of the mesh
  double neck_radius = 0.0;                 // mm, mean distance of the neck's section from the neck axis
  double head_neck_offset = 0.0;            // mm, radius of the head minus that of the neck
  std::array<double, kClockHours> alpha{};  // at 12, 1, ... 11 o'clock about the neck axis; NaN where the
                                            // surface does not leave the head
  double alpha_at_1_30 = 0.0;               // alpha at 1:30, where most cams are
  double alpha_notzli = 0.0;  // in one plane, after Notzli 2002; NaN if the contour does not leave the head
  std::optional<double> neck_shaft_angle;  // as HipParameters::neck_shaft_angle; none without straight shaft
  std::optional<double> femoral_torsion;   // as HipParameters::femoral_torsion; none without straight shaft
};

/// Measures a ball in the joint frame (anatomy.hpp). With the default choices:
/// * The neck axis goes through the middle of the curve where the surface is 1.35 head radii from the centre.
/// * The shaft axis is perpendicular, by least squares, to the normals of the shaft's lower end. A
///   whole femur widens towards the knee, so only its first six head radii from the centre count.
/// * alpha is defined in hip_surface.hpp; it is the median within 18 minutes of a position. A bump counts as
///   head if more than 20 degrees of head lie between it and the neck.
/// * alpha_notzli is the angle of Notzli et al. 2002 (10.1302/0301-620X.84B4.12014). It is measured in the
///   plane of the neck axis and the anterior direction, from the circle that fits the head's contour there.
/// * Torsion is measured from the transverse axis of the joint frame, which need not be that of the knee.
/// Throws std::invalid_argument, one line, if the mesh has no head or no neck, or ends at the neck.
FemurMeasures measure_femur(const TriangleMesh& ball, Side side, const MeasureChoices& choices = {});

/// Unit vector from the centre of the head, the origin, through the middle of a section of the neck. The
/// section must not be empty.
Vec3 neck_axis(const std::vector<Segment>& section);

/// What is measured of a socket.
struct AcetabulumMeasures {
  SphereFit socket;             // the sphere that fits its inside
  Vec3 opening = Vec3::Zero();  // unit vector along the axis, out of the socket
  double inclination = 0.0;     // this and the next two: degrees, as in HipParameters
  double version = 0.0;
  double half_opening = 0.0;
  std::optional<double> lateral_centre_edge;  // none if the rim does not cross the coronal plane
  double coverage = 0.0;     // share of all directions from the socket's centre that are within the rim
  double at_mesh_end = 0.0;  // share of the rim's points at a boundary edge of the mesh
};

/// Measures a socket in the joint frame. The sphere is fitted to the faces round the head that look to its
/// centre, whatever else the mesh holds. The rim is where the surface first leaves the sphere, or ends, along
/// 180 meridians from the middle of the socket; dents of up to 3 degrees are bridged. This gives the same rim
/// on a cut socket and on a whole pelvis. The plane of the rim is the one with most of the rim's points
/// within 0.1 mm; this tolerance is doubled until it holds a third of them. A raised or lowered part of the
/// rim thus does not tilt the plane. Throws std::invalid_argument, one line, if there is no socket or no rim.
AcetabulumMeasures measure_acetabulum(const TriangleMesh& socket, const SphereFit& head, Side side,
                                      const MeasureChoices& choices = {});

}  // namespace impinge
