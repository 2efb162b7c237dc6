// SPDX-License-Identifier: GPL-3.0-or-later
#include "23_detection_diagrams/diagram_lookup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "gap/gap_scan.hpp"
#include "methods/thesis_raster.hpp"

namespace impinge::lab {
namespace {

constexpr long kAround = 2;  // rows and columns of an excerpt beyond the cell

// One scan: whose vertices, against whose table, and what came out.
struct Scan {
  std::string_view scanned;
  const TriangleMesh& mesh;
  const RadialTable<Rsid>& table;
  const std::vector<double>& gap;
};

void add_scan(const Scan& scan, Table& scans) {
  const auto filled =
      std::ranges::count_if(scan.table.radii(), [](double radius) { return !std::isnan(radius); });
  std::size_t met = 0;
  std::size_t impinged = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (const double gap : scan.gap) {
    if (std::isnan(gap)) continue;
    ++met;
    if (gap <= 0.0) ++impinged;
    smallest = std::min(smallest, gap);
  }
  scans.add_row({scan.scanned, scan.mesh.faces.size(), scan.mesh.vertices.size(), scan.table.radii().size(),
                 filled, RadialTable<Rsid>::bytes(scan.table.scheme()), met, impinged, smallest});
}

}  // namespace

std::size_t vertex_in_section(const TriangleMesh& mesh, double phi_from, double phi_to) {
  std::size_t found = mesh.vertices.size();
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& x = mesh.vertices[i];
    const double phi = to_angles(x).phi;
    if (!(x.x() > 0.0) || phi < phi_from || phi > phi_to) continue;
    if (found == mesh.vertices.size() || std::abs(x.y()) < std::abs(mesh.vertices[found].y())) found = i;
  }
  if (found == mesh.vertices.size()) throw std::invalid_argument("no vertex between these polar angles");
  return found;
}

Table lookup_table() {
  return {{{"pose", "", "name of the pose"},
           {"vertex", "1", "of the ball"},
           {"x", "mm", "where it is, socket frame"},
           {"y", "mm", "the same; 0 in the plane of the section"},
           {"z", "mm", "the same"},
           {"phi_deg", "deg", "its polar angle"},
           {"theta_deg", "deg", "its azimuth"},
           {"vertex_mm", "mm", "its distance from the centre"},
           {"table_mm", "mm", "radius of the socket in that direction, by its table; empty for none"},
           {"gap_mm", "mm", "table_mm - vertex_mm; 0 or less is impingement"}},
          {}};
}

void add_lookup(const PosedVertex& vertex, const RadialTable<Rsid>& socket, Table& lookups) {
  const Vec3& x = vertex.x;
  const Angles at = to_angles(x);
  const double radius = socket.radius_at(x);
  lookups.add_row({vertex.pose_name, vertex.vertex, x.x(), x.y(), x.z(), at.phi / kDegree, at.theta / kDegree,
                   x.norm(), radius, radius - x.norm()});
}

Table excerpt_table() {
  return {{{"pose", "", "name of the pose"},
           {"row", "1", "of the table"},
           {"column", "1", "the same"},
           {"phi_deg", "deg", "of the entry"},
           {"theta_deg", "deg", "the same"},
           {"radius_mm", "mm", "entry; empty where there is no surface"},
           {"weight", "1", "of the entry in the look-up; 0 where it is not read"}},
          {}};
}

void add_excerpt(const PosedVertex& vertex, const RadialTable<Rsid>& socket, Table& excerpt) {
  const Rsid& scheme = socket.scheme();
  const Stencil stencil = scheme.stencil(vertex.x);
  const auto columns = static_cast<long>(scheme.columns());
  const auto rows = static_cast<long>(scheme.rows());
  const auto top = static_cast<long>(stencil.entry[0]) / columns;
  const auto left = static_cast<long>(stencil.entry[0]) % columns;
  for (long i = std::max(top - kAround, 0L); i <= std::min(top + 1 + kAround, rows - 1); ++i) {
    for (long j = left - kAround; j <= left + 1 + kAround; ++j) {
      const long column = ((j % columns) + columns) % columns;
      const auto entry = static_cast<std::size_t>(i * columns + column);
      double weight = 0.0;
      for (std::size_t k = 0; k < stencil.taps; ++k) {
        if (stencil.entry[k] == entry) weight += stencil.weight[k];
      }
      excerpt.add_row({vertex.pose_name, i, column, static_cast<double>(i) * scheme.precision_deg(),
                       static_cast<double>(column) * scheme.precision_deg(), socket.radius_of(entry),
                       weight});
    }
  }
}

Table scan_table() {
  return {{{"scanned", "", "whose vertices are looked up: ball or socket; the table is the other one's"},
           {"triangles", "1", "of that surface"},
           {"vertices", "1", "of it, each looked up"},
           {"entries", "1", "of the other one's table"},
           {"filled", "1", "of them, those where there is a surface"},
           {"bytes", "B", "of the radii of the table"},
           {"met", "1", "vertices that face the other surface"},
           {"impinged", "1", "of them, those with a gap of 0 or less"},
           {"smallest_gap_mm", "mm", "over all of them"}},
          {}};
}

void add_scans(const TriangleMesh& ball, const TriangleMesh& socket, const Pose& pose, const Rsid& scheme,
               Table& scans) {
  const RadialTable<Rsid> ball_table = fill_thesis(ball, scheme, Layer::farthest);
  const RadialTable<Rsid> socket_table = fill_thesis(socket, scheme, Layer::nearest);
  std::vector<double> gap(ball.vertices.size());
  scan_gaps(socket_table, ball.vertices, pose, Surface::ball, gap);
  add_scan({"ball", ball, socket_table, gap}, scans);
  gap.resize(socket.vertices.size());
  scan_gaps(ball_table, socket.vertices, pose, Surface::socket, gap);
  add_scan({"socket", socket, ball_table, gap}, scans);
}

}  // namespace impinge::lab
