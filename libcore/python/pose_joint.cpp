// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/pose_joint.hpp"

#include <pybind11/gil.h>

#include "table/exact_raster.hpp"

namespace impinge::python {
namespace {

PoseTable filled(const TriangleMesh& mesh, Surface of, double precision_deg) {
  const auto scheme = CubeGnomonic::with_precision(precision_deg);
  require_packed_entries(scheme.size());
  return packed_table<std::uint16_t>(fill_exact(mesh, scheme, facing_layer(of)));
}

}  // namespace

const PackedJoint<ExactCells>& PoseJoint::cells() {
  const pybind11::gil_scoped_release released;
  const std::scoped_lock lock(busy_);
  if (!cells_) {
    cells_of_ = {joint().main(Surface::ball), joint().main(Surface::socket)};
    const auto& [ball, socket] = cells_of_;
    cells_ = std::make_unique<const PackedJoint<ExactCells>>(
        packed_joint(exact_cells(ball, facing_layer(Surface::ball)),
                     exact_cells(socket, facing_layer(Surface::socket)), ball, socket));
  }
  return *cells_;
}

const PackedJoint<PoseTable>& PoseJoint::tables(double precision_deg) {
  const pybind11::gil_scoped_release released;
  const std::scoped_lock lock(busy_);
  auto& made = tables_[precision_deg];
  if (!made) {
    const TriangleMesh ball = joint().main(Surface::ball);
    const TriangleMesh socket = joint().main(Surface::socket);
    made = std::make_unique<const PackedJoint<PoseTable>>(
        packed_joint(filled(ball, Surface::ball, precision_deg),
                     filled(socket, Surface::socket, precision_deg), ball, socket));
  }
  return *made;
}

PoseRow PoseJoint::row(PosesOutput output, const Pose& pose) {
  const std::scoped_lock lock(busy_);
  auto& series = series_[output];
  if (!series) series = std::make_unique<PoseSeries>(joint(), PosesRequest{.outputs = {output}});
  return series->answer(pose);
}

}  // namespace impinge::python
