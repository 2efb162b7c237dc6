// SPDX-License-Identifier: GPL-3.0-or-later
// Method hu_voxels: the impingement detection of Hu et al. (2001), which Kubiak-Langer et al. (2007) used for
// their ranges of motion, as the thesis describes it (Section 2.4, Eq. 1-4). A table marks the socket's
// voxels, with a byte for each of the n^3 voxels of its box. The middle of each voxel of the ball is moved
// and looked up; a mark there is a collided point. The method gives no distance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// The voxels of a surface and their numbers as in Hu et al. (2001) (thesis, Eq. 1-4): a byte for every voxel
// of the box about the object, 1 where the object is.
//
// Voxel (x, y, z), integers, is the cube [x h, (x + 1) h) x ... in the frame of the mesh, h its side in mm.

using Voxel = std::array<long, 3>;  // numbers along x, y and z

// The box of voxels about an object A.
struct VoxelBox {
  double size = 1.0;  // h, mm
  Voxel min{};        // Min_A
  Voxel extent{};     // Dim_A, largest minus smallest: Dim_A + 1 voxels along each axis

  std::size_t count() const;                // voxels of the box
  bool contains(const Voxel& voxel) const;  // is the voxel in the box?
  // Number of a voxel that is in the box (Eq. 1).
  std::size_t id(const Voxel& voxel) const;
  // The inverse of id() (Eq. 2-4).
  Voxel voxel(std::size_t id) const;
};

Voxel voxel_at(const Vec3& point, double size);   // the voxel that holds a point; size in mm
Vec3 centre_of(const Voxel& voxel, double size);  // its middle, mm

// The voxels that some face meets, each once, in the order of x, y, z: their closed cube and a triangle share
// a point (separating axes, Akenine-Moller 2001). Throws std::invalid_argument for a size (mm) that is not
// positive, and for one so small that a coordinate has no voxel number.
std::vector<Voxel> surface_voxels(const TriangleMesh& mesh, double size);

struct VoxelTable {
  VoxelBox box;                        // of all occupied voxels
  std::vector<std::uint8_t> occupied;  // by id

  // Is the voxel occupied?
  bool holds(const Voxel& voxel) const { return box.contains(voxel) && occupied[box.id(voxel)] != 0; }
};

// The table of voxels of side `size`, mm. Throws std::invalid_argument for no voxels, and above 2^32 bytes.
VoxelTable make_voxel_table(const std::vector<Voxel>& voxels, double size);

// Largest distance of the surfaces at a hit, in sides of a voxel.
inline constexpr double kVoxelReach = 1.5 * std::numbers::sqrt3;

// Voxels are those that a face meets, since the socket of a joint is an open surface without an inside.
// Proven: at a hit the surfaces are at most 3/2 sqrt(3) h apart, h the side of a voxel. The middle of a
// ball's voxel is within sqrt(3)/2 h of the ball's surface, and a point of a marked voxel within sqrt(3) h of
// the socket's. A contact is missed if no middle falls into a marked voxel.
class HuVoxels {
 public:
  // Meshes in their centre frames, mm; `size` is the side of a voxel, mm. Throws as surface_voxels() does.
  HuVoxels(const TriangleMesh& ball, const TriangleMesh& socket, double size);

  // Looks up all voxels of the ball, as the method reports each collided point.
  bool touches(const Pose& pose) { return !collided(pose).empty(); }

  // Middles of those voxels of the ball that hit, in the socket's frame, mm.
  const std::vector<Vec3>& collided(const Pose& pose);

  const VoxelTable& table() const { return socket_; }       // of the socket
  std::size_t ball_voxels() const { return ball_.size(); }  // number of voxels that are looked up
  // Memory of the table and of the ball's voxels.
  std::size_t bytes() const { return socket_.occupied.size() + ball_.size() * sizeof(Vec3); }

 private:
  std::vector<Vec3> ball_;  // middles of voxels, ball frame
  VoxelTable socket_;
  std::vector<Vec3> collided_;
};

}  // namespace impinge::lab
