// SPDX-License-Identifier: GPL-3.0-or-later
// What a plan takes for proven before there is a table: which vertices may matter, and which poses touch.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "harness/answer_difference.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "session/scene_answer.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

using namespace lab;

SceneAnswer answer_at(double precision, const BallSocketPair& joint, const SceneNeeds& needs,
                      Omissions omissions) {
  return answer_scene(joint, needs, AnyScheme("rsid", precision), omissions);
}

// Poses near contact and far from it, in turns.
TEST(Promises, HoldInManyPoses) {
  const BallSocketPair joint = make_ball_socket_pair(500, impinging_cam());
  SceneNeeds needs;
  needs.poses = test::random_poses(40, 1.5, 4.5, 31);
  const auto near = test::random_poses(40, 0.1, 0.3, 32);
  needs.poses.insert(needs.poses.end(), near.begin(), near.end());
  for (const Question question : {Question::touch, Question::first_contact}) {
    needs.question = question;
    const SceneAnswer everything = answer_at(2.0, joint, needs, Omissions::none());
    const SceneAnswer planned = answer_at(2.0, joint, needs, Omissions::all());
    EXPECT_TRUE(same_answer(planned, everything));
    EXPECT_LT(planned.cost.look_ups, everything.cost.look_ups / 5);
  }
}

// A socket with a narrow dent towards every second corner of a coarse grid: a table reads it from beside it,
// where the surface itself is far.
TriangleMesh dented(TriangleMesh mesh, const Rsid& scheme) {
  for (Vec3& v : mesh.vertices) {
    for (std::size_t entry = 0; entry < scheme.size(); entry += 2) {
      if (v.dot(scheme.direction(entry)) > std::cos(3.0 * kDegree) * v.norm()) v = 20.0 * v.normalized();
    }
  }
  return mesh;
}

// Every vertex that touches by the table is listed, though the faces in its own direction are clear.
TEST(Promises, HoldForTablesThatReadFromAfar) {
  const Rsid scheme = Rsid::with_precision(15.0);
  const BallSocketPair joint{sphere(23.0, 400), dented(sphere(25.0, 5000), scheme)};
  const auto table = fill_exact(joint.socket, scheme, Layer::nearest);
  SceneNeeds needs;
  needs.question = Question::touch;
  needs.socket = false;
  needs.poses = test::random_poses(5, 3.0, 0.3, 34);
  const ScenePlan plan =
      plan_scene(joint, needs, AnyScheme("rsid", 15.0), Omissions::none().with(Omission::vertices));
  const ScanPlan& scan = plan.scans[0];
  std::size_t clear = 0;
  for (std::size_t p = 0; p < needs.poses.size(); ++p) {
    ASSERT_FALSE(plan.touches[p]);
    for (std::uint32_t v = 0; v < joint.ball.vertices.size(); ++v) {
      const Vec3 x = to_socket(needs.poses[p], joint.ball.vertices[v]);
      if (table.radius_at(x) > x.norm()) continue;
      EXPECT_TRUE(std::ranges::count((*scan.vertices)[p], v) == 1);
      if (scan.faces->radius(x.normalized(), Layer::nearest) > x.norm()) ++clear;
    }
  }
  EXPECT_GT(clear, 20U) << "the faces alone would miss them";
}

// What the plan took for proven and the answer has not is not kept, whatever the other poses have.
TEST(Promises, AreKeptPoseByPose) {
  SceneNeeds needs;
  needs.question = Question::touch;
  needs.poses.resize(2);
  ScenePlan plan(AnyScheme("rsid", 2.0));
  SceneAnswer answer;
  answer.touches = {true, false};
  plan.touches = {false, false};
  EXPECT_TRUE(is_as_planned(needs, plan, answer)) << "nothing was promised";
  plan.touches = {true, false};
  EXPECT_TRUE(is_as_planned(needs, plan, answer));
  plan.touches = {false, true};
  EXPECT_FALSE(is_as_planned(needs, plan, answer));
  needs.question = Question::first_contact;
  plan.limit_mm = 0.5;
  EXPECT_FALSE(is_as_planned(needs, plan, answer));
  answer.smallest = SmallestGap{0.5, Surface::ball, 0, 0};
  EXPECT_TRUE(is_as_planned(needs, plan, answer));
  answer.smallest->gap_mm = 0.6;
  EXPECT_FALSE(is_as_planned(needs, plan, answer));
}

// A vertex may be proven to touch and yet have no answer, where a cell of a coarse table is at a rim that is
// farther than the stencil radius: then the plan makes no promise.
TEST(Promises, ThatARimTakesAwayAreLookedAtAgain) {
  const BallSocketPair joint{sphere(20.0, 2000), cup(19.9, 60.0, 300)};
  for (const double precision : {4.0, 9.0, 20.0}) {
    SceneNeeds needs;
    needs.question = Question::touch;
    needs.socket = false;
    needs.poses = test::random_poses(60, 0.05, 0.3, 33);
    EXPECT_TRUE(same_answer(answer_at(precision, joint, needs, Omissions::all()),
                            answer_at(precision, joint, needs, Omissions::none())));
  }
}

}  // namespace
}  // namespace impinge
