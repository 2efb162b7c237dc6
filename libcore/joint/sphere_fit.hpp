// SPDX-License-Identifier: GPL-3.0-or-later
// The centre of rotation as the centre of a sphere fitted to the ball.
#pragma once

#include <cstddef>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

struct SphereFit {
  Vec3 centre = Vec3::Zero();  // mm, frame of the points
  double radius = 0.0;         // mm
  double rms = 0.0;            // root mean square of |x - centre| - radius over the points used, weighted; mm
  std::size_t points = 0;      // points used
};

// Geometric least squares (Eberly 1999, "Least squares fitting of data", as in Section 3.4): the centre and
// radius that minimise sum w_i (|x_i - c| - r)^2, by Gauss-Newton from the algebraic fit. weight is empty
// (all 1) or has one weight a point, none negative. std::invalid_argument for fewer than four points or
// points in a plane, or points that
// no sphere fits best (the iteration does not settle).
SphereFit fit_sphere(std::span<const Vec3> points, std::span<const double> weight = {});

// Options of fit_ball(); lengths as shares of the radius found.
struct BallFitOptions {
  double start_tolerance = 0.10;  // points that close to a trial sphere vote for it
  double trim = 0.06;             // residuals above this are left out of the fit: 1.5 mm on a head of 25 mm
  int trials = 400;               // trial spheres through four vertices
  unsigned seed = 1;
};

// Centre of a ball whose mesh may hold more than the ball, such as a femoral head with its neck: the sphere
// that the largest area lies on, refined by fit_sphere() with vertex areas as weights over the vertices
// within `trim` until these stay the same. The thesis chose the region by hand (Figure 38). Deterministic.
SphereFit fit_ball(const TriangleMesh& mesh, const BallFitOptions& options = {});

}  // namespace impinge
