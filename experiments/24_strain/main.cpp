// SPDX-License-Identifier: GPL-3.0-or-later
// @question  What does a gap say about the strain of the cartilage? ("approximate strain", Section 3.4)
// @writes    strain_layer strain_incidence strain_hip
// @timing    no
// @seconds   1 4
// @links     harness gap hip reference GSL::gsl
//
// Compares strain by gap (overlap divided by thickness) with the linear elastic solution of a layer between
// rigid spheres, by Poisson ratio and thickness; along oblique rays; and by hours in impinged hips.

#include "24_strain/strain_study.hpp"
#include "harness/driver.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr double kPoisson[] = {0.0, 0.3, 0.45, 0.49, 0.5};
constexpr double kThickness[] = {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0};  // over the radius of contact
constexpr double kGaps[] = {1.0, 2.0, 3.0};                                  // mm
// The ends of the recorded motions in which the stand-ins are impinged (Table 11), and a cam in flexion.
constexpr const char* kPoses[][2] = {{"patient_a", "flexion=103.1"},
                                     {"patient_b", "flexion=115.8"},
                                     {"cam", "flexion=90,internal_rotation=10"}};

void body(DriverRun& run) {
  Table layers = layer_table();
  for (const double poisson : kPoisson)
    for (const double thickness : kThickness) add_layer(layers, poisson, thickness);
  run.write({"strain_layer",
             "How far is strain by gap from that of an elastic layer?",
             std::move(layers),
             {{"layer", "linear, bonded to rigid bone, no friction, a rigid sphere"}}});
  ObliqueJoint joint;
  if (run.quick()) joint.faces = 6000;
  Table incidence = incidence_table();
  for (const double gap : kGaps) {
    joint.gap = gap;
    add_incidence(incidence, joint);
  }
  run.write({"strain_incidence",
             "What do oblique rays do to strain by gap?",
             std::move(incidence),
             {{"ball_radius_mm", joint.ball_radius}, {"off", joint.off}, {"faces", joint.faces}}});
  Table hips = hip_strain_table();
  StrainedHip hip;
  if (run.quick()) hip.faces = 3000;
  for (const auto& [preset, pose] : kPoses) {
    hip.preset = preset;
    hip.pose = pose;
    add_hip_strain(hips, hip);
  }
  run.write({"strain_hip",
             "How strained is the cartilage of an impinged hip, and where?",
             std::move(hips),
             {{"cartilage_mm", hip.cartilage}, {"thicker", kThicker}, {"faces", hip.faces}}});
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv, {"24_strain", "What a gap says about strain (Section 3.4)."},
                                  body);
}
