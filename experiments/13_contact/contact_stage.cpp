// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_contact/contact_stage.hpp"

#include <algorithm>
#include <stdexcept>

#include "mesh/generated_pair.hpp"
#include "methods/fcl_obb.hpp"
#include "methods/vtk_collision.hpp"

namespace impinge::lab {
namespace {

constexpr double kExactTests = 3e5;  // vertices looked at for each joint and case, to compare

// The exact test of every vertex.
bool any_impinged(const ContactStage& stage, const Pose& pose) {
  return std::ranges::any_of(stage.pair.ball.vertices,
                             [&](const Vec3& x) {
                               return stage.culled.exactly_impinged(Surface::ball, to_socket(pose, x));
                             }) ||
         std::ranges::any_of(stage.pair.socket.vertices, [&](const Vec3& y) {
           return stage.culled.exactly_impinged(Surface::socket, to_ball(pose, y));
         });
}

}  // namespace

ContactStage::ContactStage(std::size_t triangles)
    : pair(make_ball_socket_pair(triangles)),
      culled(pair),
      coherent(culled),
      fcl(make_fcl_obb(pair.ball, pair.socket)),
      distance(pair.ball, pair.socket),
      vtk(make_vtk_collision(pair.ball, pair.socket)),
      scans(pair) {}

std::map<std::string, double> compare(ContactStage& stage, const std::vector<Pose>& poses) {
  std::map<std::string, double> largest;
  const auto vertices =
      static_cast<double>(stage.pair.ball.vertices.size() + stage.pair.socket.vertices.size());
  const auto most = static_cast<std::size_t>(kExactTests / vertices) + 1;
  const std::size_t stride = std::max<std::size_t>(1, poses.size() / most);
  for (std::size_t k = 0; k < poses.size(); k += stride) {
    const bool truth = any_impinged(stage, poses[k]);
    const auto least = stage.culled.least_gap(poses[k]);
    if (stage.culled.impinged(poses[k]).has_value() != truth || (least && least->gap_mm <= 0.0) != truth)
      throw std::runtime_error(
          "a culled answer is not that of all vertices: its time means nothing until that is resolved");
    if (stage.vtk->touches(poses[k]) != stage.fcl->touches(poses[k]))
      throw std::runtime_error(
          "VTK and FCL differ on a contact: their times mean nothing until that is resolved");
    for (const auto& [method, error] : scan_errors(stage.scans, stage.culled, poses[k]))
      largest[method] = std::max(largest[method], error);
  }
  return largest;
}

}  // namespace impinge::lab
