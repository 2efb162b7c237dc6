// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes turned about the centre, and moved.
#pragma once

#include <utility>

#include <Eigen/Geometry>

#include "mesh/triangle_mesh.hpp"

namespace impinge::test {

inline TriangleMesh turned(TriangleMesh mesh, const Eigen::Matrix3d& rotation) {
  for (Vec3& v : mesh.vertices) v = rotation * v;
  return mesh;
}
inline TriangleMesh turned(TriangleMesh mesh, double angle, const Vec3& axis) {
  return turned(std::move(mesh), Eigen::AngleAxisd(angle, axis).toRotationMatrix());
}

inline TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& v : mesh.vertices) v += by;
  return mesh;
}

// Off every axis and grid line.
inline TriangleMesh askew(TriangleMesh mesh) {
  return turned(std::move(mesh), 0.7, Vec3(1, 2, 3).normalized());
}

}  // namespace impinge::test
