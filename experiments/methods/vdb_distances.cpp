// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/vdb_distances.hpp"

#include <numbers>
#include <stdexcept>
#include <vector>

#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/MeshToVolume.h>

#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

using Grid = openvdb::FloatGrid;
using Sampler = openvdb::tools::GridSampler<Grid::ConstAccessor, openvdb::tools::BoxSampler>;

Grid::Ptr distances_near(const TriangleMesh& mesh, const VdbShape& shape) {
  if (!(shape.voxel_mm > 0.0 && shape.reach_mm > 0.0))
    throw std::invalid_argument("voxels and reach of an OpenVDB grid must be above 0 mm");
  openvdb::initialize();
  std::vector<openvdb::Vec3s> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) points.emplace_back(openvdb::Vec3d(v.x(), v.y(), v.z()));
  std::vector<openvdb::Vec3I> triangles;
  triangles.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) triangles.emplace_back(face[0], face[1], face[2]);
  const auto transform = openvdb::math::Transform::createLinearTransform(shape.voxel_mm);
  const double band_voxels = shape.reach_mm / shape.voxel_mm + std::numbers::sqrt3;
  return openvdb::tools::meshToUnsignedDistanceField<Grid>(*transform, points, triangles, {},
                                                           static_cast<float>(band_voxels));
}

class VdbDistances final : public RadiusMethod {
 public:
  VdbDistances(const TriangleMesh& mesh, const VdbShape& shape)
      : reach_(shape.reach_mm), grid_(distances_near(mesh, shape)), nodes_(grid_->getConstAccessor()) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    const Sampler sampler(nodes_, grid_->transform());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& x = points[i];
      const double distance = sampler.wsSample(openvdb::Vec3d(x.x(), x.y(), x.z()));
      out[i] = distance <= reach_ ? distance : kNoSurface;
    }
  }
  double bytes() const override { return static_cast<double>(grid_->memUsage()); }

 private:
  double reach_;
  Grid::ConstPtr grid_;
  Grid::ConstAccessor nodes_;
};

}  // namespace

std::unique_ptr<RadiusMethod> make_vdb_distances(const TriangleMesh& mesh, const VdbShape& shape) {
  return std::make_unique<VdbDistances>(mesh, shape);
}

double vdb_distance_bound(const VdbShape& shape) { return 0.5 * std::numbers::sqrt3 * shape.voxel_mm; }

}  // namespace impinge::lab
