// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Where is the ball of a joint a sphere? (Figures 38, 39, 60 and 61)
// @writes    head_maps
// @files     head_maps/patient_a.ply head_maps/patient_b.ply
// @files-with-bones  head_maps/JOINT.ply
// @bones     yes
// @timing    no
// @seconds   1 3
// @links     harness real_joints mesh hip ply_series
//
// Each mesh is placed about the centre of its sphere. Each vertex has its distance from the sphere and
// whether it was used in the fit. The patients are stand-ins (hip/hip_presets.hpp).

#include <algorithm>

#include "files/file_bytes.hpp"
#include "harness/driver.hpp"
#include "harness/ply_series.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/sphere_fit.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

// A ball and where its origin is.
struct Ball {
  std::string joint;
  TriangleMesh mesh;
  Vec3 origin = Vec3::Zero();  // mm, input frame
};

void add_map(DriverRun& run, const Ball& ball, Table& maps) {
  const SphereFit fit = fit_ball(ball.mesh);
  const std::vector<double> deviation = sphere_deviations(ball.mesh, fit);
  const std::vector<bool> fitted = spherical_region(ball.mesh, fit);
  const std::vector<double> area = vertex_areas(ball.mesh);
  double low = 0.0;
  double high = 0.0;
  double fitted_area = 0.0;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    if (!fitted[i]) continue;
    low = std::min(low, deviation[i]);
    high = std::max(high, deviation[i]);
    fitted_area += area[i];
  }
  const Vec3 centre = ball.origin + fit.centre;
  maps.add_row({ball.joint, centre.x(), centre.y(), centre.z(), fit.radius, fit.rms, fitted.size(),
                std::ranges::count(fitted, true), fitted_area, low, high});
  write_ply_series(run.record.folder / "head_maps" / (ball.joint + ".ply"),
                   relative_to(ball.mesh, fit.centre),
                   std::vector<VertexSeries>{{"deviation", {deviation.begin(), deviation.end()}},
                                             {"fitted", {fitted.begin(), fitted.end()}}});
}

void body(DriverRun& run) {
  Result result{"head_maps",
                "Where is the ball of a joint a sphere, and how far is it from one elsewhere?",
                {{{"joint", "", "name of a hip, or folder of a real joint"},
                  {"x", "mm", "centre of the sphere, input frame"},
                  {"y", "mm", "the same"},
                  {"z", "mm", "the same"},
                  {"radius_mm", "mm", "of the sphere"},
                  {"rms_mm", "mm", "residual of the fitted vertices, weighted by their areas"},
                  {"vertices", "1", "of the ball"},
                  {"fitted", "1", "of them, those that were fitted"},
                  {"fitted_area_mm2", "mm^2", "of their faces"},
                  {"lowest_mm", "mm", "of the distances of fitted vertices from the sphere"},
                  {"highest_mm", "mm", "the same, outwards positive"}}}};
  require_writable_folder(run.record.folder / "head_maps");
  for (const char* name : {"patient_a", "patient_b"}) {
    add_map(run, {name, make_hip(hip_preset(name)).ball}, result.table);
  }
  if (run.bones) {
    for (auto& joint : read_real_joints(*run.bones, run.progress)) {
      add_map(run, {joint.subject, std::move(joint.meshes.ball), joint.centre}, result.table);
    }
  }
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"22_head_maps", "Spheres fitted to balls (Figures 38, 39, 60 and 61).", /*takes_bones=*/true}, body);
}
