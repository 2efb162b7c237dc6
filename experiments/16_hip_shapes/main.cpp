// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Do generated hips have their parameters, and is the centre of a joint found without a hand?
// @writes    hip_shapes head_fits
// @bones     yes
// @timing    no
// @seconds   2 3
// @links     harness real_joints hip
//
// Every preset measured from its meshes alone; the sphere fitted to every ball and socket, with noise and on
// real joints (Section 3.4, Figures 38 and 39).

#include <string>
#include <utility>

#include "16_hip_shapes/hip_study.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/hip_surface.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr double kNoises[] = {0.0, 0.1, 0.3, 0.5};  // mm; segmented bone is right to some tenths

void add_preset_fits(Table& fits, const std::string& name) {
  HipParameters p = hip_preset(name);
  p.side = Side::right;
  const HipSurface surface = hip_surface(p);
  const Hip hip = make_hip(p);
  for (const double noise : kNoises) {
    add_fit(fits, hip.ball, {name, "ball", noise, Vec3::Zero(), surface.head_radius});
    add_fit(fits, hip.socket, {name, "socket", noise, surface.socket_centre, surface.socket_radius});
  }
}

void write(DriverRun& run, const char* name, const char* question, Table table) {
  run.write({name,
             question,
             std::move(table),
             {{"faces", kHipFaces},
              {"alpha_share", kAlphaShare},
              {"patients", "stand-ins: the scans of the thesis' patients are not public"}}});
}

void body(DriverRun& run) {
  Table shapes = hip_shape_table();
  Table fits = fit_table();
  for (const std::string_view preset : hip_preset_names()) {
    const std::string name(preset);
    add_hip_shape(shapes, name, hip_preset(name));
    add_preset_fits(fits, name);
  }
  if (run.bones) {
    for (const RealJoint& joint : read_real_joints(*run.bones, run.progress)) {
      const auto centre = joint.described ? std::optional<Vec3>(Vec3::Zero()) : std::nullopt;
      add_fit(fits, joint.meshes.ball, {joint.subject, "ball", 0.0, centre, joint.radius});
      add_fit(fits, joint.meshes.socket, {joint.subject, "socket", 0.0, std::nullopt, std::nullopt});
    }
  }
  write(run, "hip_shapes", "Do generated hips have their parameters?", std::move(shapes));
  write(run, "head_fits", "Is the sphere of a ball or socket found without a hand?", std::move(fits));
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"16_hip_shapes", "Parameters and measures of hips, and fitted spheres.", /*takes_bones=*/true}, body);
}
