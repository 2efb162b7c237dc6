// SPDX-License-Identifier: GPL-3.0-or-later
#include "16_hip_shapes/hip_study.hpp"

#include <map>
#include <random>
#include <string_view>

#include "hip/hip.hpp"
#include "hip/hip_measures.hpp"
#include "hip/hip_surface.hpp"

namespace impinge::lab {
namespace {

constexpr std::uint64_t kNoiseSeed = 16;

Cell cell(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

using Measured = std::map<std::string_view, std::optional<double>>;

Measured measured_values(const HipParameters& p, const FemurMeasures& femur,
                         const AcetabulumMeasures& socket) {
  Vec3 shift = socket.socket.centre - femur.head.centre;
  if (p.side == Side::left) shift.x() = -shift.x();
  return {{"head_radius", femur.head.radius},
          {"head_neck_offset", femur.head_neck_offset},
          {"neck_shaft_angle", femur.neck_shaft_angle},
          {"femoral_torsion", femur.femoral_torsion},
          {"joint_space", socket.socket.radius - femur.head.radius},
          {"inclination", socket.inclination},
          {"version", socket.version},
          {"half_opening", socket.half_opening},
          {"lateral_centre_edge", socket.lateral_centre_edge},
          {"shift_lateral", shift.x()},
          {"shift_anterior", shift.y()},
          {"shift_superior", shift.z()}};
}

}  // namespace

Table hip_shape_table() {
  Table table;
  table.columns = {{"hip", "", "name of the preset"},
                   {"side", "", "left or right"},
                   {"quantity", "", "parameter, or alpha_H: the alpha angle at H o'clock about the neck"},
                   {"unit", "", "of the two numbers; h are hours of a clock"},
                   {"parameter", "as in unit", "that the meshes were made from, or what follows from them"},
                   {"measured", "as in unit", "from the meshes alone; empty where it is not measured"}};
  return table;
}

void add_hip_shape(Table& table, const std::string& name, const HipParameters& parameters) {
  const Hip hip = make_hip(parameters);
  const FemurMeasures femur = measure_femur(hip.ball, parameters.side);
  const AcetabulumMeasures socket = measure_acetabulum(hip.socket, femur.head, parameters.side);
  const Measured measured = measured_values(parameters, femur, socket);
  const std::string side = parameters.side == Side::left ? "left" : "right";
  for (const HipParameter& p : hip_parameter_list()) {
    const auto found = measured.find(p.name);
    table.add_row({name, side, p.name, p.unit, parameters.*p.value,
                   found == measured.end() ? Cell() : cell(found->second)});
  }
  HipParameters right = parameters;
  right.side = Side::right;
  const HipSurface surface = hip_surface(right);
  for (std::size_t h = 0; h < kClockHours; ++h) {
    table.add_row({name, side, "alpha_" + std::to_string(h == 0 ? 12 : h), "deg",
                   alpha_angle_deg(surface, static_cast<double>(h)), femur.alpha[h]});
  }
}

Table fit_table() {
  Table table;
  table.columns = {{"joint", "", "preset, or folder of a real joint"},
                   {"surface", "", "ball or socket"},
                   {"noise_mm", "mm", "standard deviation put on each coordinate"},
                   {"triangles", "1", "of the mesh"},
                   {"vertices", "1", "of the mesh"},
                   {"vertices_used", "1", "in the spherical region"},
                   {"radius_mm", "mm", "of the fitted sphere"},
                   {"rms_mm", "mm", "residual over the region, by area"},
                   {"trim_mm", "mm", "largest residual in the region"},
                   {"known_radius_mm", "mm", "parameter, or the joint's own description; empty if unknown"},
                   {"centre_off_mm", "mm", "distance from the known centre; empty if unknown"}};
  return table;
}

void add_fit(Table& table, const TriangleMesh& mesh, const FitCase& known) {
  TriangleMesh noisy = mesh;
  std::mt19937_64 random(kNoiseSeed);
  std::normal_distribution<double> error(0.0, known.noise > 0.0 ? known.noise : 1.0);
  if (known.noise > 0.0) {
    for (Vec3& v : noisy.vertices) {
      for (double& x : v) x += error(random);
    }
  }
  const SphereFit fit = fit_ball(noisy);
  table.add_row({known.joint, known.surface, known.noise, mesh.faces.size(), mesh.vertices.size(), fit.points,
                 fit.radius, fit.rms, fit.trim, cell(known.radius),
                 known.centre ? Cell((fit.centre - *known.centre).norm()) : Cell()});
}

}  // namespace impinge::lab
