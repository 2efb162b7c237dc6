// SPDX-License-Identifier: GPL-3.0-or-later
// The poses over which detection is timed, and the check that must pass first.
#pragma once

#include <string>
#include <vector>

#include "methods/benchmark_scene.hpp"
#include "methods/method.hpp"

namespace impinge::lab {

// A pose with its name in the results.
struct NamedPose {
  std::string name;  // clear, near or touching, and the rotation
  Pose pose;         // of the ball in the socket
};

// Six poses: the ball as given and turned by 10 degrees about an axis across the socket's, each
//   clear     with both centres together,
//   near      moved along the socket's axis, in steps of 0.05 mm, until the smallest gap is at most 0.5 mm,
//   touching  moved on until the smallest gap is at most -0.5 mm.
// Gaps are by RSID tables at 1 degree. Meshes in their centre frames, mm. Throws std::runtime_error if 20 mm
// do not bring the surfaces together.
std::vector<NamedPose> pose_set(const BallSocketPair& pair);

// Unit vector from the centre towards the middle of the socket, by area.
Vec3 socket_axis(const TriangleMesh& socket);

// Throws std::runtime_error with method and pose if the two methods differ in a pose.
void require_agreement(const TouchCase& method, const TouchCase& oracle, const std::vector<NamedPose>& poses);

// The number of poses that touch. This is the timed work: one answer per pose.
int count_touching(const TouchCase& method, const std::vector<NamedPose>& poses);

// The smallest distance between ball and socket in a pose, from pairs of triangles: the reference for methods
// that answer for a whole pose.

// Euclidean, mm, up to rounding; 0 if the surfaces meet, which is decided exactly. Skips triangles of the
// ball that cannot be nearer than the nearest vertex.
double surface_distance(const BenchmarkScene& scene);

}  // namespace impinge::lab
