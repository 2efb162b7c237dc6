// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/rim_line.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace impinge {

std::vector<RimPoint> rim_line(const TriangleMesh& socket, const ClockFace& dial, std::size_t sectors) {
  const std::vector<double> area = vertex_areas(socket);
  Vec3 axis = dial.twelve.cross(dial.three);
  double along = 0.0;
  for (std::size_t i = 0; i < area.size(); ++i) along += area[i] * axis.dot(socket.vertices[i]);
  if (along < 0.0) axis = -axis;  // into the socket
  struct Farthest {
    double cosine = std::numeric_limits<double>::infinity();
    RimPoint point;
  };
  std::vector<Farthest> of_sector(sectors);
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Vec3& x = socket.vertices[i];
    if (area[i] == 0.0 || x.norm() == 0.0) continue;
    const double hours = dial.hours(x);
    const auto sector = static_cast<std::size_t>(hours / 12.0 * static_cast<double>(sectors));
    const Farthest here{axis.dot(x) / x.norm(), {hours, x}};
    Farthest& farthest = of_sector[std::min(sector, sectors - 1)];
    if (here.cosine < farthest.cosine) farthest = here;
  }
  std::vector<RimPoint> rim;
  for (const Farthest& farthest : of_sector) {
    if (farthest.cosine <= 1.0) rim.push_back(farthest.point);
  }
  return rim;
}

}  // namespace impinge
