// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How do a look-up and a scan work, shown on a hip? (Figures 26, 27, 29 and 35)
// @writes    diagram_sections diagram_rays diagram_bodies diagram_lookups diagram_excerpt diagram_scans
// @timing    no
// @seconds   1 1
// @links     harness table gap hip thesis_forms
//
// The hip is the stand-in for the thesis' patient A (hip/hip_presets.hpp), cut by the patient's frontal
// plane.

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "23_detection_diagrams/diagram_tables.hpp"
#include "files/csv.hpp"
#include "gap/gap_scan.hpp"
#include "gap/pose.hpp"
#include "harness/driver.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/motion.hpp"
#include "mesh/triangle_mesh.hpp"
#include "methods/thesis_raster.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/schemes/rsid.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

// The data for diagrams of the thesis' detection (Figures 26, 27 and 35): one vertex of a ball, looked up in
// the socket's table in a few poses, and the numbers of both scans in a pose. Lengths in mm.

// A vertex of the ball in a named pose.
struct PosedVertex {
  std::string_view pose_name;  // name of the pose
  std::size_t vertex = 0;      // index of the vertex in the ball's mesh
  Vec3 x = Vec3::Zero();       // socket frame, mm
};

constexpr long kAround = 2;  // rows and columns of an excerpt around the cell

// One scan: whose vertices, against whose table, and the result.
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

// The vertex nearest to the plane y = 0 with x > 0 and a polar angle between the two limits (radians), so
// that a section by that plane shows it. Throws std::invalid_argument if there is none.
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

// The columns, without rows.
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

// Adds the row of one vertex: its angles and radius, the radius in the table, and the gap.
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

// Adds the entries around a look-up, with their weights: rows and columns of its cell, and two on each side.
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

// Adds two rows, one for each scan of a joint (socket frame, ball frame) in a pose; tables as in the thesis.
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

constexpr const char* kHip = "patient_a";
constexpr double kPrecision = 1.0;  // degrees, precision of the tables
constexpr double kRayStep = 5.0;    // degrees, in sections
constexpr double kTurn = 40.0;      // degrees of abduction, Figure 35 b
constexpr double kPush = 7.0;       // mm upwards, Figure 35 c
// Flexion with internal rotation, as in a physician's impingement test; the bones overlap.
constexpr Motion kImpinging{.flexion = 100.0, .internal_rotation = 15.0};

struct NamedPose {
  const char* name;
  Pose pose;
};

Pose turned(const Motion& motion, const HipParameters& shape) {
  return {joint_rotation(motion, shape.side), Vec3::Zero()};
}

// Figures 26, 27 and 35: the hip in the patient's frontal plane, y = 0, the look-up of a vertex, both scans.
void body(DriverRun& run) {
  const HipParameters shape = hip_preset(kHip);
  const Hip hip = make_hip(shape);
  const RadialTable<Rsid> table = fill_thesis(hip.socket, Rsid::with_precision(kPrecision), Layer::nearest);
  const std::size_t vertex = vertex_in_section(hip.ball, 15.0 * kDegree, 25.0 * kDegree);
  const std::array<NamedPose, 3> poses{{{"rest", {}},
                                        {"turned", turned({.abduction = kTurn}, shape)},
                                        {"pushed", {Eigen::Matrix3d::Identity(), kPush * Vec3::UnitZ()}}}};
  Table sections = section_table();
  Table lookups = lookup_table();
  Table excerpt = excerpt_table();
  for (const NamedPose& posed : poses) {
    TriangleMesh ball = hip.ball;
    for (Vec3& x : ball.vertices) x = to_socket(posed.pose, x);
    add_section(posed.name, ball, sections);
    add_lookup({posed.name, vertex, ball.vertices[vertex]}, table, lookups);
    add_excerpt({posed.name, vertex, ball.vertices[vertex]}, table, excerpt);
  }
  add_section("socket", hip.socket, sections);
  Table rays = ray_table();
  add_rays("socket", hip.socket, kRayStep, rays);
  Table bodies = body_table();
  for (const NamedBody& shown : bodies_by_shape(shape, kHipFaces)) {
    add_section(shown.name, shown.mesh, sections);
    add_rays(shown.name, shown.mesh, kRayStep, rays);
    add_body(shown.name, shown.mesh, bodies);
  }
  Table scans = scan_table();
  add_scans(hip.ball, hip.socket, turned(kImpinging, shape), table.scheme(), scans);
  run.write({"diagram_sections", "What does the plane y = 0 cut?", std::move(sections), {}, {}});
  run.write({"diagram_rays", "Where do rays of that plane meet a surface?", std::move(rays), {}, {}});
  run.write({"diagram_bodies", "Are bodies spheres, or star-shaped?", std::move(bodies), {}, {}});
  run.write({"diagram_lookups",
             "What does a look-up give?",
             std::move(lookups),
             {{"precision_deg", kPrecision}, {"abduction_deg", kTurn}, {"push_mm", kPush}},
             {}});
  run.write({"diagram_excerpt", "Which entries does it read?", std::move(excerpt), {}, {}});
  run.write({"diagram_scans",
             "What do both scans of a pose give?",
             std::move(scans),
             {{"precision_deg", kPrecision},
              {"flexion_deg", kImpinging.flexion},
              {"internal_rotation_deg", kImpinging.internal_rotation}},
             {}});
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"23_detection_diagrams", "What the thesis' diagrams of its detection draw (Figures 26 to 35)."}, body);
}
