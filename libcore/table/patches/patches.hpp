// SPDX-License-Identifier: GPL-3.0-or-later
// The patches of the schemes of the library, and the patches of flat cells for a PlaneExactScheme.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "table/patches/angle_patches.hpp"
#include "table/patches/cube_patches.hpp"
#include "table/patches/lattice_patches.hpp"
#include "table/patches/octahedral_patches.hpp"
#include "table/patches/solid_patches.hpp"
#include "table/patches/spiral_patches.hpp"

namespace impinge {

/// Patches of the interpolation in 1 / (r depth), linear in the point of the scheme's solid; at() is a point
/// of that solid.
template <class S>
concept HasFlatPatches = requires(const S scheme, Patch patch) {
  { flat_patches_of(scheme).at(patch, 0.0, 0.0) } -> std::same_as<Vec3>;
  { flat_patches_of(scheme).motion(patch, patch.rect) } -> std::same_as<PatchMotion>;
};

/// The rectangles of a warped cube map are rectangles on the cube.
template <class Warp>
CubePatches<GnomonicCubeWarp> flat_patches_of(const CubeMap<Warp>& scheme) {
  std::vector<double> lines;
  const auto n = static_cast<double>(scheme.divisions());
  for (std::size_t k = 0; k <= scheme.divisions(); ++k)
    lines.push_back(Warp::node((2.0 * static_cast<double>(k) - n) / n));
  return CubePatches<GnomonicCubeWarp>(std::move(lines));
}

/// The triangles of an icosahedral grid are triangles on its flat faces.
template <class Warp>
IcosahedralPatches<Warp> flat_patches_of(const IcosahedralGrid<Warp>& scheme) {
  return {scheme.divisions(), true};
}

}  // namespace impinge
