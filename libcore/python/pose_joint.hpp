// SPDX-License-Identifier: GPL-3.0-or-later
// A joint with the tables that its questions need, made at first use. Several threads may ask at once.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <pybind11/pytypes.h>

#include "gap/simd/exact_cells.hpp"
#include "gap/simd/joint_scan.hpp"
#include "joint/joint_document.hpp"
#include "joint/poses.hpp"
#include "joint/rest_contact.hpp"

namespace impinge::python {

using PoseTable = PackedTable<CubeGnomonic, std::uint16_t>;  // answers questions that ask for a precision

class PoseJoint {
 public:
  PoseJoint(Session session, JointNames names) : names_(std::move(names)), session_(std::move(session)) {
    warn_of_contact(*session_.joint, {.overlap = "ignore_rest_contact=True"});
  }
  PoseJoint(const PoseJoint&) = delete;
  PoseJoint& operator=(const PoseJoint&) = delete;

  const SessionJoint& joint() const { return *session_.joint; }
  SessionJoint& joint() { return *session_.joint; }
  const JointNames& names() const { return names_; }

  /// What pickle keeps; the joint can be made again from it.
  pybind11::tuple made_of;

  /// The exact cells of the faces, and tables of `cube_gnomonic` in 16 bits at a precision in degrees. They
  /// are made without Python's lock, which must be held.
  const PackedJoint<ExactCells>& cells();
  const PackedJoint<PoseTable>& tables(double precision_deg);

  /// These serve one call at a time; a second thread waits. They are called without Python's lock.
  PoseRow row(PosesOutput output, const Pose& pose);
  /// work(joint).
  template <class Work>
  auto alone(const Work& work) {
    const std::scoped_lock lock(busy_);
    return work(*session_.joint);
  }
  double cartilage_of_scan() {
    return alone([](SessionJoint& joint) { return impinge::cartilage_of_scan(joint, "cartilage_of_scan"); });
  }
  template <class Request, class... How>
  auto ask(const Request& request, const How&... how) {
    const std::scoped_lock lock(busy_);
    return answer(session_, request, how...);
  }

 private:
  std::mutex busy_;   // held while something is made, or kept things are used
  JointNames names_;  // names of its meshes in documents
  Session session_;
  BallSocketPair cells_of_;  // meshes that the cells refer to
  std::unique_ptr<const PackedJoint<ExactCells>> cells_;
  std::map<double, std::unique_ptr<const PackedJoint<PoseTable>>> tables_;  // by precision
  std::map<PosesOutput, std::unique_ptr<PoseSeries>> series_;
};

}  // namespace impinge::python
