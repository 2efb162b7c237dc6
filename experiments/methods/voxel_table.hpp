// SPDX-License-Identifier: GPL-3.0-or-later
// The voxels of a surface and their numbers, as Hu et al. (2001) keep them (thesis, Eq. 1-4): a byte for
// every voxel of the box about the object, 1 where the object is.
//
// Voxel (x, y, z), integers, is the cube [x h, (x + 1) h) x ... in the frame of the mesh, h its side in mm.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

using Voxel = std::array<long, 3>;  // numbers along x, y and z

// The box of voxels about an object A.
struct VoxelBox {
  double size = 1.0;  // h, mm
  Voxel min{};        // Min_A
  Voxel extent{};     // Dim_A, largest minus smallest: Dim_A + 1 voxels along each axis

  std::size_t count() const;                // voxels of the box
  bool contains(const Voxel& voxel) const;  // Is the voxel in the box?
  // Number of a voxel that is in the box (Eq. 1).
  std::size_t id(const Voxel& voxel) const;
  // The inverse of id() (Eq. 2-4).
  Voxel voxel(std::size_t id) const;
};

Voxel voxel_at(const Vec3& point, double size);   // the voxel that holds a point; size in mm
Vec3 centre_of(const Voxel& voxel, double size);  // its middle, mm

// Voxels that some face meets, each once, in the order of x, y, z: their closed cube and a triangle share a
// point (separating axes, Akenine-Moller 2001). std::invalid_argument for a size (mm) that is no positive
// length, and for one so small that a coordinate has no voxel number.
std::vector<Voxel> surface_voxels(const TriangleMesh& mesh, double size);

struct VoxelTable {
  VoxelBox box;                        // of all voxels that are occupied
  std::vector<std::uint8_t> occupied;  // by id

  // Is the voxel occupied?
  bool holds(const Voxel& voxel) const { return box.contains(voxel) && occupied[box.id(voxel)] != 0; }
};

// The table of these voxels of side `size`, mm; std::invalid_argument for no voxels, and above 2^32 bytes.
VoxelTable make_voxel_table(const std::vector<Voxel>& voxels, double size);

}  // namespace impinge::lab
