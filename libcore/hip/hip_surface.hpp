// SPDX-License-Identifier: GPL-3.0-or-later
// The smooth surfaces behind the meshes of a generated hip, as distances from the centre of the head. They
// describe a right hip in the joint frame; a left hip is its mirror image (hip.hpp).
#pragma once

#include "hip/clock.hpp"
#include "hip/hip_parameters.hpp"

namespace impinge {

/// What follows from the parameters.
struct HipSurface {
  HipParameters parameters;      // as given
  Vec3 neck;                     // direction of the neck axis, from the centre of the head to the shaft
  ClockFace neck_clock;          // dial about the neck axis
  Vec3 opening;                  // axis of the socket, out of its opening
  ClockFace rim_clock;           // dial about the axis of the socket
  double head_radius = 0.0;      // of the sphere that fits the head best
  double neck_radius = 0.0;      // mm, head radius minus head_neck_offset
  double socket_radius = 0.0;    // mm, head radius plus joint space
  Vec3 socket_centre;            // relative to that of the head
  double bend_radius = 0.0;      // radius of the arc in which the neck axis turns to the shaft, mm
  double conchoid_origin = 0.0;  // distance of the conchoid's origin from the centre, along the neck axis, mm
  double lateral_clock = 0.0;    // where the rim crosses the coronal plane laterally, hours
  double lateral_raise = 0.0;    // by which the rim is raised there, radians
};

/// The surfaces. Throws std::invalid_argument, one line, for parameters that make none (hip_checks.hpp).
HipSurface hip_surface(const HipParameters& parameters);

/// Unit vector at `polar` radians from an axis (the neck, or the pole of the socket) at `hours` of its clock.
Vec3 clock_direction(const Vec3& axis, const ClockFace& clock, double polar, double hours);

/// Distance from the centre to the head with its cam along a direction, mm.
double head_radius(const HipSurface& hip, const Vec3& direction);
/// Distance from the centre to head and neck along a direction, mm: the ball up to where the neck bends.
double head_neck_radius(const HipSurface& hip, const Vec3& direction);

/// head_neck_radius() without a cam, at `polar` radians from the neck axis, mm.
double plain_head_neck_radius(const HipSurface& hip, double polar);

/// Distance from the centre to where the neck begins to bend, along its axis, mm.
double neck_end(const HipSurface& hip);

/// Distance from the centre of the head to the socket along a direction, mm, within its rim or beyond.
double socket_radius(const HipSurface& hip, const Vec3& direction);

/// Distance from the centre of the socket to its surface along a direction from there, mm.
double inner_radius(const HipSurface& hip, const Vec3& from_socket_centre);

/// Angle of the rim from the pole of the socket, seen from the centre of the socket, radians.
double rim_polar(const HipSurface& hip, double hours);

inline constexpr double kAlphaShare = 0.02;  // see alpha_angle_deg(); about half a millimetre on a head
/// Alpha angle at a clock position about the neck: the largest angle from the neck axis, in degrees, at which
/// the surface is farther from the centre than the head by more than kAlphaShare of its radius. Noetzli 2002
/// takes the point where the surface leaves the circle; on a mesh this needs a tolerance.
double alpha_angle_deg(const HipSurface& hip, double hours);

}  // namespace impinge
