// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "hip/gap_files.hpp"
#include "mesh/ply_writer.hpp"
#include "pose_answer.hpp"

namespace impinge {
namespace {

// In the input frame, as posed.
std::vector<Vec3> posed_in_input_frame(const Session& session, const Pose& pose, Surface surface) {
  const Joint& joint = session.joint->joint;
  std::vector<Vec3> places = surface == Surface::ball ? joint.ball.mesh.vertices : joint.socket.mesh.vertices;
  for (Vec3& x : places) x = Vec3(surface == Surface::ball ? to_socket(pose, x) : x) + joint.centre;
  return places;
}

}  // namespace

std::string gaps_csv(Session& session, const PoseRequest& request) {
  const PoseAnswer found = answer_pose(session, request);
  const std::vector<Vec3> ball = posed_in_input_frame(session, found.pose, Surface::ball);
  const std::vector<Vec3> socket = posed_in_input_frame(session, found.pose, Surface::socket);
  return gaps_csv({Surface::ball, ball, found.ball.gap}, {Surface::socket, socket, found.socket.gap});
}

std::string surface_ply(Session& session, const PoseRequest& request, Surface surface) {
  const PoseAnswer found = answer_pose(session, request);
  const Joint& joint = session.joint->joint;
  const bool ball = surface == Surface::ball;
  const TriangleMesh mesh{posed_in_input_frame(session, found.pose, surface),
                          ball ? joint.ball.mesh.faces : joint.socket.mesh.faces};
  const std::vector<double>& gap = ball ? found.ball.gap : found.socket.gap;
  const std::vector<GapLevel> levels = gap_levels(surface, request.cartilage_mm);
  std::vector<Rgb> colours;
  for (const double g : gap) colours.push_back(gap_colour(g, levels));
  return ply_bytes(mesh, "gap", gap, colours);
}

}  // namespace impinge
