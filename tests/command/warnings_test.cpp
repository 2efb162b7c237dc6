// SPDX-License-Identifier: GPL-3.0-or-later
// What a user must know of a joint before any answer is said once, in one line that names the file and what
// to do: further pieces, flaws, a centre beside the ball, contact and gaps at the start. Spheres of known
// gap.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "command/joint_options.hpp"
#include "command/question_command.hpp"
#include "joint/gaps.hpp"
#include "joint/limits.hpp"
#include "joint/rest_contact.hpp"
#include "joint/volume.hpp"
#include "mesh/bodies.hpp"
#include "mesh/io.hpp"
#include "support/joined.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

const Vec3 kFramed(-86.0, 20.5, -580.25);  // the centre, frame of the files

class JointWarnings : public ::testing::Test {
 protected:
  // Opens to the right of a right hip; the gap is 25 mm less the radius of the ball.
  JointWarnings() {
    TriangleMesh socket = cup(25.0, 80.0, 3000);
    for (Vec3& v : socket.vertices) v = Vec3(-v.z(), v.y(), v.x());
    options_.ball = written("ball.ply", sphere(22.0, 3000));
    options_.socket = written("socket.ply", socket);
    options_.side = Side::right;
  }
  std::filesystem::path written(const std::string& name, TriangleMesh mesh) {
    for (Vec3& x : mesh.vertices) x += kFramed;
    write_mesh(folder_.path() / name, mesh);
    return folder_.path() / name;
  }
  // The warnings, from the names of the files on.
  std::vector<std::string> said(const ScanContactOptions& told = scan_contact_of(GapsRequest())) {
    std::vector<std::string> lines = load_joint(options_, told).joint->joint.warnings;
    const std::string folder = folder_.path().string() + "/";
    for (std::string& line : lines) {
      if (line.starts_with(folder)) line.erase(0, folder.size());
    }
    return lines;
  }

  test::TemporaryFolder folder_;
  JointOptions options_;
};

using Lines = std::vector<std::string>;

const TriangleMesh kSpeck = sphere(0.5, 20, {0.0, 0.0, 23.5});

TEST_F(JointWarnings, AGoodJointHasNone) { EXPECT_EQ(said(), Lines()); }

TEST_F(JointWarnings, APieceBesideTheBallIsNamedAndCanBeLeftOut) {
  const TriangleMesh screw = sphere(3.0, 100, {2.0, 0.0, 0.0});
  options_.ball = written("ball.ply", test::joined(test::joined(kSpeck, sphere(22.0, 3000)), screw));
  ASSERT_FALSE(said().empty());
  EXPECT_EQ(
      said().front(),
      "ball.ply: has 3 pieces that do not hang together, 44.0, 6.0 and 1.0 mm across; each counts as bone, "
      "and a speck of a segmentation can block all motion: remove what is no bone, or take the largest "
      "piece alone with --keep largest");
  options_.keep_largest = true;
  EXPECT_EQ(said(), Lines{"ball.ply: 2 of its 3 pieces left out, 6.0 and 1.0 mm across"});
  EXPECT_EQ(load_joint(options_, {}).joint->joint.ball.mesh.faces.size(), 3000U);
}

TEST_F(JointWarnings, PartsAndWhatIsInThemAreTakenAndTheirFlawsAreTheirs) {
  const TriangleMesh screw = sphere(1.0, 100, {60.0, 0.0, 0.0});
  TriangleMesh flipped = sphere(5.0, 100, {60.0, 0.0, 0.0});
  std::swap(flipped.faces[3][0], flipped.faces[3][1]);
  options_.ball_parts = {written("bone.ply", flipped), written("screw.ply", screw)};
  options_.socket_parts = {written("two.stl", test::joined(sphere(5.0, 100, {-60.0, 0.0, 0.0}), kSpeck))};
  const Lines lines = said();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].rfind("two.stl: has 2 pieces", 0), 0U) << lines[0];
  EXPECT_EQ(lines[1], "bone.ply: 100 faces, 52 vertices, 1 part, closed flaws: 1 flipped faces");
  EXPECT_EQ(load_joint(options_, {}).joint->joint.ball.validation.flipped_faces, 1U);
}

// A quarter of the radius is 5.5 mm, and 5 mm are less.
TEST_F(JointWarnings, ACentreBesideTheSphereThatFitsIsSaidWithBoth) {
  options_.centre = kFramed + Vec3(0.0, 4.9, 0.0);
  EXPECT_EQ(said(), Lines());
  options_.centre = kFramed + Vec3(0.0, -5.2, 0.0);
  const Lines lines = said();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].rfind(
                "ball.ply: the centre that was given, -86.000,15.300,-580.250, is 5.2 mm from -86.00", 0),
            0U)
      << lines[0];
  EXPECT_NE(lines[0].find("sphere of radius 22.0 mm"), std::string::npos) << lines[0];
}

TEST_F(JointWarnings, ContactAsScannedIsSaidOfEveryQuestion) {
  options_.ball = written("ball.ply", sphere(25.25, 3000));
  for (const auto& told :
       {scan_contact_of(GapsRequest()), scan_contact_of(LimitsRequest()), scan_contact_of(VolumeRequest())}) {
    const Lines lines = said(told);
    ASSERT_EQ(lines.size(), 1U);
    const std::string& line = lines[0];
    EXPECT_EQ(line.rfind("ball and socket touch as scanned, 0.2", 0), 0U) << line;
    EXPECT_NE(line.find(" o'clock: every motion that begins there is blocked; check the centre"), line.npos)
        << line;
    EXPECT_NE(line.find("; --ignore-rest-contact accepts it"), line.npos) << line;
  }
}

// A ball of the socket's radius, 0.3 mm deeper, and one that its socket cannot hold.
TEST_F(JointWarnings, ContactAsScannedIsIgnoredUpToItsDepth) {
  options_.ignore_rest_contact = true;
  for (const auto& [radius, overlap] : {std::pair{22.0, 0.0}, {25.0, 0.1}, {25.25, 0.3}}) {
    options_.ball = written("ball.ply", sphere(radius, 3000));
    EXPECT_EQ(said(), Lines()) << radius;
    Session session = load_joint(options_, {});
    EXPECT_NEAR(session.joint->joint.overlap_mm, overlap, 0.11) << radius;
    EXPECT_EQ(touch_in(*session.joint, Pose()).contact.state, Contact::no);
    const LimitsAnswer limits = answer(session, LimitsRequest{});  // of a ball alone, in its cup
    for (const LimitAnswer& limit : limits.limits) EXPECT_NE(limit.told.limit.state, LimitState::blocked);
  }
  options_.ball = written("ball.ply", sphere(22.0, 3000));
  options_.socket_parts = {written("spur.ply", sphere(8.0, 300, {0.0, 0.0, 20.0}))};
  const std::string refused = test::thrown<std::runtime_error>([&] { load_joint(options_, {}); });
  EXPECT_EQ(refused.rfind("--ignore-rest-contact: the bones touch as scanned even where they may", 0), 0U);
}

TEST_F(JointWarnings, CartilageOfTheScanIsItsSmallestGap) {
  EXPECT_NEAR(cartilage_of_scan(*load_joint(options_, {}).joint, "--cartilage scan"), 2.98,
              0.021);  // faces are flat
  options_.ball = written("ball.ply", sphere(25.25, 3000));
  const std::string refused = test::thrown<std::runtime_error>(
      [&] { cartilage_of_scan(*load_joint(options_, {}).joint, "--cartilage scan"); });
  EXPECT_EQ(refused.rfind("--cartilage scan: the bones as scanned leave no gap", 0), 0U) << refused;
}

// As a smaller ball has it: where the whole overlap is allowed there is a gap.
TEST_F(JointWarnings, AnOverlapThatIsAllowedIsNoContact) {
  options_.ball = written("ball.ply", sphere(25.25, 3000));
  for (const double overlap : {0.2, 0.35, 1.25}) {
    options_.overlap_mm = overlap;
    EXPECT_EQ(said().size(), overlap > 0.3 ? 0U : 1U) << overlap;
    const Session session = load_joint(options_, {});
    const TouchAnswer found = touch_in(*session.joint, Pose());
    EXPECT_NEAR(found.smallest_gap->gap_mm, overlap - 0.25, 0.05);
    EXPECT_EQ(found.contact.state == Contact::yes, overlap < 0.3);
  }
  options_.overlap_mm = 30.0;
  const std::string refused = test::thrown<std::runtime_error>([&] { load_joint(options_, {}); });
  EXPECT_NE(refused.find("ball.ply: has a point 25"), std::string::npos) << refused;
}

TEST_F(JointWarnings, AGapBelowWhatIsAskedForIsSaidOfThatQuestionAlone) {
  EXPECT_EQ(said(), Lines());
  LimitsRequest limits;
  EXPECT_EQ(said(scan_contact_of(limits)), Lines());  // contact alone
  limits.cartilage_mm = 4.0;
  const Lines lines = said(scan_contact_of(limits));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].rfind("the smallest gap as scanned is 2.9", 0), 0U) << lines[0];
  EXPECT_NE(lines[0].find("not above the 4 mm of --cartilage: every limit for that gap is blocked"),
            std::string::npos)
      << lines[0];
  limits.cartilage_mm = 2.0;
  EXPECT_EQ(said(scan_contact_of(limits)), Lines());
  const Lines of_volume = said(scan_contact_of(VolumeRequest{.gap_mm = 3.5}));
  ASSERT_EQ(of_volume.size(), 1U);
  EXPECT_NE(of_volume[0].find("not above the 3.5 mm of --gap"), std::string::npos);
}

TEST(ScanContact, WhatIsNotKnownIsLeftOutOfTheWords) {
  const ScanContactOptions options{
      .overlap = "--ignore-rest-contact", .threshold_mm = 4.0, .threshold = "--cartilage"};
  TouchAnswer found;
  const auto said = [&] { return describe_contact(found, "as scanned", options); };
  EXPECT_EQ(said(), "");
  found.contact = {Contact::yes, ContactRule::surfaces, "trochanter", "spine"};
  EXPECT_EQ(said().rfind("trochanter and spine touch as scanned: every motion that begins", 0), 0U);
  EXPECT_EQ(said().find("--ignore"), std::string::npos);
  EXPECT_EQ(describe_threshold(found, "as scanned", options), "");
  found.smallest_gap.emplace().gap_mm = -1.25;
  EXPECT_EQ(said().find("deep along a ray"), std::string::npos);  // of other bones
  found.contact = {Contact::yes, ContactRule::surfaces, {}, {}};
  EXPECT_NE(said().find("as scanned, 1.250 mm deep along a ray: every"), std::string::npos);
  found.smallest_gap->hours = 1.5;
  EXPECT_NE(said().find("1.250 mm deep along a ray at 1:30 o'clock: "), std::string::npos);
  EXPECT_NE(said().find("; --ignore-rest-contact accepts"), std::string::npos);
}

}  // namespace
}  // namespace impinge
