// SPDX-License-Identifier: GPL-3.0-or-later
// Tables on the shape of hips: parameters against measures, and spheres fitted to balls and sockets.
#pragma once

#include <optional>
#include <string>

#include "files/csv.hpp"
#include "hip/hip_parameters.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// hip_shapes.csv: hip,side,quantity,unit,parameter,measured. A parameter that is not measured has no third
// number; the alpha angle at a clock position follows from the parameters (hip/hip_surface.hpp).
Table hip_shape_table();
// Makes the hip, measures it and adds its rows.
void add_hip_shape(Table& table, const std::string& name, const HipParameters& parameters);

// A surface to be fitted, and what is known of its sphere.
struct FitCase {
  std::string joint;             // its name
  std::string surface;           // ball or socket
  double noise = 0.0;            // standard deviation of each coordinate, mm; put on the vertices
  std::optional<Vec3> centre;    // mm
  std::optional<double> radius;  // mm
};

// head_fits.csv: joint,surface,noise_mm,triangles,vertices,vertices_used,radius_mm,rms_mm,trim_mm,
// known_radius_mm,centre_off_mm.
Table fit_table();
// Fits a sphere to the mesh, with the noise on it, and adds its row.
void add_fit(Table& table, const TriangleMesh& mesh, const FitCase& known);

}  // namespace impinge::lab
