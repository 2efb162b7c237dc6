// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Glossary: frames, units and words of the library, one meaning each. All frames are right-handed.
///
///   input frame    coordinates as they stand in the user's mesh files, millimetres
///   centre frame   input frame moved so that the centre of rotation is the origin,
///                  x_centre = x_input - centre, subtracted in double; tables and scans work in it
///   socket frame   centre frame of the socket, which stays at rest
///   ball frame     centre frame of the ball, which a pose moves: x_socket = R x_ball + t
///   joint frame    anatomical axes of the patient about the centre: x to the patient's right, y anterior,
///                  z superior (RAS). An axis code such as LPS says how the input frame maps to it.
///
///   direction      unit vector u from the centre
///   angles         phi in [0, pi] from +z, theta in [0, 2 pi) from +x towards +y (thesis Eq. 5-6), radians
///   radius         r(u), distance from the centre to the surface along u, millimetres
///   gap            g(u) = S(u) - B(u), socket radius minus ball radius, millimetres; negative is penetration
///
///   surface        ball or socket; the other one is what its vertices are looked up in (gap/surface.hpp)
///   layer          the one of several crossings of a ray that counts: the nearest or the farthest
///   rim            where a surface ends or jumps
///   scheme         which directions are sampled, and how one is looked up (sphere/scheme.hpp)
///   entry          one sampled direction with its number; a table has all entries of one surface
///   cell           the patch between entries; a stencil names the cell and the taps that a look-up reads
///   there precision      spacing of the entries at the equator, degrees covering       radius rho: the
///   largest angle from any direction to its nearest entry incidence      angle psi between a direction and
///   the normal of the face that it hits pose           where the ball stands in the socket; a motion is a
///   path of poses, its limit the angle at which
///                  it stops
///   scan           the gaps of all vertices of one surface in one pose
///   impinged       of a vertex: its gap is 0 or less; of a pose: the surfaces touch
///   error, bound   measured; proven
///   oracle         brute force or exact arithmetic, which the tests and the laboratory compare with
///
/// Lengths are from 2^-100 to 2^100 mm (mesh/lengths.hpp); inside that range none is compared with a fixed
/// number, so that other units change nothing but the units.
///
/// Angles are degrees where a person reads or types them, and in names that end in _deg; radians elsewhere.
#pragma once
