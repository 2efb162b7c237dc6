// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/scene.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "hip/rim_line.hpp"

namespace impinge {
namespace {

static_assert(std::endian::native == std::endian::little, "as the arrays of a browser are");

std::string base64(const std::string& bytes) {
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = at; k < at + 3; ++k)
      three = three << 8U | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += at + k <= bytes.size() ? kLetters[three >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

template <class T>
std::string array_text(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return base64(bytes);
}

std::string places_text(const std::vector<Vec3>& places) {
  std::vector<float> numbers;
  for (const Vec3& x : places)
    for (const double number : x) numbers.push_back(static_cast<float>(number));
  return array_text(numbers);
}

Json mesh_of(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (const Face& face : mesh.faces) corners.insert(corners.end(), face.begin(), face.end());
  return {{"positions", places_text(mesh.vertices)}, {"faces", array_text(corners)}};
}

std::string gaps_text(const SurfaceAnswer& found) {
  return array_text(std::vector<float>(found.against_cartilage.begin(), found.against_cartilage.end()));
}

Json joint_of(const SessionJoint& joint) {
  const DrawnRim rim = drawn_rim(joint);
  const auto& fit = joint.joint.fit;
  return {{"ball", mesh_of(joint.joint.ball.mesh)},
          {"socket", mesh_of(joint.joint.socket.mesh)},
          {"side", json_of(joint.side)},
          {"fit", fit ? Json{{"radius_mm", fit->radius}} : Json()},
          {"to_joint_frame", json_of(drawn_matrix(joint.axes, Vec3::Zero()))},
          {"rim_clock", places_text(rim.places)},
          {"rim_hours", array_text(rim.hours)}};
}

}  // namespace

DrawnRim drawn_rim(const SessionJoint& joint) {
  constexpr std::size_t kRimSectors = 96;
  DrawnRim rim;
  if (!joint.dial) return rim;
  for (const RimPoint& at :
       rim_line(in_joint_frame(joint, joint.joint.socket.main()), *joint.dial, kRimSectors)) {
    rim.places.emplace_back(joint.axes.transpose() * at.place);
    rim.hours.push_back(static_cast<float>(at.hours));
  }
  return rim;
}

std::array<double, 16> drawn_matrix(const Eigen::Matrix3d& rotation, const Vec3& translation) {
  std::array<double, 16> numbers{};
  Eigen::Map<Eigen::Matrix4d> matrix(numbers.data());
  matrix.setIdentity();
  matrix.topLeftCorner<3, 3>() = rotation;
  matrix.topRightCorner<3, 1>() = translation;
  return numbers;
}

Json report_scene(const SessionJoint& joint, const GapsAnswer& found) {
  const auto& smallest = found.smallest_gap;
  return {{"joint", joint_of(joint)},
          {"pose",
           {{"matrix", json_of(drawn_matrix(found.pose.rotation, found.pose.translation))},
            {"ball_gap", gaps_text(found.ball)},
            {"socket_gap", gaps_text(found.socket)},
            {"smallest_gap", json_of(smallest)},
            {"place", smallest ? json_of(Vec3(smallest->position - joint.joint.centre)) : Json()},
            {"colours", json_of(found.colours())}}}};
}

}  // namespace impinge
