// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How much of the error of a gap comes from slices, noise, decimation, centre, table?
// (Sections 3.4, 3.5.2)
// @writes    slices_to_surface slices_to_surface_image slices_to_surface_mesh
// @timing    no
// @seconds   5 60
// @reads     19_slices_to_surface/isosurface.py
// @links     harness imaging mesh_io hip reference
//
// A generated hip is scanned (pixels of 0.7 mm, slices of 0.5 to 5 mm, partial volume, noise), its surface
// drawn and decimated by VTK (isosurface.py), the centre fitted and tables filled. An image and the surface
// at 1.25 mm are kept for Figure 37.

#include "19_slices_to_surface/slices_tables.hpp"
#include "harness/driver.hpp"
#include "hip/hip_presets.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr double kThesisSlice = 1.25;  // mm
constexpr double kWall = 5.0;          // mm, so that the socket is a body
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
