// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/exact_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace impinge::lab {
namespace {

// A table that is not of this joint is wrong nearly everywhere. A right one is off by more than a millimetre
// next to steep faces of a coarse mesh, and has no answer at the rim.
constexpr double kNear = 1.0;       // mm
constexpr double kLeastNear = 0.9;  // of the vertices that face the other surface

// Of the gaps of one pose.
struct Misfit {
  double largest = 0.0;   // error, mm
  std::size_t faced = 0;  // vertices that meet the other surface
  std::size_t near = 0;   // of these, whose gap is answered and near the exact one
};

void add_misfit(Misfit& misfit, const std::vector<float>& gaps, const std::vector<double>& exact) {
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (std::isnan(exact[i])) continue;
    ++misfit.faced;
    if (std::isnan(gaps[i])) continue;
    const double error = std::abs(static_cast<double>(gaps[i]) - exact[i]);
    if (error < kNear) ++misfit.near;
    misfit.largest = std::max(misfit.largest, error);
  }
}

}  // namespace

bool any_impinged(const CulledJoint& joint, const Pose& pose) {
  return std::ranges::any_of(kSurfaces, [&](Surface scanned) {
    return std::ranges::any_of(mesh_of(joint.meshes(), scanned).vertices, [&](const Vec3& x) {
      return joint.exactly_impinged(scanned, to_other(scanned, pose, x));
    });
  });
}

ExactGaps exact_gaps(const CulledJoint& joint, const Pose& pose) {
  ExactGaps gaps;
  for (const Vec3& v : joint.meshes().ball.vertices)
    gaps.ball.push_back(joint.gap(Surface::ball, to_socket(pose, v)));
  for (const Vec3& v : joint.meshes().socket.vertices)
    gaps.socket.push_back(joint.gap(Surface::socket, to_ball(pose, v)));
  return gaps;
}

double gap_error(const MadeContact& made, const ExactGaps& exact, const Pose& pose) {
  const JointGaps& gaps = made.query->gaps(pose);
  Misfit misfit;
  add_misfit(misfit, gaps.ball, exact.ball);
  add_misfit(misfit, gaps.socket, exact.socket);
  if (static_cast<double>(misfit.near) < kLeastNear * static_cast<double>(misfit.faced)) {
    throw std::runtime_error(made.method.name + ": only " + std::to_string(misfit.near) + " of " +
                             std::to_string(misfit.faced) +
                             " gaps are near the exact ones: its time means nothing until that is resolved");
  }
  return misfit.largest;
}

}  // namespace impinge::lab
