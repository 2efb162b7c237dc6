// SPDX-License-Identifier: GPL-3.0-or-later
// The angle that is returned is the first at which the pose is impinged (detection/overlay.hpp): none before,
// in steps of a hundredth of a degree, and the overlay says yes next to it.
#include "limits/turn_contact.hpp"

#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "detection/overlay.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/bodies.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

constexpr double kStep = 0.01 * kDegree;
constexpr double kBeyond = 1e-6;  // radians past a contact, where it is deep enough to be seen in doubles

struct Scene {
  std::string name;
  BallSocketPair joint;
};

// A head on a stick, in a cup: edges, vertices and the rim come into play.
TriangleMesh head_with_neck(std::size_t faces) {
  return radial_body(faces, [](const Vec3& u) {
    const double neck = u.z() < 0.0 ? 12.0 / std::max(std::hypot(u.x(), u.y()), 1e-9) : 0.0;
    return std::max(22.0, std::min(neck, 50.0));
  });
}

// The faces with some corner above a height: a surface that ends.
TriangleMesh cut_above(TriangleMesh mesh, double height) {
  std::erase_if(mesh.faces, [&](const Face& face) {
    return std::ranges::none_of(face, [&](VertexIndex v) { return mesh.vertices[v].z() > height; });
  });
  return mesh;
}

std::vector<Scene> scenes() {
  PairShape off_centre = impinging_cam();
  off_centre.cam_azimuth_deg = 20.0;
  const TriangleMesh socket = cup(26.0, 80.0, 120);
  return {{"cam", make_ball_socket_pair(160, off_centre)},
          {"neck", {head_with_neck(300), socket}},
          {"neck that ends", {cut_above(head_with_neck(300), -20.0), socket}},
          {"octahedra", {octahedron(16.0), cut_above(octahedron(26.0), 0.5)}}};
}

bool impinged(const SurfaceOverlay& overlay, const Vec3& axis, double angle) {
  return overlay.impinged({Eigen::AngleAxisd(angle, axis).toRotationMatrix(), Vec3::Zero()});
}

TEST(TurnContact, IsTheFirstThatTheOverlaySees) {
  int found = 0;
  for (const Scene& scene : scenes()) {
    const SurfaceOverlay overlay(scene.joint.ball, scene.joint.socket);
    ASSERT_FALSE(overlay.impinged({})) << scene.name;
    const TurnParts ball(scene.joint.ball);
    const TurnParts socket(scene.joint.socket);
    for (const Vec3& axis : test::random_directions(6, 3)) {
      const TurnContacts contacts({{scene.joint.ball, ball}, {scene.joint.socket, socket}, axis, 0.0});
      const auto first = contacts.first({0.0, 2.0});
      const double clear = first ? first->angle : 2.0;
      for (double angle = 0.0; angle < clear; angle += 5.0 * kStep)
        ASSERT_FALSE(impinged(overlay, axis, angle)) << scene.name << " at " << angle << " of " << clear;
      if (!first) continue;
      ++found;
      EXPECT_FALSE(impinged(overlay, axis, clear - kBeyond)) << scene.name;
      EXPECT_TRUE(impinged(overlay, axis, clear + kBeyond)) << scene.name << " " << name(first->kind);
    }
  }
  EXPECT_GT(found, 12);
}

}  // namespace
}  // namespace impinge
