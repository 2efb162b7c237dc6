// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mesh/triangle_distance.hpp"
#include "methods/hu_voxels.hpp"

namespace impinge::lab {
namespace {

constexpr double kMostBytes = 0x1p32;
constexpr double kMostNumber = 0x1p20;  // largest number of a voxel along an axis

// Does this axis separate the triangle from a cube of half side h, given relative to the cube's middle?
bool separates(const Vec3& axis, const Triangle& t, double half) {
  const std::array<double, 3> along{axis.dot(t[0]), axis.dot(t[1]), axis.dot(t[2])};
  const double reach = half * axis.lpNorm<1>();
  return std::ranges::min(along) > reach || std::ranges::max(along) < -reach;
}

bool meets_cube(const Triangle& t, double half) {
  const std::array<Vec3, 3> edge{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  if (separates(edge[0].cross(edge[1]), t, half)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 unit = Vec3::Unit(axis);
    if (separates(unit, t, half)) return false;
    for (const Vec3& e : edge) {
      if (separates(unit.cross(e), t, half)) return false;
    }
  }
  return true;
}

void add_voxels(const Triangle& t, double size, std::vector<Voxel>& voxels) {
  const Voxel low = voxel_at(t[0].cwiseMin(t[1]).cwiseMin(t[2]), size);
  const Voxel high = voxel_at(t[0].cwiseMax(t[1]).cwiseMax(t[2]), size);
  for (long z = low[2]; z <= high[2]; ++z) {
    for (long y = low[1]; y <= high[1]; ++y) {
      for (long x = low[0]; x <= high[0]; ++x) {
        const Vec3 middle = centre_of({x, y, z}, size);
        if (meets_cube({t[0] - middle, t[1] - middle, t[2] - middle}, 0.5 * size))
          voxels.push_back({x, y, z});
      }
    }
  }
}

}  // namespace

std::size_t VoxelBox::count() const {
  std::size_t all = 1;
  for (const long e : extent) all *= static_cast<std::size_t>(e + 1);
  return all;
}

bool VoxelBox::contains(const Voxel& voxel) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (voxel[k] < min[k] || voxel[k] > min[k] + extent[k]) return false;
  }
  return true;
}

std::size_t VoxelBox::id(const Voxel& voxel) const {
  const long row = extent[0] + 1;
  return static_cast<std::size_t>(voxel[0] - min[0] + (voxel[1] - min[1]) * row +
                                  (voxel[2] - min[2]) * row * (extent[1] + 1));
}

Voxel VoxelBox::voxel(std::size_t id) const {
  const long row = extent[0] + 1;
  const long layer = row * (extent[1] + 1);
  const long number = static_cast<long>(id);
  const long z = number / layer;
  const long y = (number - z * layer) / row;
  return {number - z * layer - y * row + min[0], y + min[1], z + min[2]};
}

Voxel voxel_at(const Vec3& point, double size) {
  Voxel voxel{};
  for (std::size_t k = 0; k < 3; ++k)
    voxel[k] = static_cast<long>(std::floor(point[static_cast<int>(k)] / size));
  return voxel;
}

Vec3 centre_of(const Voxel& voxel, double size) {
  return size * Vec3(static_cast<double>(voxel[0]) + 0.5, static_cast<double>(voxel[1]) + 0.5,
                     static_cast<double>(voxel[2]) + 0.5);
}

std::vector<Voxel> surface_voxels(const TriangleMesh& mesh, double size) {
  double largest = 0.0;
  for (const Vec3& v : mesh.vertices) largest = std::max(largest, v.lpNorm<Eigen::Infinity>());
  if (!(size > 0.0 && largest / size < kMostNumber)) {
    throw std::invalid_argument("the side of a voxel is a positive length, and no millionth of the mesh");
  }
  std::vector<Voxel> voxels;
  for (const Face& f : mesh.faces)
    add_voxels({corner(mesh, f, 0), corner(mesh, f, 1), corner(mesh, f, 2)}, size, voxels);
  std::ranges::sort(voxels);
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  return voxels;
}

VoxelTable make_voxel_table(const std::vector<Voxel>& voxels, double size) {
  if (voxels.empty()) throw std::invalid_argument("a table of voxels needs one voxel or more");
  VoxelTable table;
  table.box.size = size;
  double bytes = 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto along = [k](const Voxel& v) { return v[k]; };
    table.box.min[k] = along(std::ranges::min(voxels, {}, along));
    table.box.extent[k] = along(std::ranges::max(voxels, {}, along)) - table.box.min[k];
    bytes *= static_cast<double>(table.box.extent[k] + 1);
  }
  if (bytes > kMostBytes) throw std::invalid_argument("a table of voxels above 4 GiB: take larger voxels");
  table.occupied.assign(table.box.count(), 0);
  for (const Voxel& v : voxels) table.occupied[table.box.id(v)] = 1;
  return table;
}

}  // namespace impinge::lab
