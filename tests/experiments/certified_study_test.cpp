// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of certified verdicts: poses close to contact, no wrong verdict, and one that is noticed.
#include "10_certified/certified_study.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/temporary_folder.hpp"

namespace impinge::lab {
namespace {

const BallSocketPair& joint() {
  static const BallSocketPair pair = make_ball_socket_pair(100, impinging_cam());
  return pair;
}

// Spheres of radius 20 in 26 with a common centre touch once the ball has moved by 6 mm, less the sagittas of
// their faces.
TEST(ContactPoses, FindTheFirstContact) {
  const SurfaceOverlay spheres(sphere(20.0, 4000), sphere(26.0, 4000));
  const auto impinged = [&spheres](const Pose& pose) { return spheres.impinged(pose); };
  PosePath path;
  path.shift = Vec3(0.0, 8.0, 6.0);
  const auto contact = first_contact(path, impinged);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(*contact * 10.0, 6.0, 0.06);
  EXPECT_TRUE(spheres.impinged(path.at(*contact)));
  EXPECT_FALSE(spheres.impinged(path.at(*contact - 0x1p-23)));
  path.shift *= 0.5;
  EXPECT_FALSE(first_contact(path, impinged));
}

TEST(ContactPoses, AreMostlyCloseToContactAndOnBothSides) {
  const SurfaceOverlay overlay(joint().ball, joint().socket);
  const auto poses = contact_poses(overlay, {240, 1.0, 12.0, 0, 3});
  std::size_t close = 0;
  std::size_t impinged = 0;
  std::size_t turns = 0;
  for (const ContactPose& pose : poses) {
    impinged += overlay.impinged(pose.pose) ? 1U : 0U;
    turns += pose.path.shift.isZero() ? 1U : 0U;
    if (!pose.contact) continue;
    const Pose touching = pose.path.at(*pose.contact);
    close += (touching.translation - pose.pose.translation).norm() +
                         kArm * (touching.rotation - pose.pose.rotation).norm() <
                     0.5
                 ? 1U
                 : 0U;
  }
  EXPECT_GT(close, 75U);
  EXPECT_GT(impinged, 45U);
  EXPECT_LT(impinged, 195U);
  EXPECT_GT(turns, 0U);
}

TEST(CertifiedStudy, FindsNoWrongVerdictAndNoticesAFalsifiedOne) {
  const test::TemporaryFolder folder;
  CertifiedStudy study = make_certified_study(folder.path());
  ContactOptions options;
  options.count = 60;
  options.ways = 10;
  CertifiedJoint judged = judge_joint(study, "pair", joint(), options);
  const SchemeVerdicts found = judge_scheme(study, judged, Rsid::with_precision(4.0));
  add_scheme_row(study, judged, Rsid::name, 4.0, found);
  EXPECT_EQ(study.wrong, 0U);
  EXPECT_EQ(found.wrong, 0U);
  EXPECT_NO_THROW(require_none_wrong(study));
  EXPECT_EQ(study.schemes.rows.size(), 1U);
  EXPECT_EQ(study.poses.rows.size(), 1U);
  EXPECT_GT(found.vertices.clear, 0U);
  EXPECT_GT(found.vertices.impinged, 0U);
  EXPECT_GT(found.vertices.undecided, 0U);

  judged.poses[7].ball[3] = !judged.poses[7].ball[3];
  EXPECT_GE(judge_scheme(study, judged, Rsid::with_precision(4.0)).wrong, 1U);
  EXPECT_THROW(require_none_wrong(study), std::runtime_error);
  EXPECT_NE(read_bytes(folder.path() / "certified_witness.json").find("ball vertex 3"), std::string::npos);
}

}  // namespace
}  // namespace impinge::lab
