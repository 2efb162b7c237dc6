// SPDX-License-Identifier: GPL-3.0-or-later
// @question  What do a look-up and a scan do, on a real joint? (Figures 26, 27, 29 and 35)
// @writes    diagram_sections diagram_rays diagram_bodies diagram_lookups diagram_excerpt diagram_scans
// @timing    no
// @seconds   1 1
// @links     harness table gap hip thesis_forms
//
// The hip is the stand-in for the thesis' patient A (hip/hip_presets.hpp), cut by the patient's frontal
// plane.

#include "23_detection_diagrams/diagram_bodies.hpp"
#include "23_detection_diagrams/diagram_lookup.hpp"
#include "23_detection_diagrams/diagram_tables.hpp"
#include "harness/driver.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/motion.hpp"
#include "methods/thesis_raster.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr const char* kHip = "patient_a";
constexpr double kPrecision = 1.0;  // degrees, of looked-up tables
constexpr double kRayStep = 5.0;    // degrees, in sections
constexpr double kTurn = 40.0;      // degrees of abduction, Figure 35 b
constexpr double kPush = 7.0;       // mm upwards, Figure 35 c
// Flexion and internal rotation together, as when a physician tests for impingement: the bones overlap.
constexpr Motion kImpinging{.flexion = 100.0, .internal_rotation = 15.0};

struct NamedPose {
  const char* name;
  Pose pose;
};

Pose turned(const Motion& motion, const HipParameters& shape) {
  return {joint_rotation(motion, shape.side), Vec3::Zero()};
}

// Figures 26, 27 and 35: the hip in the plane y = 0 (the patient's frontal plane), a vertex looked up, and
// both scans.
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
