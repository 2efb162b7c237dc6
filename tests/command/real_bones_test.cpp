// SPDX-License-Identifier: GPL-3.0-or-later
// Real joints, against what their descriptions (subject.json) measured by other means. The joints
// lie beside the project: the environment variable IMPINGE_BONES names their folder. Without it there is
// nothing to compare.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "command/joint_options.hpp"
#include "files/file_bytes.hpp"
#include "hip/measure_list.hpp"
#include "hip/sphere_fit.hpp"
#include "joint/document.hpp"
#include "joint/gaps.hpp"
#include "mesh/io.hpp"
#include "mesh/validation.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> subjects() {
  std::vector<fs::path> folders;
  const char* bones = std::getenv("IMPINGE_BONES");  // NOLINT(concurrency-mt-unsafe)
  if (bones == nullptr) return folders;
  for (const auto& entry : fs::directory_iterator(bones)) {
    if (fs::exists(entry.path() / "subject.json")) folders.push_back(entry.path());
  }
  return folders;
}

std::vector<fs::path> hips() {
  std::vector<fs::path> folders = subjects();
  std::erase_if(folders, [](const fs::path& folder) { return !fs::exists(folder / "femoral_head.ply"); });
  return folders;
}

// Of every mesh that the description knows.
TEST(RealBones, CountsAreThoseStated) {
  for (const fs::path& subject : subjects()) {
    const auto files = Json::parse(read_bytes(subject / "subject.json"))["files"];
    EXPECT_FALSE(files.empty()) << subject;
    for (const auto& [name, stated] : files.items()) {
      if (!name.ends_with(".ply")) continue;
      SCOPED_TRACE(subject / name);
      const MeshReport report = validate(read_mesh(subject / name));
      EXPECT_EQ(report.vertices, stated["vertices"]);
      EXPECT_EQ(report.faces, stated["triangles"]);
      EXPECT_EQ(report.boundary_edges, stated["boundary_edges"]);
      EXPECT_EQ(report.non_manifold_edges, stated["nonmanifold_edges"]);
      EXPECT_EQ(report.components, stated["components"]);
      EXPECT_EQ(report.degenerate_faces, stated["degenerate_triangles"]);
      ASSERT_EQ(report.volume.has_value(), !stated["signed_volume_mm3"].is_null());
      if (report.volume) {
        EXPECT_NEAR(*report.volume, stated["signed_volume_mm3"].get<double>(), 0.1);
      }
      EXPECT_EQ(report.unreferenced_vertices + report.duplicate_faces + report.non_finite_vertices, 0U);
    }
  }
}

JointOptions options_of(const fs::path& hip) {
  JointOptions options;
  options.ball = hip / "femoral_head.ply";
  options.socket = hip / "acetabulum_facing.ply";
  return options;
}

// The description fitted a sphere to the head and measured the smallest distance between triangles of both
// bones. The smallest radial gap is over vertices and no less than that but for the decimation of the
// regions, and near it.
TEST(RealBones, CentreAndSmallestGapAreThoseOfTheDescription) {
  for (const fs::path& hip : hips()) {
    const auto subject = Json::parse(read_bytes(hip / "subject.json"));
    const JointOptions options = options_of(hip);
    Session session = load_joint(options, {});
    const Joint& joint = session.joint->joint;
    const auto& centre = subject["center_of_rotation_mm"];
    EXPECT_LT((joint.centre - Vec3(centre[0], centre[1], centre[2])).norm(), 0.35) << hip;
    EXPECT_NEAR(joint.fit->radius, subject["radius_mm"].get<double>(), 0.12) << hip;
    const GapsAnswer found = answer(session, GapsRequest());
    const double distance = subject["pose"]["min_gap_regions_mm"];
    EXPECT_NEAR(found.smallest_gap.value().gap_mm, distance, 0.15) << hip;
    EXPECT_EQ(found.impingement().at(0).ball.vertices, 0U) << hip << ": no bone touches another";
    EXPECT_GT(found.impingement().at(1).socket.area_mm2, 100.0) << hip << ": 4 mm of cartilage do touch";
  }
}

// The head is found in the whole bone, too.
TEST(RealBones, CentreIsFoundInTheWholeFemur) {
  for (const fs::path& hip : hips()) {
    if (!fs::exists(hip / "femur.ply")) continue;
    const auto subject = Json::parse(read_bytes(hip / "subject.json"));
    const SphereFit fit = fit_ball(read_mesh(hip / "femur.ply"));
    const auto& centre = subject["center_of_rotation_mm"];
    EXPECT_LT((fit.centre - Vec3(centre[0], centre[1], centre[2])).norm(), 0.35) << hip;
    EXPECT_NEAR(fit.radius, subject["radius_mm"].get<double>(), 0.12) << hip;
  }
}

// Of both whole bones as much is taken as was cut out by hand: the faces of acetabulum_facing.ply are within
// 1.45 head radii, ours within 1.5.
TEST(RealBones, TheJointIsFoundInWholeBones) {
  for (const fs::path& hip : hips()) {
    if (!fs::exists(hip / "femur.ply") || !fs::exists(hip / "pelvis.ply")) continue;
    JointOptions options = options_of(hip);
    options.ball = hip / "femur.ply";
    options.socket = hip / "pelvis.ply";
    const Session whole = load_joint(options, {});
    const Joint& joint = whole.joint->joint;
    const auto facing = static_cast<double>(read_mesh(hip / "acetabulum_facing.ply").faces.size());
    EXPECT_NEAR(static_cast<double>(joint.socket.taken.value().faces), facing, 0.02 * facing) << hip;
    EXPECT_GT(joint.ball.star_shape.solid_angle, 0.9 * 4.0 * kPi) << hip;
    EXPECT_LT(joint.ball.star_shape.violating, 0.001) << hip;
    EXPECT_LT(joint.socket.star_shape.violating, 0.001) << hip;
  }
}

// Shares of directions that the description counted with its own rays.
TEST(RealBones, CoverageIsThatOfTheDescription) {
  for (const fs::path& hip : hips()) {
    const auto subject = Json::parse(read_bytes(hip / "subject.json"));
    JointOptions options = options_of(hip);
    const auto& centre = subject["center_of_rotation_mm"];
    options.centre = Vec3(centre[0], centre[1], centre[2]);
    Session session = load_joint(options, {});
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

// Faces above a share of the mesh's height.
TriangleMesh above(const TriangleMesh& mesh, double share) {
  const auto [lowest, highest] = std::ranges::minmax(mesh.vertices, {}, [](const Vec3& x) { return x.z(); });
  const double cut = lowest.z() + share * (highest.z() - lowest.z());
  TriangleMesh kept{mesh.vertices, {}};
  for (const Face& face : mesh.faces) {
    if (std::ranges::all_of(face, [&](auto v) { return mesh.vertices[v].z() > cut; }))
      kept.faces.push_back(face);
  }
  return kept;
}

TriangleMesh noisy(TriangleMesh mesh, double mm, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> error(0.0, mm);
  for (Vec3& x : mesh.vertices) x += Vec3(error(random), error(random), error(random));
  return mesh;
}

// How far noise may move a measure beyond what it is said to be uncertain by, which is of the measuring.
double by_noise(const Measure& measure) {
  if (measure.name.starts_with("alpha")) return 4.0;  // degrees: the surface leaves the head slowly
  return measure.unit == "deg" ? 1.5 : measure.unit == "mm" ? 0.15 : 0.01;
}

// Of whole femurs. A tenth and three tenths of their height are cut off, or every vertex is moved.
TEST(RealBones, MeasuresStayOrAreRefusedUnderNoiseAndCropping) {
  std::size_t compared = 0;
  std::size_t folders = 0;
  for (const fs::path& hip : hips()) {
    JointOptions options = options_of(hip);
    if (fs::exists(hip / "femur.ply")) options.ball = hip / "femur.ply";
    options.side = hip.string().ends_with("left") ? Side::left : Side::right;
    const auto text = Json::parse(read_bytes(hip / "subject.json"))["axes"].get<std::string>();
    options.axes = text.find("LPS") != text.npos ? "LPS" : "RAS";
    const Session session = load_joint(options, {});
    const SessionJoint& joint = *session.joint;
    const auto bone = [&](const fs::path& file) {
      return in_joint_frame(joint, relative_to(read_mesh(file), joint.joint.centre));
    };
    const BallSocketPair whole{bone(options.ball), bone(options.socket)};
    const std::vector<Measure> found = measure_hip(whole, *joint.side);
    const auto compare = [&](const char* what, const BallSocketPair& changed) {
      const std::vector<Measure> others = measure_hip(changed, *joint.side);
      ASSERT_EQ(others.size(), found.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        if (!found[k].value || !others[k].value) continue;
        const double said = *found[k].uncertainty + *others[k].uncertainty;
        EXPECT_NEAR(*others[k].value, *found[k].value, said + by_noise(found[k]))
            << hip << ", " << what << ": " << found[k].name;
        ++compared;
      }
    };
    for (unsigned seed = 0; seed < 3; ++seed)
      compare("0.2 mm of noise", {noisy(whole.ball, 0.2, seed), noisy(whole.socket, 0.2, seed + 100)});
    compare("cropped", {above(whole.ball, 0.1), whole.socket});
    compare("cropped more", {above(whole.ball, 0.3), whole.socket});
    ++folders;
  }
  EXPECT_GE(compared, 30 * folders);
}

}  // namespace
}  // namespace impinge
