// SPDX-License-Identifier: GPL-3.0-or-later
// What would have to change, as files: the cut ball in the frame of the user's meshes, and the map of
// orientations.
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/io.hpp"
#include "mesh/ply_writer.hpp"
#include "scene/joint.hpp"
#include "scene/orientation.hpp"
#include "scene/resection.hpp"
#include "scene/scene_files.hpp"
#include "support/temporary_folder.hpp"

namespace impinge {
namespace {

const Vec3 kCentreHere(3.0, -70.0, 12.0);

// A right hip about kCentreHere as two files.
SceneOptions options_in(const std::filesystem::path& folder) {
  const Hip hip = make_hip(hip_preset("cam"), 1000);
  SceneOptions options;
  options.ball = folder / "femur.ply";
  options.socket = folder / "pelvis.ply";
  options.out = folder;
  options.side = Side::right;
  options.centre = kCentreHere;
  options.question = Question::first_contact;
  write_ply(options.ball, relative_to(hip.ball, -kCentreHere));
  write_ply(options.socket, relative_to(hip.socket, -kCentreHere));
  options.change = ChangeOptions{};
  options.change->text = "flexion=90,internal_rotation=25";
  options.change->required = {parse_motion(options.change->text)};
  return options;
}

TEST(SceneChange, WritesTheBallThatIsLeft) {
  const test::TemporaryFolder folder;
  const SceneOptions options = options_in(folder.path());
  Session session = load_joint(options);
  const ResectionAnswer found = answer_resection(session, resection_request(options));
  const nlohmann::json report = resection_summary(options, *session.joint, found, 1.0);
  write_resection(options, *session.joint, found, report);
  EXPECT_EQ(report["question"], "resection");
  EXPECT_EQ(report["require"], options.change->text);
  EXPECT_EQ(report["notice"], kNoGuide);
  EXPECT_LT(report["volume_mm3"][0], report["volume_mm3"][1]);
  EXPECT_GT(report["legs"][1]["after"]["low_deg"], report["legs"][1]["required_deg"]);
  const TriangleMesh cut = relative_to(read_mesh(options.out / "resected_ball.ply"), kCentreHere);
  ASSERT_EQ(cut.vertices.size(), found.cut.cut.vertices.size());
  for (std::size_t v = 0; v < cut.vertices.size(); ++v)
    ASSERT_LT((cut.vertices[v] - found.cut.cut.vertices[v]).norm(), 1e-4) << "meshes are read as floats";
  EXPECT_NE(describe_resection(options, found).find(kNoGuide), std::string::npos);
}

TEST(SceneChange, WritesTheCutSocket) {
  const test::TemporaryFolder folder;
  SceneOptions options = options_in(folder.path());
  options.change->text = "flexion=90,internal_rotation=20";
  options.change->required = {parse_motion(options.change->text)};
  options.change->cut = Surface::socket;
  EXPECT_EQ(scene_files(options), (std::vector<std::string>{"resected_socket.ply", "resection.json"}));
  Session session = load_joint(options);
  const ResectionAnswer found = answer_resection(session, resection_request(options));
  const nlohmann::json report = resection_summary(options, *session.joint, found, 1.0);
  write_resection(options, *session.joint, found, report);
  EXPECT_EQ(report["surface"], "socket");
  EXPECT_EQ(report["notice"], kNoGuide);
  EXPECT_TRUE(report["volume_mm3"].is_null());
  EXPECT_TRUE(report["mesh_volume_mm3"].is_null());
  EXPECT_NE(report["volume_why"].get<std::string>().find("no closed mesh"), std::string::npos);
  EXPECT_GT(report["area_mm2"][0], 0.0);
  EXPECT_GT(report["legs"][1]["after"]["low_deg"], report["legs"][1]["required_deg"]);
  const TriangleMesh cut = relative_to(read_mesh(options.out / "resected_socket.ply"), kCentreHere);
  ASSERT_EQ(cut.vertices.size(), found.cut.cut.vertices.size());
  for (std::size_t v = 0; v < cut.vertices.size(); ++v)
    ASSERT_LT((cut.vertices[v] - found.cut.cut.vertices[v]).norm(), 1e-4) << "meshes are read as floats";
  const std::string text = describe_resection(options, found);
  EXPECT_NE(text.find("of the socket's surface"), std::string::npos) << text;
  EXPECT_NE(text.find(kNoGuide), std::string::npos);
}

TEST(SceneChange, WritesWhatTheBoneSweepsThrough) {
  const test::TemporaryFolder folder;
  SceneOptions options = options_in(folder.path());
  HipParameters walled = hip_preset("cam");
  walled.wall_thickness = 3.0;
  write_ply(options.socket, relative_to(make_hip(walled, 1000).socket, -kCentreHere));
  options.change->least = true;
  Session session = load_joint(options);
  const ResectionAnswer found = answer_resection(session, resection_request(options));
  const nlohmann::json report = resection_summary(options, *session.joint, found, 1.0);
  write_resection(options, *session.joint, found, report);
  EXPECT_LE(report["least"]["volume_mm3"][1], report["volume_mm3"][1]);
  std::ifstream file(options.out / "swept.csv");
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z,from_mm,to_mm");
  std::size_t rows = 0;
  while (std::getline(file, line)) ++rows;
  EXPECT_GE(rows, report["least"]["cells"]);
  EXPECT_NE(describe_resection(options, found).find("least cut of all    "), std::string::npos);
}

TEST(SceneChange, WritesAMapThatIsWhole) {
  const test::TemporaryFolder folder;
  SceneOptions options = options_in(folder.path());
  options.change->of_socket = true;
  options.change->tilt_deg = 5.0;
  Session session = load_joint(options);
  OrientationRequest request = orientation_request(options);
  request.resolution_deg = 2.0;
  const OrientationAnswer found = answer_orientation(session, request);
  EXPECT_NEAR(found.question.at_rest.anteversion_deg, 15.7, 1.0);  // of 54 and 19 degrees as seen from above
  EXPECT_NEAR(found.free + found.blocked + found.unknown + found.open, 8100.0, 1e-6);
  EXPECT_GT(found.free, 500.0);
  EXPECT_LT(found.open, 1500.0);
  const nlohmann::json report = orientation_summary(options, *session.joint, found, 1.0);
  write_orientation(options, found, report);
  EXPECT_EQ(report["notice"], kNoGuide);
  EXPECT_EQ(report["tilt_deg"], 5.0);
  std::ifstream file(options.out / "orientation.csv");
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "inclination_deg,anteversion_deg,half_width_deg,state,motion");
  std::size_t rows = 0;
  while (std::getline(file, line)) ++rows;
  EXPECT_EQ(rows, found.cells.size());
}

}  // namespace
}  // namespace impinge
