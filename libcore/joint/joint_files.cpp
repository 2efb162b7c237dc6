// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/joint_files.hpp"

#include <vector>

#include "files/csv.hpp"
#include "hip/gap_files.hpp"
#include "joint/pose_answer.hpp"

namespace impinge {
namespace {

std::vector<Vec3> in_input_frame(const SessionJoint& joint, const GapsAnswer& found, Surface surface) {
  std::vector<Vec3> places = posed_places(joint, found.pose, surface);
  for (Vec3& x : places) x += joint.joint.centre;
  return places;
}

}  // namespace

std::string gaps_csv(const SessionJoint& joint, const GapsAnswer& found) {
  const std::vector<Vec3> ball = in_input_frame(joint, found, Surface::ball);
  const std::vector<Vec3> socket = in_input_frame(joint, found, Surface::socket);
  return gaps_csv({Surface::ball, ball, found.ball.gap}, {Surface::socket, socket, found.socket.gap});
}

std::string distances_csv(const GapsAnswer& found) {
  Table table;
  table.columns = {
      {"surface", "", "ball or socket"},
      {"vertex", "1",
       "place in ball.ply or socket.ply: that of the input mesh after welding, unless it is a whole bone"},
      {"gap_mm", "mm", "radial, as in gaps.csv"},
      {"distance_lower_mm", "mm", "Euclidean distance from the other surface, lower end"},
      {"distance_upper_mm", "mm", "upper end"}};
  for (const Surface surface : kSurfaces) {
    const SurfaceAnswer& of = found.of(surface);
    for (std::size_t i = 0; i < of.distance.size(); ++i)
      table.add_row({name(surface), i, of.gap[i], of.distance[i].lower_mm, of.distance[i].upper_mm});
  }
  return to_csv(table);
}

std::string surface_file(const SessionJoint& joint, const GapsAnswer& found, Surface surface,
                         const std::function<std::string(const TriangleMesh&, const MeshNotes&)>& write) {
  const SurfaceAnswer& answer = found.of(surface);
  const TriangleMesh mesh{in_input_frame(joint, found, surface), joint.bone(surface).mesh.faces};
  const std::vector<GapLevel> levels = gap_levels(surface, found.touching);
  std::vector<double> overlap;
  for (const double gap : answer.gap) overlap.push_back(gap >= 0.0 ? 0.0 : -gap);
  MeshNotes notes{.axes = joint.joint.axes, .values = {{"gap", answer.gap}, {"radial_overlap", overlap}}};
  for (const double gap : answer.against_cartilage) notes.colours.push_back(gap_colour(gap, levels));
  return write(mesh, notes);
}

}  // namespace impinge
