// SPDX-License-Identifier: GPL-3.0-or-later
#include "imaging/ct_scan.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "imaging/scan_lines.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge {
namespace {

constexpr double kMostVoxels = 0x1p28;
constexpr double kTouch = 1e-9;  // mm: a line that touches an edge enters and leaves there, in any order

VoxelImage empty_image(const TriangleMesh& body, const ScanGrid& grid) {
  if (!(grid.pixel > 0.0 && grid.slice > 0.0 && grid.margin >= 0.0) || body.vertices.empty()) {
    throw std::invalid_argument("a scan needs a body, and pixels and slices of a positive size");
  }
  Vec3 low = body.vertices.front();
  Vec3 high = low;
  for (const Vec3& v : body.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  VoxelImage image;
  image.spacing = Vec3(grid.pixel, grid.pixel, grid.slice);
  double voxels = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = std::ceil((high[axis] - low[axis] + 2.0 * grid.margin) / image.spacing[axis]) + 2.0;
    voxels *= steps;
    if (!(voxels <= kMostVoxels)) throw std::invalid_argument("a scan of too many voxels: take larger ones");
    image.count[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(steps);
    image.origin[axis] = 0.5 * (low[axis] + high[axis] - (steps - 1.0) * image.spacing[axis]);
  }
  image.values.assign(image.size(), 0.0F);
  return image;
}

// Adds the part of the line from x0 to x1 to the row of voxels it runs through.
void fill(const VoxelImage& image, std::pair<double, double> part, float weight, float* row) {
  const double scale = 1.0 / image.spacing.x();
  const double from = (part.first - image.origin.x()) * scale + 0.5;  // in voxels
  const double to = (part.second - image.origin.x()) * scale + 0.5;
  for (auto i = static_cast<std::size_t>(from); static_cast<double>(i) < to; ++i) {
    const double low = std::max(from, static_cast<double>(i));
    const double high = std::min(to, static_cast<double>(i) + 1.0);
    row[i] += weight * static_cast<float>(high - low);
  }
}

}  // namespace

VoxelImage bone_shares(const TriangleMesh& body, const ScanGrid& grid) {
  VoxelImage image = empty_image(body, grid);
  const ScanLines lines = lines_of(image);
  std::vector<std::vector<LineCrossing>> crossings = cross_all(lines, body);
  const float weight = 1.0F / static_cast<float>(lines.per_voxel[0] * lines.per_voxel[1]);
  for (std::size_t line = 0; line < crossings.size(); ++line) {
    std::vector<LineCrossing>& along = crossings[line];
    std::ranges::sort(along, {}, [](const LineCrossing& c) { return c.x; });
    const std::size_t j = line % lines.count[0] / lines.per_voxel[0];
    const std::size_t k = line / lines.count[0] / lines.per_voxel[1];
    float* row = image.values.data() + image.index(0, j, k);
    int depth = 0;
    bool closed = true;
    for (std::size_t c = 0; c < along.size(); ++c) {
      depth += along[c].step;
      if (c + 1 == along.size()) continue;
      const double length = along[c + 1].x - along[c].x;
      if (depth > 0) fill(image, {along[c].x, along[c + 1].x}, weight, row);
      closed = closed && (depth >= 0 || length < kTouch);
    }
    if (depth != 0 || !closed) {
      throw std::invalid_argument("a body to be scanned is closed and has outward normals: fill or turn it");
    }
  }
  return image;
}

VoxelImage hounsfield(const VoxelImage& shares, const ScanLevels& levels) {
  VoxelImage image = shares;
  std::mt19937_64 random(levels.seed);
  for (float& value : image.values) {
    // Box and Muller (1958): the same numbers with every standard library.
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(random)));
    const double normal = radius * std::cos(2.0 * kPi * uniform(random));
    value = static_cast<float>(levels.tissue + static_cast<double>(value) * (levels.bone - levels.tissue) +
                               levels.noise * normal);
  }
  return image;
}

}  // namespace impinge
