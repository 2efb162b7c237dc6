// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Do those statements of the thesis hold that no other experiment tests?
// @writes    finding_comparison finding_interpolation finding_grids
// @timing    no
// @seconds   3 3
// @links     harness gap thesis_forms
//
// Tests the comparison of Algorithms 2 and 3 for both scans; how far a radius that is linear in the angles is
// from the mesh and from the sphere behind it, and how far inside that sphere the faces of the heads of
// Tables 4 and 9 lie; and the steps of a table of n by n entries (Section 3.6.3).

#include <array>
#include <cmath>
#include <utility>

#include "gap/gap_scan.hpp"
#include "harness/driver.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/icosphere.hpp"
#include "methods/thesis_fills.hpp"
#include "methods/thesis_raster.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kPairFaces = 3000;
constexpr double kHeadRadius = 22.0;                           // mm
constexpr double kShift = 0.3 * kHeadRadius;                   // mm, of the eccentric sphere
constexpr std::array<std::size_t, 2> kHalvings{2, 3};          // icospheres of 320 and 1,280 faces
constexpr std::array<std::size_t, 2> kHeadFaces{3000, 12000};  // of the generated head, without its bump
constexpr double kTable = 1.0;                                 // degrees, precision of the table
constexpr double kProbes = 0.25;                               // degrees, spacing of these directions
constexpr std::array<std::size_t, 2> kGridSides{10, 400};

Result comparison() {
  Result result{
      "finding_comparison", "Which vertices of a clear pose does d <= d_i call impinged?", {}, {}, {}};
  result.table.columns = {
      {"surface", "", "whose vertices are tested against the table of the other"},
      {"vertices_met", "1", "that meet the other surface"},
      {"impinged_by_gap", "1", "of these, by the signed gap"},
      {"impinged_as_written", "1", "of these, by d <= d_i, d of the table, d_i of the vertex"}};
  result.parameters = {{"faces", kPairFaces}, {"precision_deg", kTable}, {"pose", "identity"}};
  const BallSocketPair pair = make_ball_socket_pair(kPairFaces);
  const Rsid scheme = Rsid::with_precision(kTable);
  const auto add = [&](const char* name, Surface scanned, const std::vector<double>& gap) {
    const ScanVerdicts verdicts = compare_as_written(gap, scanned);
    result.table.add_row({name, verdicts.met, verdicts.by_gap, verdicts.as_written});
  };
  std::vector<double> gap(pair.ball.vertices.size());
  scan_gaps(fill_exact(pair.socket, scheme, Layer::nearest), pair.ball.vertices, {}, Surface::ball, gap);
  add("ball", Surface::ball, gap);
  gap.resize(pair.socket.vertices.size());
  scan_gaps(fill_exact(pair.ball, scheme, Layer::farthest), pair.socket.vertices, {}, Surface::socket, gap);
  add("socket", Surface::socket, gap);
  return result;
}

// Largest and root mean square difference of two radii over the directions, mm. Directions crowd at the poles
// of the grid, so each counts by the sine of its polar angle.
template <class First, class Second>
std::pair<double, double> difference(const Rsid& directions, const First& first, const Second& second) {
  double largest = 0.0;
  double squares = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vec3 u = directions.direction(i);
    const double off = std::abs(first(i, u) - second(i, u));
    const double weight = std::hypot(u.x(), u.y());
    largest = std::max(largest, off);
    squares += weight * off * off;
    weights += weight;
  }
  return {largest, std::sqrt(squares / weights)};
}

void add_sphere(Table& table, std::size_t halvings, const char* shifted, const Vec3& shift) {
  TriangleMesh mesh = icosphere(kHeadRadius, halvings);
  for (Vec3& v : mesh.vertices) v += shift;
  const Rsid probes = Rsid::with_precision(kProbes);
  const RadialTable<Rsid> exact = fill_exact(mesh, probes, Layer::farthest);
  const RadialTable<Rsid> raster = fill_thesis(mesh, probes, Layer::farthest);
  const RadialTable<Rsid> coarse = fill_exact(mesh, Rsid::with_precision(kTable), Layer::farthest);
  const auto of_mesh = [&](std::size_t i, const Vec3&) { return exact.radii()[i]; };
  const auto of_raster = [&](std::size_t i, const Vec3&) { return raster.radii()[i]; };
  const auto of_table = [&](std::size_t, const Vec3& u) { return coarse.radius_at(u); };
  const auto of_sphere = [&](std::size_t, const Vec3& u) {
    return eccentric_sphere_radius(u, kHeadRadius, shift);
  };
  const auto add = [&](const char* what, const char* against, std::pair<double, double> off) {
    table.add_row({mesh.faces.size(), shifted, shift.norm(), what, against, off.first, off.second});
  };
  add("thesis_raster", "mesh", difference(probes, of_raster, of_mesh));
  add("thesis_raster", "sphere", difference(probes, of_raster, of_sphere));
  add("rsid_table", "mesh", difference(probes, of_table, of_mesh));
  add("rsid_table", "sphere", difference(probes, of_table, of_sphere));
  add("mesh", "sphere", difference(probes, of_mesh, of_sphere));
}

// The error that no table of the faces can undo: faces lie inside the sphere that holds their corners.
void add_head(Table& table, std::size_t faces) {
  const TriangleMesh ball =
      make_ball_socket_pair(faces, {.head_radius = kHeadRadius, .cam_height = 0.0}).ball;
  const Rsid probes = Rsid::with_precision(kProbes);
  const RadialTable<Rsid> exact = fill_exact(ball, probes, Layer::farthest);
  const auto of_mesh = [&](std::size_t i, const Vec3&) { return exact.radii()[i]; };
  const auto of_sphere = [](std::size_t, const Vec3&) { return kHeadRadius; };
  const auto [largest, rms] = difference(probes, of_mesh, of_sphere);
  table.add_row({faces, "none", 0.0, "mesh", "sphere", largest, rms});
}

Result interpolation() {
  Result result{"finding_interpolation",
                "How far is a radius linear in the angles from the mesh and from the sphere?",
                {},
                {},
                {}};
  result.table.columns = {{"faces", "1", "of the icosphere, or of the generated head (3,000 and 12,000)"},
                          {"shifted", "", "axis along which its centre is off the centre of rotation"},
                          {"shift_mm", "mm", "by how much"},
                          {"radius_of", "", "raster of the thesis, exact table looked up, or the mesh"},
                          {"against", "", "the mesh, or the sphere behind it"},
                          {"largest_mm", "mm", "over all directions"},
                          {"rms_mm", "mm", "the same"}};
  result.parameters = {{"radius_mm", kHeadRadius}, {"table_deg", kTable}, {"directions_deg", kProbes}};
  for (const std::size_t halvings : kHalvings) {
    add_sphere(result.table, halvings, "none", Vec3::Zero());
    add_sphere(result.table, halvings, "x", kShift * Vec3::UnitX());
    add_sphere(result.table, halvings, "z", kShift * Vec3::UnitZ());
  }
  for (const std::size_t faces : kHeadFaces) add_head(result.table, faces);
  return result;
}

Result grids() {
  Result result{"finding_grids", "How far apart are the entries of a table of n by n?", {}, {}, {}};
  result.table.columns = {
      {"side", "1", "n"}, {"polar_step_deg", "deg", "180 / n"}, {"azimuth_step_deg", "deg", "360 / n"}};
  for (const std::size_t side : kGridSides) {
    const auto n = static_cast<double>(side);
    result.table.add_row({side, 180.0 / n, 360.0 / n});
  }
  return result;
}

void body(DriverRun& run) {
  for (const Result& result : {comparison(), interpolation(), grids()}) run.write(result);
}

}  // namespace
}  // namespace impinge::lab

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv, {"15_findings", "Statements of the thesis, checked."},
                                  impinge::lab::body);
}
