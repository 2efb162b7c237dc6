// SPDX-License-Identifier: GPL-3.0-or-later
// @can     gaps
// @links   gap gap_queries peer::openvdb
//
// Method vdb_grid: distances from the surface on the voxels near it, by OpenVDB, which keeps no others;
// interpolated trilinearly. Distances have no sign, and bytes are those of the grid.
//
// Bound: that of distance_grid.hpp, sqrt(3)/2 of a voxel.
// Reach: stored distances end at the width w of the band. Those of the eight nodes of a cell differ by at
// most its diagonal, so that an answer below w less the diagonal has read no node beyond the band.

#include <numbers>
#include <stdexcept>

#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/MeshToVolume.h>

#include "methods/gaps.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

using Grid = openvdb::FloatGrid;
using Sampler = openvdb::tools::GridSampler<Grid::ConstAccessor, openvdb::tools::BoxSampler>;

constexpr double kReach = 5.0;  // mm: vertices in the joint space and a little beyond

Grid::Ptr distances_near(const TriangleMesh& mesh, double voxel_mm) {
  if (!(voxel_mm > 0.0)) throw std::invalid_argument("the voxels of an OpenVDB grid must be above 0 mm");
  openvdb::initialize();
  std::vector<openvdb::Vec3s> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) points.emplace_back(openvdb::Vec3d(v.x(), v.y(), v.z()));
  std::vector<openvdb::Vec3I> triangles;
  triangles.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) triangles.emplace_back(face[0], face[1], face[2]);
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel_mm);
  const double band_voxels = kReach / voxel_mm + std::numbers::sqrt3;
  return openvdb::tools::meshToUnsignedDistanceField<Grid>(*transform, points, triangles, {},
                                                           static_cast<float>(band_voxels));
}

// NaN where the answer is above the reach.
PointQuery make_distances(const TriangleMesh& mesh, double voxel_mm) {
  const Grid::ConstPtr grid = distances_near(mesh, voxel_mm);
  return {[grid, nodes = grid->getConstAccessor()](std::span<const Vec3> points, std::span<double> out) {
            const Sampler sampler(nodes, grid->transform());
            for (std::size_t i = 0; i < points.size(); ++i) {
              const Vec3& x = points[i];
              const double distance = sampler.wsSample(openvdb::Vec3d(x.x(), x.y(), x.z()));
              out[i] = distance <= kReach ? distance : kNoSurface;
            }
          },
          static_cast<double>(grid->memUsage())};
}

}  // namespace

Method vdb_method() {
  Method method;
  method.lacks = "distances above 5 mm, beyond the voxels that are kept";
  method.gaps = [](const AskedSurface& surface, const GapSizes& sizes) {
    std::vector<GapCase> cases;
    for (const double voxel : sizes.voxels_mm) {
      cases.push_back(point_gaps(
          surface, library_case("vdb_grid", "OpenVDB voxels", Measure::euclidean,
                                [&mesh = surface.mesh, voxel] { return make_distances(mesh, voxel); })));
      cases.back().setting = trimmed(voxel) + "mm";
      cases.back().storage = "float";
      cases.back().few = false;
      cases.back().place = 50;
    }
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
