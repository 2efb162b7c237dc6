// SPDX-License-Identifier: GPL-3.0-or-later
#include "imaging/ct_scan.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "sphere/uniform_directions.hpp"

namespace impinge {
namespace {

constexpr double kMostVoxels = 0x1p28;
constexpr double kTouch = 1e-9;  // mm: a line that touches an edge enters and leaves there, in any order

constexpr double kLineSpacing = 0.25;  // mm, at most

// Lines along x through the voxels, on a regular grid in y and z that is finer than the voxels.
struct ScanLines {
  std::array<std::size_t, 2> per_voxel{};  // lines along its sides in y and in z
  std::array<std::size_t, 2> count{};      // of lines along y and along z
  std::array<double, 2> first{};           // y and z of line (0, 0), mm
  std::array<double, 2> spacing{};         // mm

  // Place of line i along y (axis 0) or z (axis 1), mm.
  double at(std::size_t axis, std::size_t i) const {
    return first[axis] + spacing[axis] * static_cast<double>(i);
  }
};

// Where a line crosses the surface.
struct LineCrossing {
  double x;  // mm
  int step;  // +1 into the body, -1 out of it
};

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

// Adds the part of a line from x0 to x1 to the voxels of its row.
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

// Twice the area of the triangle (line, a, b) in the plane of y and z. Exchanging the ends changes only its
// sign, so a line that meets an edge is on one side of it for both faces.
double side_of(double y, double z, const Vec3& a, const Vec3& b) {
  const bool swapped = std::pair(b.y(), b.z()) < std::pair(a.y(), a.z());
  const Vec3& from = swapped ? b : a;
  const Vec3& to = swapped ? a : b;
  const double area = (to.y() - from.y()) * (z - from.z()) - (to.z() - from.z()) * (y - from.y());
  // A line on the edge counts as left of it; the face on the other side gets the opposite.
  const double decided = area != 0.0 ? area : 1.0;
  return swapped ? -decided : decided;
}

// First and last line of an axis between two coordinates; no line if first > last.
std::pair<long, long> range(const ScanLines& lines, std::size_t axis, double low, double high) {
  const auto first =
      std::max(0L, static_cast<long>(std::ceil((low - lines.first[axis]) / lines.spacing[axis] - 1e-9)));
  const auto last =
      std::min(static_cast<long>(lines.count[axis]) - 1,
               static_cast<long>(std::floor((high - lines.first[axis]) / lines.spacing[axis] + 1e-9)));
  return {first, last};
}

void cross(const ScanLines& lines, const std::array<Vec3, 3>& t,
           std::vector<std::vector<LineCrossing>>& crossings) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  if (normal.x() == 0.0) return;  // parallel to the lines: they meet its neighbours instead
  const auto [low_y, high_y] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
  const auto [low_z, high_z] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
  const auto [first_y, last_y] = range(lines, 0, low_y, high_y);
  const auto [first_z, last_z] = range(lines, 1, low_z, high_z);
  for (long k = first_z; k <= last_z; ++k) {
    for (long j = first_y; j <= last_y; ++j) {
      const double y = lines.at(0, static_cast<std::size_t>(j));
      const double z = lines.at(1, static_cast<std::size_t>(k));
      int left = 0;
      for (std::size_t e = 0; e < 3; ++e) left += side_of(y, z, t[e], t[(e + 1) % 3]) > 0.0 ? 1 : 0;
      if (left != 0 && left != 3) continue;
      const double x = t[0].x() - (normal.y() * (y - t[0].y()) + normal.z() * (z - t[0].z())) / normal.x();
      crossings[static_cast<std::size_t>(k) * lines.count[0] + static_cast<std::size_t>(j)].push_back(
          {x, normal.x() < 0.0 ? 1 : -1});
    }
  }
}

// At least two lines along each side of a voxel.
ScanLines lines_of(const VoxelImage& image) {
  ScanLines lines;
  for (std::size_t a = 0; a < 2; ++a) {
    const double side = image.spacing[static_cast<int>(a) + 1];
    lines.per_voxel[a] = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(side / kLineSpacing)));
    lines.count[a] = image.count[a + 1] * lines.per_voxel[a];
    lines.spacing[a] = side / static_cast<double>(lines.per_voxel[a]);
    lines.first[a] = image.origin[static_cast<int>(a) + 1] - 0.5 * side + 0.5 * lines.spacing[a];
  }
  return lines;
}

// The crossings of every line, lines with y fastest, the crossings of a line in no order. A line that meets
// an edge or a vertex is treated as if it passed just beside it.
std::vector<std::vector<LineCrossing>> cross_all(const ScanLines& lines, const TriangleMesh& body) {
  std::vector<std::vector<LineCrossing>> crossings(lines.count[0] * lines.count[1]);
  for (const Face& f : body.faces)
    cross(lines, {corner(body, f, 0), corner(body, f, 1), corner(body, f, 2)}, crossings);
  return crossings;
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
