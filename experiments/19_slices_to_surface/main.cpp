// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How much do slices, noise, decimation, centre and table add to a gap's error? (Section 3.5.2)
// @writes    slices_to_surface slices_to_surface_image slices_to_surface_mesh
// @timing    no
// @seconds   5 60
// @reads     19_slices_to_surface/isosurface.py
// @links     harness imaging mesh_io hip reference
//
// A generated hip is scanned (pixels of 0.7 mm, slices of 0.5 to 5 mm, partial volume, noise). VTK makes and
// decimates its surface (isosurface.py), the centre is fitted and tables are filled (thesis, Sections 3.4 and
// 3.5.2). An image and the surface at 1.25 mm are kept for Figure 37.

#include <cmath>
#include <string>
#include <utility>

#include "19_slices_to_surface/slices_study.hpp"
#include "files/csv.hpp"
#include "harness/driver.hpp"
#include "hip/hip_presets.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

double rounded(double mm) { return std::round(1e3 * mm) * 1e-3; }

TriangleMesh both_bones(const Hip& hip) {
  TriangleMesh both = hip.ball;
  const auto shift = static_cast<VertexIndex>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), hip.socket.vertices.begin(), hip.socket.vertices.end());
  for (const Face& f : hip.socket.faces) both.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  return both;
}

void add_faces(Table& table, const char* name, const TriangleMesh& mesh) {
  for (const Face& face : mesh.faces) {
    std::vector<Cell> row{name};
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double x : corner(mesh, face, k)) row.emplace_back(rounded(x));
    }
    table.add_row(std::move(row));
  }
}

// The columns, without rows.
Table stage_table() {
  Table table;
  table.columns = {{"slice_mm", "mm", "distance and thickness of the slices"},
                   {"stage", "", "slices, noise, decimation, centre, table: each on top of the one before"},
                   {"ball_faces", "1", "triangles"},
                   {"socket_faces", "1", "triangles"},
                   {"directions", "1", "in which the surfaces face each other"},
                   {"missed", "1", "of them, without a gap"},
                   {"mean_mm", "mm", "mean of gap minus true gap"},
                   {"rms_mm", "mm", "root mean square of the same"},
                   {"largest_mm", "mm", "largest of the same, by amount"},
                   {"added_rms_mm", "mm", "root mean square of gap minus that of the stage before"},
                   {"centre_off_um", "um", "fitted centre from the true one"}};
  return table;
}

// Adds the rows for one slice distance, mm.
void add_stages(Table& table, double slice_mm, const SlicesResult& result) {
  for (const StageError& stage : result.stages) {
    table.add_row({slice_mm, stage.stage, stage.ball_faces, stage.socket_faces, stage.directions,
                   stage.missed, stage.mean_mm, stage.rms_mm, stage.largest_mm, stage.added_rms_mm,
                   1e3 * result.centre.norm()});
  }
}

// The decimated surfaces, one row a triangle, to a micrometre.
Table mesh_table(const SlicesResult& result) {
  Table table;
  table.columns = {{"body", "", "ball or socket"}};
  for (const char* at : {"a", "b", "c"}) {
    for (const char* axis : {"x", "y", "z"})
      table.columns.push_back({std::string(axis) + "_" + at + "_mm", "mm", "corner of a triangle"});
  }
  add_faces(table, "ball", result.ball);
  add_faces(table, "socket", result.socket);
  return table;
}

// The pixels of the slice through the centre of the head, with both bones in one image.
Table slice_table(const Hip& hip, const SlicesOptions& options) {
  const VoxelImage image = hounsfield(bone_shares(both_bones(hip), options.grid), options.levels);
  const auto k = static_cast<std::size_t>(std::round(-image.origin.z() / image.spacing.z()));
  Table table;
  table.columns = {{"x_mm", "mm", "middle of the pixel"},
                   {"y_mm", "mm", "middle of the pixel"},
                   {"z_mm", "mm", "middle of the slice"},
                   {"value_hu", "HU", "brightness"}};
  for (std::size_t j = 0; j < image.count[1]; ++j) {
    for (std::size_t i = 0; i < image.count[0]; ++i) {
      const Vec3 steps(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
      const Vec3 at = image.origin + steps.cwiseProduct(image.spacing);
      const double value = std::round(static_cast<double>(image.values[image.index(i, j, k)]));
      table.add_row({rounded(at.x()), rounded(at.y()), rounded(at.z()), value});
    }
  }
  return table;
}

constexpr double kThesisSlice = 1.25;  // mm
constexpr double kWall = 5.0;          // mm, so that the socket is a closed body
constexpr std::size_t kDirections = 8000;
constexpr std::size_t kDirectionsInQuick = 1500;
constexpr std::size_t kFaces = 48000;  // of the hip that is scanned
constexpr std::size_t kFacesInQuick = 12000;

Result make_result(std::string name, const char* question, const SlicesOptions& options) {
  Result result{std::move(name), question};
  result.parameters = {{"hip", "normal"},
                       {"pixel_mm", options.grid.pixel},
                       {"bone_hu", options.levels.bone},
                       {"tissue_hu", options.levels.tissue},
                       {"noise_hu", options.levels.noise},
                       {"precision_deg", options.precision_deg},
                       {"surface", "vtkFlyingEdges3D, then vtkQuadricDecimation"}};
  return result;
}

void write_pictures(DriverRun& run, const SlicesOptions& options, const Hip& hip,
                    const SlicesResult& scanned) {
  Result mesh = make_result("slices_to_surface_mesh", "The surface drawn from slices of 1.25 mm?", options);
  mesh.table = mesh_table(scanned);
  run.write(mesh);
  Result image = make_result("slices_to_surface_image", "What does a slice look like?", options);
  image.table = slice_table(hip, options);
  run.write(image);
}

void body(DriverRun& run) {
  HipParameters parameters = hip_preset("normal");
  parameters.wall_thickness = kWall;
  parameters.shaft_length = 0.0;  // head and neck, as the thesis cut its femur
  const Hip hip = make_hip(parameters, run.quick() ? kFacesInQuick : kFaces);
  const FacingGaps truth = facing_gaps(hip, run.quick() ? kDirectionsInQuick : kDirections);
  SlicesOptions options;
  Result result =
      make_result("slices_to_surface", "What does each stage from slices to tables add?", options);
  result.table = stage_table();
  const std::vector<double> slices{0.5, 0.7, kThesisSlice, 2.0, 3.0, 5.0};
  for (std::size_t s = 0; s < slices.size(); ++s) {
    options.grid.slice = slices[s];
    options.levels.seed = run.record.seed + s;
    const SlicesResult scanned = slices_to_surface(hip, truth, options);
    add_stages(result.table, slices[s], scanned);
    if (slices[s] == kThesisSlice) write_pictures(run, options, hip, scanned);
    run.progress.say("scanned in slices of " + Cell(slices[s]).text() + " mm");
  }
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv, {"19_slices_to_surface", "From slices to surface (Figure 37)."},
                                  body);
}
