// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Joints whose limits and gaps have a closed form, and what the library measures on meshes of them: a test
/// of everything from a mesh to a bracket.
///
/// A mesh differs from its smooth surface by a sagitta. Rims and necks therefore have many sides, the bump
/// has rings of vertices next to the level that touches, and the spheres have ever closer rings about the
/// place of contact. The limits of the meshes must be within kPhantomLimitError of the closed forms, a target
/// that is not proven. Gaps have a proven bound: the sagittas of both meshes and, by table, the table's
/// bound.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/ball_socket_pair.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// At which t is the angle between s and a, turned by t about w, equal to D? By the spherical law of cosines
///   (a.w)(s.w) + [a.s - (a.w)(s.w)] cos t + (w x a).s sin t = cos D.
struct AngleQuestion {
  Vec3 turning;         // a, unit vector
  Vec3 fixed;           // s, unit vector
  Vec3 axis;            // w, unit vector
  double cosine = 0.0;  // of D
};
std::optional<double> first_turn_to(const AngleQuestion& question);  // least t > 0, radians; or none

/// One row of the table of validation; lengths in mm, angles in degrees.
struct PhantomRow {
  std::string phantom;       // which joint
  std::string quantity;      // limit or gap, and about which axis
  double closed_form = 0.0;  // from the equations of the functions below
  double measured = 0.0;     // the library's answer for the meshes
  double error = 0.0;        // of the measured value
  /// Largest allowed error: of a limit a chosen target, of a gap a proven bound.
  double allowed = 0.0;
  bool proven = false;  // is `allowed` a proven bound?
};

/// How fine the meshes are.
struct PhantomSizes {
  std::size_t sides = 360;     // of rims, necks and rings
  std::size_t faces = 4000;    // of each sphere whose gaps are measured
  double precision_deg = 1.0;  // of the tables of those gaps, RSID
};
inline constexpr double kPhantomLimitError = 0.01;  // degrees

/// Limits by limits/turn_limit.hpp, about several axes each; the allowed error is kPhantomLimitError,
/// whatever the sizes. Each limit is an AngleQuestion:
///   cone neck      a cone of half angle k about a, apex in the centre, against the rim of a cup that opens
///                  by o about s (180 degrees less its half opening): D = o - k
///   cylinder neck  of radius c about a, against a rim of radius R: D = o - asin(c / R)
///   cam bump       B(u) = R + h cos^2(pi/2 v / W), v the angle from its top a, against a cup of radius S and
///                  half opening H about -s: it reaches S up to v = (2 W / pi) acos(root((S - R) / h)), and
///                  the rim where angle(a, -s) = H + v
///   spheres        the ball's of radius B about a point b that turns, the socket's of radius S about e;
///                  they touch where |b(t) - e| = S - B: cos D = (|b|^2 + |e|^2 - (S - B)^2) / (2 |b| |e|)
std::vector<PhantomRow> phantom_limits(const PhantomSizes& sizes = {});

/// Eccentric spheres: the smallest gap of a vertex by exact faces, and gaps by table at every vertex. The gap
/// along u is S(u) - B(u) with r(u) = p.u + root(R^2 - |p|^2 + (p.u)^2) for a sphere about p; if e = 0 its
/// minimum is S - B - |b|.
std::vector<PhantomRow> phantom_gaps(const PhantomSizes& sizes = {});

// A replaced hip: a head of 32 mm on a stem, in a cup.

/// The joint frame of a right hip, mm, with the centre of the head as origin. The stem has the head, a neck
/// of 12 mm at 45 degrees to the shaft with 10 degrees of anteversion, and a shaft that narrows to its end
/// 180 mm below. The cup is a shell round a hemisphere 0.1 mm beyond the head, open at 45 degrees of
/// inclination and 20 of anteversion. Each is closed, with outward normals, and has about half of the faces.
/// So small a clearance needs 10,000 faces or more.
BallSocketPair make_implant(std::size_t faces);

// Bodies of revolution for the phantoms: rings of vertices about an axis.

/// A ring of vertices: `radius` mm from the origin, `polar` radians from the axis. At 0 and pi it is a pole.
struct LatheRing {
  double polar = 0.0;   // radians
  double radius = 0.0;  // mm
};

/// Rings from one pole, about a unit axis through `centre`, `sides` vertices each; closed if the last is a
/// pole.
struct Revolution {
  std::vector<LatheRing> rings;  // in order from the first pole
  Vec3 axis = Vec3::UnitZ();     // unit vector, towards the first pole
  Vec3 centre = Vec3::Zero();    // mm
  std::size_t sides = 360;       // vertices of a ring
};
TriangleMesh revolve(const Revolution& body);  // its mesh, normals outward

/// Rings of a sphere of `radius` mm from the axis to `to` radians, `step` radians apart.
std::vector<LatheRing> sphere_rings(double radius, double to, double step);

/// Rings of a whole sphere of `radius` mm about the axis, closer together towards it: each is 1.15 times as
/// far from the axis as the one before.
std::vector<LatheRing> focused_rings(double radius);

}  // namespace impinge
