// SPDX-License-Identifier: GPL-3.0-or-later
// The planes m . p = 1 of faces for a kernel, and a test whether they answer without their edges.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A face has a plane only if 1 / cos psi, psi the angle between ray and normal, is nowhere above this.
inline constexpr double kSteepest = 4.0;
std::vector<Vec3> seen_planes(const TriangleMesh& mesh);  // centre frame: m of each face, 1 / mm, or zero

/// A mesh with its planes.
struct SeenMesh {
  const TriangleMesh& mesh;         // centre frame
  const std::vector<Vec3>& planes;  // of each face, as seen_planes() has them
};

/// +1 if no corner of these faces lies beyond the plane of one of them, -1 if none lies within one, up to
/// 2^-26 of its distance. std::nullopt if both happen, if a plane is zero, or if |m| times the distance of a
/// corner of another face is above kSteepest.
std::optional<int> bend_of(const SeenMesh& seen, std::span<const std::uint32_t> faces);

}  // namespace impinge
