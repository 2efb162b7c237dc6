// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh and a pose as FCL keeps them.
#pragma once

#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>

#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// Fills a tree of bounding volumes: fcl::OBB to find a contact, fcl::OBBRSS to measure distances too.
template <class Volume>
void fill_fcl_model(fcl::BVHModel<Volume>& model, const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) triangles.emplace_back(face[0], face[1], face[2]);
  model.beginModel(static_cast<int>(mesh.faces.size()), static_cast<int>(mesh.vertices.size()));
  model.addSubModel(mesh.vertices, triangles);
  model.endModel();
}

// From the ball's frame to the socket's.
inline fcl::Transform3<double> fcl_transform(const Pose& pose) {
  fcl::Transform3<double> placed = fcl::Transform3<double>::Identity();
  placed.linear() = pose.rotation;
  placed.translation() = pose.translation;
  return placed;
}

}  // namespace impinge::lab
