// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Which points of a socket do the two tables of the thesis sample? (Figure 49)
// @writes    sample_points sample_points_hip
// @writes-with-bones  sample_points_bones
// @timing    no
// @seconds   1 1
// @links     harness real_joints table hip thesis_forms
//
// Sockets of the generated pair and of a hip (Figure 40), and real ones if given. The tables are filled as in
// the thesis: the raster on the grid, and the helix resampled from it.

#include <cmath>

#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/thesis_fills.hpp"
#include "sphere/schemes/usid.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr double kPrecision = 1.0;         // degrees, as in the figure
constexpr std::size_t kTriangles = 12000;  // of the generated socket
constexpr double kDigits = 1e4;            // points are rounded to 1e-4 mm
constexpr const char* kHip = "patient_a";  // stand-in for the patient in the figure

// A socket and its position.
struct Socket {
  std::vector<Cell> key;  // the subject, if there is one
  TriangleMesh mesh;      // in the centre frame, mm
  Vec3 centre = Vec3::Zero();
};

// Adds the points of the surface at those entries that have one, in the input frame.
template <SamplingScheme S>
void add_points(const Socket& socket, const RadialTable<S>& table, Table& points) {
  for (std::size_t i = 0; i < table.radii().size(); ++i) {
    if (std::isnan(table.radii()[i])) continue;
    const Vec3 point = socket.centre + table.radii()[i] * table.scheme().direction(i);
    const Vec3 x = (kDigits * point).array().round() / kDigits;
    std::vector<Cell> row = socket.key;
    row.insert(row.end(), {S::name, i, x.x(), x.y(), x.z()});
    points.add_row(std::move(row));
  }
}

void write_points(DriverRun& run, const char* name, std::vector<Column> columns,
                  const std::vector<Socket>& sockets) {
  Result result{name, "Which points of a socket do the two tables of the thesis sample?"};
  columns.insert(columns.end(), {{"scheme", "", "name of the sampling scheme"},
                                 {"entry", "1", "its number in the table"},
                                 {"x", "mm", "point of the surface, input frame"},
                                 {"y", "mm", "the same"},
                                 {"z", "mm", "the same; the pole of the tables is on +z of the centre"}});
  result.table.columns = std::move(columns);
  result.parameters = {{"precision_deg", kPrecision}};
  const Rsid rsid = Rsid::with_precision(kPrecision);
  const Usid usid = Usid::with_precision(kPrecision);
  for (const Socket& socket : sockets) {
    add_points(socket, fill_thesis(socket.mesh, rsid, Layer::nearest), result.table);
    add_points(socket, fill_resampled(socket.mesh, usid, Layer::nearest), result.table);
    result.parameters["centres"].push_back({socket.centre.x(), socket.centre.y(), socket.centre.z()});
  }
  run.write(result);
}

void body(DriverRun& run) {
  write_points(run, "sample_points", {}, {{{}, make_ball_socket_pair(kTriangles).socket}});
  Hip hip = make_hip(hip_preset(kHip));
  write_points(run, "sample_points_hip", {{"subject", "", "name of the hip"}},
               {{{kHip}, std::move(hip.socket)}});
  if (!run.bones) return;
  std::vector<Socket> sockets;
  for (auto& joint : read_real_joints(*run.bones, run.progress)) {
    sockets.push_back({{joint.subject}, std::move(joint.meshes.socket), joint.centre});
  }
  write_points(run, "sample_points_bones", {{"subject", "", "folder of the joint"}}, sockets);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"14_sample_points", "Points that the thesis' tables sample (Figure 49).", /*takes_bones=*/true}, body);
}
