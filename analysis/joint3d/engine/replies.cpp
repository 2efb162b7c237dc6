// SPDX-License-Identifier: GPL-3.0-or-later
#include "replies.hpp"

#include "catalogue.hpp"
#include "hip/rim_line.hpp"
#include "requests.hpp"

namespace impinge {
namespace {

constexpr std::size_t kRimSectors = 96;

val mesh_value(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (const Face& face : mesh.faces) corners.insert(corners.end(), face.begin(), face.end());
  return object(std::pair("positions", float_array(mesh.vertices)), std::pair("faces", typed_array(corners)));
}

// Column by column, as WebGL has it.
val matrix_value(const Eigen::Matrix3d& rotation, const Vec3& translation) {
  std::vector<float> numbers(16, 0.0F);
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      const auto i = static_cast<Eigen::Index>(row);
      const double value = column < 3 ? rotation(i, static_cast<Eigen::Index>(column)) : translation[i];
      numbers[4 * column + row] = static_cast<float>(value);
    }
  }
  numbers[15] = 1.0F;
  return typed_array(numbers);
}

val rim_value(const SessionJoint& joint) {
  std::vector<Vec3> places;
  std::vector<double> hours;
  if (joint.dial) {
    TriangleMesh socket = main_surface(joint.joint.socket.mesh, joint.joint.socket.parts);
    socket.vertices = mapped(joint.axes, socket.vertices);
    for (const RimPoint& at : rim_line(socket, *joint.dial, kRimSectors)) {
      places.emplace_back(joint.axes.transpose() * at.place);
      hours.push_back(at.hours);
    }
  }
  return object(std::pair("positions", float_array(places)), std::pair("hours", float_array(hours)));
}

// As they stand in the socket, about whose centre a page draws.
std::vector<float> in_socket(std::vector<float> points, const Vec3& shift) {
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] += static_cast<float>(shift[static_cast<Eigen::Index>(k % 3)]);
  return points;
}

// What of a whole bone is the surface of the joint.
val taken_value(const JointPart& part) {
  if (!part.taken) return val::null();
  return object(std::pair("faces", static_cast<double>(part.taken->faces)),
                std::pair("of", static_cast<double>(part.taken->of)),
                std::pair("within_mm", part.taken->within_mm));
}

val frames_value(const std::optional<AnatomicalFrames>& frames) {
  if (!frames) return val::null();
  const auto& scanned = frames->scanned;
  return object(
      std::pair("pelvic_tilt_deg", frames->pelvic_tilt_deg),
      std::pair("scanned_deg", scanned ? val::array(std::vector<double>{scanned->flexion, scanned->abduction,
                                                                        scanned->internal_rotation})
                                       : val::null()));
}

}  // namespace

val joint_reply(const SessionJoint& joint) {
  const Joint& found = joint.joint;
  const val fit =
      found.fit ? object(std::pair("residual_mm", found.fit->rms), std::pair("radius_mm", found.fit->radius),
                         std::pair("points", static_cast<double>(found.fit->points)))
                : val::null();
  const val rim = rim_value(joint);
  return object(std::pair("axes", found.axes), std::pair("ball", mesh_value(found.ball.mesh)),
                std::pair("socket", mesh_value(found.socket.mesh)), std::pair("centre", point(found.centre)),
                std::pair("fit", fit), std::pair("side", val_of(json_of(joint.side))),
                std::pair("rim_clock", rim["positions"]), std::pair("rim_hours", rim["hours"]),
                std::pair("to_joint_frame", matrix_value(joint.axes, Vec3::Zero())),
                std::pair("parameters", joint.parameters ? parameters_value(*joint.parameters) : val::null()),
                std::pair("taken", object(std::pair("ball", taken_value(found.ball)),
                                          std::pair("socket", taken_value(found.socket)))),
                std::pair("frames", frames_value(found.frames)),
                std::pair("warnings", list(found.warnings, [](const std::string& w) { return val(w); })),
                std::pair("doubts", static_cast<double>(found.doubts)));
}

val tables_reply(const SessionTables& tables) {
  const TableSettings& settings = tables.settings;
  const double bytes = static_cast<double>(tables.ball->bytes() + tables.socket->bytes());
  return object(std::pair("scheme", settings.scheme), std::pair("precision_deg", settings.precision_deg),
                std::pair("storage", text(kStorages[static_cast<std::size_t>(settings.storage)])),
                std::pair("entries", static_cast<double>(tables.ball->entries())), std::pair("bytes", bytes),
                std::pair("fill_ms", tables.fill_ms), std::pair("error_mm", or_null(tables.error_mm)));
}

val points_reply(const Session& session) {
  const TableSettings& settings = session.tables.settings;
  const SessionJoint& joint = *session.joint;
  return object(
      std::pair("entries", static_cast<double>(session.tables.ball->entries())),
      std::pair("ball", typed_array(sample_points(settings, joint.main(Surface::ball), Layer::farthest))),
      std::pair("socket",
                typed_array(in_socket(sample_points(settings, joint.main(Surface::socket), Layer::nearest),
                                      joint.shift))));
}

val verdicts_reply(const PoseVerdicts& found) {
  const auto count = [](std::size_t n) { return static_cast<double>(n); };
  return object(
      std::pair("clear", count(found.vertices.clear)), std::pair("impinged", count(found.vertices.impinged)),
      std::pair("undecided", count(found.vertices.undecided)), std::pair("unbounded", count(found.unbounded)),
      std::pair("largest_mm", found.largest_mm), std::pair("median_mm", found.median_mm),
      std::pair("low_mm", number_or_null(found.smallest.low)),
      std::pair("high_mm", number_or_null(found.smallest.high)),
      std::pair("measured", count(found.smallest.measured)));
}

val pose_reply(const SessionJoint& joint, const GapsAnswer& found) {
  val reply = val_of(json_of(found));
  reply.set("ball_gap", float_array(found.ball.gap));
  reply.set("socket_gap", float_array(found.socket.gap));
  reply.set("matrix", matrix_value(found.pose.rotation, found.pose.translation));
  reply.set("ms", found.scan_ms);
  if (const auto& gap = found.smallest_gap) reply.set("place", point(gap->position - joint.joint.centre));
  return reply;
}

}  // namespace impinge
