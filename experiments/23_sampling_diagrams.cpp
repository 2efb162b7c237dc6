// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How does the thesis fill a table, shown on the triangles of a hip? (Figures 25 and 28 to 34)
// @writes    diagram_corners diagram_chart diagram_coverage
// @files     diagrams/socket_table.pgm
// @timing    no
// @seconds   1 1
// @links     harness 23_detection_diagrams table hip thesis_forms
//
// The hip is the stand-in for the thesis' patient A (hip/hip_presets.hpp). Where single faces are shown it
// has about 500 faces, so that each fills many entries. The whole socket is drawn from its usual mesh.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "23_detection_diagrams/diagram_tables.hpp"
#include "files/file_bytes.hpp"
#include "harness/driver.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/chart.hpp"
#include "methods/thesis_raster.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/schemes/rsid.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

// The radii that the greys of an image stand for.
struct GreyRange {
  double smallest = 0.0;  // mm, grey 1
  double largest = 0.0;   // mm, grey 255
};

// The range over all radii of the table.
GreyRange grey_range(const RadialTable<Rsid>& table) {
  GreyRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double r : table.radii()) {
    if (std::isnan(r)) continue;
    range.smallest = std::min(range.smallest, r);
    range.largest = std::max(range.largest, r);
  }
  return range;
}

// The table as a binary PGM file of 8 bits with a pixel for each entry, in rows and columns of the table. 0
// means no surface, 1 to 255 the range of radii.
std::string table_image(const RadialTable<Rsid>& table, GreyRange range) {
  const Rsid& scheme = table.scheme();
  std::string image =
      "P5\n" + std::to_string(scheme.columns()) + " " + std::to_string(scheme.rows()) + "\n255\n";
  image.reserve(image.size() + scheme.size());
  const double scale = range.largest > range.smallest ? 254.0 / (range.largest - range.smallest) : 0.0;
  for (const double r : table.radii()) {
    const double grey = std::isnan(r) ? 0.0 : 1.0 + std::round(scale * (r - range.smallest));
    image.push_back(static_cast<char>(static_cast<unsigned char>(grey)));
  }
  return image;
}

constexpr const char* kHip = "patient_a";
constexpr const char* kPlainFace = "plain";
constexpr std::size_t kFewFaces = 500;
constexpr std::size_t kPairFaces = 400;                // of Figure 30
constexpr double kImagePrecision = 0.1;                // degrees, as in Figure 31
constexpr double kPrecision = 1.0;                     // degrees, of the entries of a face
constexpr std::array kOtherPrecisions{0.5, 2.0};       // degrees, Figure 32, for the plain face too
const Angles kPlain{60.0 * kDegree, 120.5 * kDegree};  // a face of the socket far from pole and seam
const Angles kSeam{50.5 * kDegree, 0.0};               // a face of the ball across the seam

// A few faces with a name.
struct NamedFaces {
  const char* name;
  TriangleMesh mesh;
};

std::vector<NamedFaces> faces_of_the_figures(const TriangleMesh& pair_ball) {
  const Hip coarse = make_hip(hip_preset(kHip), kFewFaces);
  const Vec3 pole = Vec3::UnitZ();
  return {{kPlainFace, faces_along(coarse.socket, to_direction(kPlain))},
          {"pole_inside", faces_along(coarse.socket, pole)},
          {"pole_on_edge", faces_along(over_an_edge(coarse.socket), pole)},
          {"pole_at_vertex", faces_along(pair_ball, pole)},
          {"seam", faces_along(coarse.ball, to_direction(kSeam))}};
}

// Writes the socket and an image of its table; returns the image's range of radii for the parameters.
nlohmann::json write_image(const DriverRun& run, const TriangleMesh& socket) {
  const std::filesystem::path folder = run.record.folder / "diagrams";
  require_writable_folder(folder);
  const RadialTable<Rsid> table = fill_thesis(socket, Rsid::with_precision(kImagePrecision), Layer::nearest);
  const GreyRange range = grey_range(table);
  write_if_changed(folder / "socket_table.pgm", table_image(table, range));
  return {{"image_precision_deg", kImagePrecision},
          {"image_smallest_mm", range.smallest},
          {"image_largest_mm", range.largest}};
}

void body(DriverRun& run) {
  Table corners = corner_table();
  Table chart = chart_table();
  Table coverage = coverage_table();
  const TriangleMesh pair_ball = make_ball_socket_pair(kPairFaces).ball;
  const std::vector<NamedFaces> faces = faces_of_the_figures(pair_ball);
  for (const NamedFaces& shown : faces) {
    add_corners(shown.name, shown.mesh, corners);
    add_chart(shown.name, shown.mesh, chart);
    add_coverage(shown.name, shown.mesh, Rsid::with_precision(kPrecision), coverage);
  }
  for (const double precision : kOtherPrecisions) {
    add_coverage(kPlainFace, faces.front().mesh, Rsid::with_precision(precision), coverage);
  }
  add_corners("pair_ball", pair_ball, corners);
  add_chart("pair_ball", pair_ball, chart);
  const TriangleMesh socket = make_hip(hip_preset(kHip)).socket;
  add_chart("socket", socket, chart);
  const nlohmann::json image = write_image(run, socket);
  run.write({"diagram_corners", "Which faces do the diagrams show?", std::move(corners), {}, {}});
  run.write({"diagram_chart", "Which flat triangles stand for a face?", std::move(chart), image, {}});
  run.write({"diagram_coverage", "Which entries does a face fill?", std::move(coverage), {}, {}});
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"23_sampling_diagrams", "What the thesis' diagrams of its sampling draw (Figures 25 to 34)."}, body);
}
