// SPDX-License-Identifier: GPL-3.0-or-later
#include "19_slices_to_surface/slices_tables.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace impinge::lab {
namespace {

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

}  // namespace

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

void add_stages(Table& table, double slice_mm, const SlicesResult& result) {
  for (const StageError& stage : result.stages) {
    table.add_row({slice_mm, stage.stage, stage.ball_faces, stage.socket_faces, stage.directions,
                   stage.missed, stage.mean_mm, stage.rms_mm, stage.largest_mm, stage.added_rms_mm,
                   1e3 * result.centre.norm()});
  }
}

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

}  // namespace impinge::lab
