// SPDX-License-Identifier: GPL-3.0-or-later
#include "imaging/scan_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impinge {
namespace {

// Twice the area of the triangle (line, a, b) in the plane of y and z. Which way round the ends are given
// changes the sign and no digit, so that a line that meets an edge is on one side of it for both faces.
double side_of(double y, double z, const Vec3& a, const Vec3& b) {
  const bool swapped = std::pair(b.y(), b.z()) < std::pair(a.y(), a.z());
  const Vec3& from = swapped ? b : a;
  const Vec3& to = swapped ? a : b;
  const double area = (to.y() - from.y()) * (z - from.z()) - (to.z() - from.z()) * (y - from.y());
  // A line on the edge counts as left of it; the face on the other side sees the opposite.
  const double decided = area != 0.0 ? area : 1.0;
  return swapped ? -decided : decided;
}

// First and last line of an axis between two coordinates; none where first > last.
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
  if (normal.x() == 0.0) return;  // along the lines: its neighbours are met instead
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

}  // namespace

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

std::vector<std::vector<LineCrossing>> cross_all(const ScanLines& lines, const TriangleMesh& body) {
  std::vector<std::vector<LineCrossing>> crossings(lines.count[0] * lines.count[1]);
  for (const Face& f : body.faces)
    cross(lines, {corner(body, f, 0), corner(body, f, 1), corner(body, f, 2)}, crossings);
  return crossings;
}

}  // namespace impinge
