// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices in the form that a kernel reads: coordinate by coordinate, in float or double.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "gap/surface.hpp"

namespace impinge {

/// Vertices in mm, in the frame of their mesh; the three lists have one size.
template <class Real>
struct PackedVertices {
  std::vector<Real> x;  // of each vertex
  std::vector<Real> y;
  std::vector<Real> z;

  std::size_t size() const { return x.size(); }  // number of vertices
};

/// Packs vertices; each coordinate is rounded once.
template <class Real>
PackedVertices<Real> packed_vertices(std::span<const Vec3> vertices) {
  PackedVertices<Real> lanes;
  for (auto* axis : {&lanes.x, &lanes.y, &lanes.z}) axis->reserve(vertices.size());
  for (const Vec3& v : vertices) {
    lanes.x.push_back(static_cast<Real>(v.x()));
    lanes.y.push_back(static_cast<Real>(v.y()));
    lanes.z.push_back(static_cast<Real>(v.z()));
  }
  return lanes;
}

/// x = rotation v + translation takes the vertices of a scan to the frame of the table, mm.
template <class Real>
struct PackedTransform {
  std::array<std::array<Real, 3>, 3> rotation{};  // rows
  std::array<Real, 3> translation{};              // mm
};

/// The transform of a scan in a pose, worked out in double and rounded once.
template <class Real>
PackedTransform<Real> packed_transform(const Pose& pose, Surface scanned) {
  Eigen::Matrix3d rotation = pose.rotation;
  Vec3 translation = pose.translation;
  if (scanned == Surface::socket) {
    translation = to_ball(pose, Vec3::Zero());
    rotation.transposeInPlace();
  }
  PackedTransform<Real> lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < 3; ++k)
      lanes.rotation[i][k] = static_cast<Real>(rotation(row, static_cast<Eigen::Index>(k)));
    lanes.translation[i] = static_cast<Real>(translation[row]);
  }
  return lanes;
}

}  // namespace impinge
