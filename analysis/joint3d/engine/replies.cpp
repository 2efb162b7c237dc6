// SPDX-License-Identifier: GPL-3.0-or-later
#include "replies.hpp"

#include "joint/joint_document.hpp"
#include "joint/touch.hpp"
#include "joint/volume_map.hpp"
#include "report/scene.hpp"
#include "requests.hpp"

namespace impinge {
namespace {

void set_mesh(std::span<const Vec3> places, std::span<const Face> faces, val& reply) {
  reply.set("positions", float_array(places));
  reply.set("faces", index_array(faces));
}

}  // namespace

val joint_reply(const SessionJoint& joint) {
  const Joint& found = joint.joint;
  const auto& fit = found.fit;
  val reply = val_of(
      {{"axes", found.axes},
       {"centre", json_of(found.centre)},
       {"fit",
        fit ? Json{{"residual_mm", fit->rms}, {"radius_mm", fit->radius}, {"points", fit->points}} : Json()},
       {"side", json_of(joint.side)},
       {"parameters", joint.parameters ? parameters_document(*joint.parameters) : Json()},
       {"taken", {{"ball", json_of(found.ball.taken)}, {"socket", json_of(found.socket.taken)}}},
       {"frames", json_of(found.frames)},
       {"warnings", found.warnings},
       {"doubts", found.doubts}});
  for (const Surface of : kSurfaces) {
    const TriangleMesh& mesh = (of == Surface::ball ? found.ball : found.socket).mesh;
    val drawn = val::object();
    set_mesh(mesh.vertices, mesh.faces, drawn);
    reply.set(std::string(name(of)), drawn);
  }
  const DrawnRim rim = drawn_rim(joint);
  reply.set("rim_clock", float_array(rim.places));
  reply.set("rim_hours", typed_array<float>(rim.hours));
  reply.set("to_joint_frame", float_array(drawn_matrix(joint.axes, Vec3::Zero())));
  return reply;
}

Json tables_reply(const SessionTables& tables) {
  Json reply = json_of(tables.settings);
  reply.update({{"entries", tables.ball->entries()},
                {"bytes", tables.ball->bytes() + tables.socket->bytes()},
                {"fill_ms", tables.fill_ms},
                {"error_mm", json_of(tables.error_mm)}});
  return reply;
}

val points_reply(const Session& session) {
  const TableSettings& settings = session.tables.settings;
  const SessionJoint& joint = *session.joint;
  std::vector<float> socket = sample_points(settings, joint.main(Surface::socket), Layer::nearest);
  for (std::size_t k = 0; k < socket.size(); ++k)  // about the centre of the socket, where a page draws
    socket[k] += static_cast<float>(joint.shift[static_cast<Eigen::Index>(k % 3)]);
  val reply = val_of({{"entries", session.tables.ball->entries()}});
  reply.set("ball", typed_array<float>(sample_points(settings, joint.main(Surface::ball), Layer::farthest)));
  reply.set("socket", typed_array<float>(socket));
  return reply;
}

Json verdicts_reply(const PoseVerdicts& found) {
  Json reply = json_of(found);
  reply.update({{"clear", found.vertices.clear},
                {"impinged", found.vertices.impinged},
                {"undecided", found.vertices.undecided}});
  return reply;
}

val pose_reply(const SessionJoint& joint, const GapsAnswer& found) {
  val reply = val_of(json_of(found));
  reply.set("ball_gap", float_array(found.ball.gap));
  reply.set("socket_gap", float_array(found.socket.gap));
  reply.set("matrix", float_array(drawn_matrix(found.pose.rotation, found.pose.translation)));
  reply.set("ms", found.scan_ms);
  if (const auto& gap = found.smallest_gap)
    reply.set("place", val_of(json_of(Vec3(gap->position - joint.joint.centre))));
  return reply;
}

void add_arrays(const SessionJoint& joint, const ResectAnswer& found, val& reply) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // the ball is drawn as landmarks have turned it
  if (found.surface == Surface::ball) turn = scanned_pose(joint).rotation.transpose();
  std::vector<Vec3> places = found.mesh.vertices;
  for (Vec3& x : places) x = turn * (x - joint.joint.centre);
  set_mesh(places, found.mesh.faces, reply);
  reply.set("depth", float_array(found.depth));
}

void add_arrays(const SessionJoint& /*joint*/, const OrientAnswer& found, val& reply) {
  std::vector<double> squares;
  for (const OrientationCell& cell : found.cells)
    squares.insert(squares.end(),
                   {cell.middle.inclination_deg, cell.middle.anteversion_deg, cell.half_deg,
                    static_cast<double>(cell.state), cell.leg ? static_cast<double>(*cell.leg) : -1.0});
  reply.set("squares", float_array(squares));
}

void add_arrays(const SessionJoint& joint, const VolumeAnswer& found, val& reply) {
  std::vector<double> ranges;
  for (int flexion = kMapExtension; flexion < kMapFlexion; flexion += kMapStep) {
    for (int abduction = -kMapAbduction; abduction < kMapAbduction; abduction += kMapStep) {
      const MapSquare square =
          map_square(found.volume, {flexion + 0.5 * kMapStep, abduction + 0.5 * kMapStep, 0.0}, joint.side);
      ranges.push_back(square.state == CellState::free      ? square.range_deg
                       : square.state == CellState::blocked ? -1.0
                                                            : -2.0);
    }
  }
  val map = val_of({{"step", kMapStep},
                    {"flexion", {kMapExtension, kMapFlexion}},
                    {"abduction", {-kMapAbduction, kMapAbduction}}});
  map.set("range_deg", float_array(ranges));
  reply.set("map", map);
}

}  // namespace impinge
