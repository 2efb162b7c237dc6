// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The measures of a hip by name, each with how far it can be trusted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hip/anatomy.hpp"
#include "hip/cup_angles.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// One measure; it has no value if it is refused. Published values: hip/published_measures.hpp.
struct Measure {
  std::string name;                   // such as femoral_torsion
  std::optional<double> value;        // in `unit`
  std::optional<double> uncertainty;  // see measure_hip()
  std::string unit;                   // mm, deg or 1
  std::string state;                  // "measured", "measured to the end of the mesh", or "refused: " and why
};

/// The measures of two meshes in the joint frame, in this order: head_radius, head_neck_offset,
/// neck_shaft_angle, femoral_torsion, alpha_at_12, alpha_at_1, alpha_at_1_30, alpha_at_2 ... alpha_at_11
/// (o'clock about the neck), alpha_notzli, socket_radius, inclination, version, half_opening,
/// lateral_centre_edge and coverage (hip/hip_measures.hpp).
///
/// Each is measured again with each of the MeasureChoices varied to either side; the uncertainty is the
/// largest change. The end of the head is varied by twice the rms distance of the head from its sphere, since
/// a head that is not round has no sharper end. A measure is refused if it changes by more than 10 degrees,
/// 2 mm or 0.1 (coverage), or is not found with one of the choices. If more than a tenth of the rim is a
/// boundary of the mesh, the measures that depend on the rim say so in their state: a socket cut within its
/// rim looks like one that ends there. The uncertainty leaves out what the meshes do not show, such as how
/// the pelvis lay.
std::vector<Measure> measure_hip(const BallSocketPair& joint, Side side);
/// The six measures of the socket alone, given the sphere of the head.
std::vector<Measure> measure_socket(const TriangleMesh& socket, const SphereFit& head, Side side);
/// The sphere that fits the ball, or a sphere about the origin if none fits.
SphereFit head_or_centre(const TriangleMesh& ball);

/// The angles of a socket whose rim can be trusted.
struct TrustedOpening {
  CupAngles angles;
  std::string state;  // "measured", or "measured to the end of the mesh"
};
/// The angles of the opening. Throws std::runtime_error, one line, where measure_hip() refuses inclination or
/// version, with its words.
TrustedOpening trusted_opening(const BallSocketPair& joint, Side side);

}  // namespace impinge
