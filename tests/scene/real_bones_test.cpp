// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of real joints, against what their descriptions (subject.json) measured by other means. The joints
// lie beside the project: the environment variable IMPINGE_BONES names their folder. Without it there is
// nothing to compare.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/io.hpp"
#include "reference/closest_point.hpp"
#include "scene/report.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> hips() {
  std::vector<fs::path> folders;
  const char* bones = std::getenv("IMPINGE_BONES");  // NOLINT(concurrency-mt-unsafe)
  if (bones == nullptr) return folders;
  for (const auto& entry : fs::directory_iterator(bones)) {
    if (fs::exists(entry.path() / "femoral_head.ply") && fs::exists(entry.path() / "subject.json")) {
      folders.push_back(entry.path());
    }
  }
  return folders;
}

SceneOptions options_of(const fs::path& hip) {
  SceneOptions options;
  options.ball = hip / "femoral_head.ply";
  options.socket = hip / "acetabulum_facing.ply";
  return options;
}

// The description fitted a sphere to the head and measured the smallest distance between triangles of both
// bones. The smallest radial gap is over vertices and no less than that but for the decimation of the
// regions, and near it.
TEST(RealBones, CentreAndSmallestGapAreThoseOfTheDescription) {
  for (const fs::path& hip : hips()) {
    const auto subject = nlohmann::json::parse(read_bytes(hip / "subject.json"));
    const SceneOptions options = options_of(hip);
    Session session = load_joint(options);
    const Joint& joint = session.joint->joint;
    const auto& centre = subject["center_of_rotation_mm"];
    EXPECT_LT((joint.centre - Vec3(centre[0], centre[1], centre[2])).norm(), 0.35) << hip;
    EXPECT_NEAR(joint.fit->radius, subject["radius_mm"].get<double>(), 0.12) << hip;
    const auto report = summary(options, *session.joint, measure(session, options));
    const double distance = subject["pose"]["min_gap_regions_mm"];
    EXPECT_NEAR(report["smallest_gap"]["gap_mm"], distance, 0.15) << hip;
    EXPECT_EQ(report["impingement"][0]["ball"]["vertices"], 0) << hip << ": no bone touches another";
    EXPECT_GT(report["impingement"][1]["socket"]["area_mm2"], 100.0) << hip << ": 4 mm of cartilage do touch";
  }
}

// The head is found in the whole bone, too.
TEST(RealBones, CentreIsFoundInTheWholeFemur) {
  for (const fs::path& hip : hips()) {
    if (!fs::exists(hip / "femur.ply")) continue;
    const auto subject = nlohmann::json::parse(read_bytes(hip / "subject.json"));
    const SphereFit fit = fit_ball(read_mesh(hip / "femur.ply"));
    const auto& centre = subject["center_of_rotation_mm"];
    EXPECT_LT((fit.centre - Vec3(centre[0], centre[1], centre[2])).norm(), 0.35) << hip;
    EXPECT_NEAR(fit.radius, subject["radius_mm"].get<double>(), 0.12) << hip;
  }
}

// Euclidean distances of vertices all over the socket, in poses that are free and deep. Few of them, as the
// exact ones take their time; the precision of the tables plays no part.
TEST(RealBones, DistancesHoldTheExactOnes) {
  constexpr std::size_t kStride = 16;
  for (const fs::path& hip : hips()) {
    SceneOptions options = options_of(hip);
    options.side = hip.string().ends_with("left") ? Side::left : Side::right;
    options.precision_deg = 5.0;
    Session session = load_joint(options);
    const Joint& joint = session.joint->joint;
    for (const char* motion : {"flexion=0", "flexion=90,internal_rotation=20"}) {
      options.motion = parse_motion(motion);
      const Measurement found = measure(session, options);
      std::vector<Vec3> points;
      for (std::size_t i = 0; i < joint.socket.mesh.vertices.size(); i += kStride)
        points.push_back(to_ball(found.pose, joint.socket.mesh.vertices[i]));
      const std::vector<double> distance = closest_distances(joint.ball.mesh, {.points = points});
      for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_LE(found.socket.distance[kStride * i].lower_mm, distance[i]) << hip << " " << motion;
        ASSERT_GE(found.socket.distance[kStride * i].upper_mm, distance[i]) << hip << " " << motion;
      }
    }
  }
}

// Shares of directions that the description counted with its own rays.
TEST(RealBones, CoverageIsThatOfTheDescription) {
  for (const fs::path& hip : hips()) {
    const auto subject = nlohmann::json::parse(read_bytes(hip / "subject.json"));
    SceneOptions options = options_of(hip);
    const auto& centre = subject["center_of_rotation_mm"];
    options.centre = Vec3(centre[0], centre[1], centre[2]);
    Session session = load_joint(options);
    const Joint& joint = session.joint->joint;
    const auto& star = subject["star_shape"];
    EXPECT_NEAR(joint.socket.star_shape.covered, star["socket_facing"]["fraction_hit"].get<double>(), 0.005)
        << hip;
    EXPECT_NEAR(joint.socket.star_shape.violating,
                star["socket_facing"]["fraction_multi_of_all"].get<double>(), 0.001)
        << hip;
    EXPECT_NEAR(joint.ball.star_shape.covered, star["ball"]["fraction_hit"].get<double>(), 0.01) << hip;
  }
}

}  // namespace
}  // namespace impinge
