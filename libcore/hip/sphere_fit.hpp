// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The centre of rotation as the centre of a sphere fitted to the ball.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

struct SphereFit {
  Vec3 centre = Vec3::Zero();  // mm, frame of the points
  double radius = 0.0;         // mm
  double rms = 0.0;            // root mean square of |x - centre| - radius over the points used, weighted; mm
  std::size_t points = 0;      // points used
  double trim = 0.0;           // residuals above this were left out by fit_ball(), mm
};

/// Geometric least squares (Eberly 1999, "Least squares fitting of data", as in Section 3.4): the centre and
/// radius that minimise sum w_i (|x_i - c| - r)^2, by Gauss-Newton from the algebraic fit. `weight` is empty
/// (all 1) or has one weight for each point, none negative. Throws std::invalid_argument for fewer than four
/// points, points in a plane, or points for which the iteration does not converge.
SphereFit fit_sphere(std::span<const Vec3> points, std::span<const double> weight = {});

/// Options of fit_ball(); lengths as shares of the sphere's radius.
struct BallFitOptions {
  double start_tolerance = 0.05;  // points this close to a trial sphere vote for it
  double trim = 0.06;             // residuals above this are left out: 1.5 mm on a head of 25 mm
  double scales = 2.5;            // residuals above this many standard deviations are left out, too
  int trials = 1500;              // trial spheres
  unsigned seed = 1;              // seed of the random choice of trial spheres
};

/// Fits a sphere to a ball whose mesh may hold more than the ball, such as a whole femur; also to a socket of
/// one wall, with its rim and fossa. The thesis cut the region by hand (Figure 38); here
///   1. trial spheres go through four vertices, or through two with their normals. The winner is the sphere
///      that has the largest share of its own area covered by vertices that lie on it with a normal along the
///      radius; so a large sphere that only a few bumps touch does not win;
///   2. fit_sphere() with vertex areas as weights is repeated over the outward vertices whose residual is
///      below `trim` and below `scales` standard deviations (1.4826 times the median residual, which the neck
///      hardly changes), until these vertices stay the same.
/// Deterministic. Throws std::invalid_argument as fit_sphere() does.
SphereFit fit_ball(const TriangleMesh& mesh, const BallFitOptions& options = {});

/// Fits a sphere to a socket in the frame of `head`: fit_ball() of the faces that are 0.8 to 1.5 radii of the
/// head from its centre and look to it. The outer side of a wall and the rest of a pelvis are thus left out.
/// If most of those that are nearest along their rays look away, the socket is taken as inside out.
/// Throws std::invalid_argument as fit_sphere() does, if no such face is found, or if the centres are more
/// than the head's radius apart, as with a glenoid, which is too flat.
SphereFit fit_socket(const TriangleMesh& socket, const SphereFit& head, const BallFitOptions& options = {});

/// The deviation map of Figures 38 and 39: distance of each vertex from the sphere, mm, positive outside.
std::vector<double> sphere_deviations(const TriangleMesh& mesh, const SphereFit& fit);

/// Which vertices fit_ball() used: the spherical region.
std::vector<bool> spherical_region(const TriangleMesh& mesh, const SphereFit& fit);

}  // namespace impinge
