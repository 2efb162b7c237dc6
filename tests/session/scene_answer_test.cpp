// SPDX-License-Identifier: GPL-3.0-or-later
// Leaving out what a scene does not need changes no answer: bit for bit with a given table, within the
// accuracy of the exact gap where one is stated. The oracle of the answers is the two scans over whole
// tables.
#include "session/scene_answer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "harness/answer_difference.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "session/table_choice.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/poses.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

using namespace lab;

constexpr double kPrecision = 1.0;  // degrees

SceneAnswer answer(const BallSocketPair& joint, const SceneNeeds& needs, Omissions omissions) {
  return answer_scene(joint, needs, AnyScheme("rsid", kPrecision), omissions);
}

BallSocketPair cam() { return make_ball_socket_pair(700, impinging_cam()); }

// There and back; the cam comes under the socket from 34 degrees on.
std::vector<Pose> motion() {
  std::vector<Pose> poses;
  for (const double angle : {0.0, 25.0, 50.0, 25.0, 0.0}) {
    poses.push_back(
        {Eigen::AngleAxisd(-angle * kDegree, Vec3::UnitY()).toRotationMatrix(), Vec3(0.2, 0.0, 0.1)});
  }
  return poses;
}

std::vector<SceneNeeds> all_needs() {
  std::vector<SceneNeeds> all;
  for (const Question question : {Question::touch, Question::first_contact, Question::all_gaps}) {
    for (const bool ball : {true, false}) {
      for (const bool socket : {true, false}) {
        if (ball || socket) all.push_back({question, ball, socket, motion(), std::nullopt});
      }
    }
  }
  return all;
}

bool has(const SceneAnswer& answer, Omission omission) {
  return std::ranges::any_of(answer.left_out, [&](const LeftOut& item) { return item.what == omission; });
}

TEST(SceneAnswer, NothingLeftOutIsTheTwoScans) {
  const BallSocketPair joint = cam();
  const Rsid scheme = Rsid::with_precision(kPrecision);
  const auto socket = fill_exact(joint.socket, scheme, Layer::nearest);
  const auto ball = fill_exact(joint.ball, scheme, Layer::farthest);
  SceneNeeds needs;
  needs.poses = motion();
  const SceneAnswer found = answer(joint, needs, Omissions::none());
  SceneAnswer expected;
  double smallest = 100.0;
  for (std::size_t p = 0; p < needs.poses.size(); ++p) {
    PoseGaps gaps{std::vector<double>(joint.ball.vertices.size()),
                  std::vector<double>(joint.socket.vertices.size())};
    scan_gaps(socket, joint.ball.vertices, needs.poses[p], Surface::ball, gaps.ball);
    scan_gaps(ball, joint.socket.vertices, needs.poses[p], Surface::socket, gaps.socket);
    for (const double g : gaps.ball) smallest = std::fmin(smallest, g);
    for (const double g : gaps.socket) smallest = std::fmin(smallest, g);
    expected.gaps.push_back(gaps);
  }
  EXPECT_TRUE(same_answer(found, expected));
  needs.question = Question::first_contact;
  EXPECT_EQ(answer(joint, needs, Omissions::none()).smallest->gap_mm, smallest);
  needs.question = Question::touch;
  EXPECT_EQ(answer(joint, needs, Omissions::none()).touches,
            (std::vector<bool>{false, false, true, false, false}));
}

TEST(SceneAnswer, EveryOmissionAndAllOfThemKeepTheAnswer) {
  const BallSocketPair joint = cam();
  for (const SceneNeeds& needs : all_needs()) {
    const SceneAnswer everything = answer(joint, needs, Omissions::none());
    for (const OmissionName& omission : kOmissions) {
      EXPECT_TRUE(same_answer(answer(joint, needs, Omissions::none().with(omission.omission)), everything))
          << omission.name << " for question " << static_cast<int>(needs.question);
    }
    const SceneAnswer planned = answer(joint, needs, Omissions::all());
    EXPECT_TRUE(same_answer(planned, everything)) << static_cast<int>(needs.question);
    EXPECT_LT(planned.cost.entries, everything.cost.entries / 2);
    EXPECT_LE(planned.cost.look_ups, everything.cost.look_ups);
    EXPECT_TRUE(has(planned, Omission::entries));
  }
}

TEST(SceneAnswer, RandomPosesWithTranslationsKeepTheAnswer) {
  const BallSocketPair joint = cam();
  for (const Question question : {Question::touch, Question::first_contact, Question::all_gaps}) {
    SceneNeeds needs;
    needs.question = question;
    needs.poses = test::random_poses(6, 1.5, 4.5, 12);
    EXPECT_TRUE(same_answer(answer(joint, needs, Omissions::all()), answer(joint, needs, Omissions::none())));
  }
}

// A bump far from the socket's vertices: what the ball's table could add is proven not to matter.
TEST(SceneAnswer, TheSecondScanIsDroppedWhereItCannotMatter) {
  const BallSocketPair free{sphere(20.0, 700), cup(26.0, 60.0, 500)};
  SceneNeeds needs;
  needs.question = Question::touch;
  const SceneAnswer planned = answer(free, needs, Omissions::all());
  EXPECT_EQ(planned.touches, std::vector<bool>{false});
  EXPECT_EQ(planned.cost.entries, 0U) << "the ranges prove it without any table";
  EXPECT_TRUE(has(planned, Omission::second_scan));
  const SceneAnswer alone = answer(free, needs, Omissions::none().with(Omission::second_scan));
  EXPECT_EQ(alone.cost.entries, Rsid::with_precision(kPrecision).size()) << "one table of the two";
}

TEST(SceneAnswer, SurfacesThatDoNotFaceEachOtherHaveNoGap) {
  BallSocketPair joint{cup(20.0, 20.0, 200), cup(26.0, 20.0, 200)};
  for (Vec3& v : joint.ball.vertices) v = -v;
  SceneNeeds needs;
  needs.question = Question::first_contact;
  EXPECT_FALSE(answer(joint, needs, Omissions::all()).smallest.has_value());
  EXPECT_FALSE(answer(joint, needs, Omissions::none()).smallest.has_value());
}

// The gap of every vertex to the mesh itself, by rays.
TEST(SceneAnswer, AnAccuracyIsKeptAtEveryVertex) {
  const BallSocketPair joint = cam();
  const RayCaster socket(joint.socket);
  const RayCaster ball(joint.ball);
  for (const double accuracy : {1.0, 0.1, 1e-5}) {
    SceneNeeds needs;
    needs.accuracy_mm = accuracy;
    needs.poses = test::random_poses(accuracy == 0.1 ? 3 : 300, 1.0, 1.0, 13);  // with a table, and without
    const SceneAnswer found = answer(joint, needs, Omissions::all());
    EXPECT_TRUE(has(found, Omission::fine_table));
    EXPECT_EQ(found.cost.entries > 0, accuracy == 1.0) << "a table pays for many look-ups at a low accuracy";
    for (std::size_t p = 0; p < needs.poses.size(); p += 1 + needs.poses.size() / 10) {
      for (std::size_t i = 0; i < joint.ball.vertices.size(); ++i) {
        const Vec3 x = to_socket(needs.poses[p], joint.ball.vertices[i]);
        const double gap = socket.cast(x.normalized(), Layer::nearest) - x.norm();
        const double ours = found.gaps[p].ball[i];
        ASSERT_EQ(std::isnan(gap), std::isnan(ours));
        if (!std::isnan(gap)) {
          ASSERT_NEAR(ours, gap, accuracy);
        }
      }
      for (std::size_t i = 0; i < joint.socket.vertices.size(); ++i) {
        const Vec3 x = to_ball(needs.poses[p], joint.socket.vertices[i]);
        const double gap = x.norm() - ball.cast(x.normalized(), Layer::farthest);
        const double ours = found.gaps[p].socket[i];
        ASSERT_EQ(std::isnan(gap), std::isnan(ours));
        if (!std::isnan(gap)) {
          ASSERT_NEAR(ours, gap, accuracy);
        }
      }
    }
  }
}

// Many look-ups in a smooth surface pay for a table, a coarse one for a coarse accuracy, in few bytes; few
// look-ups pay for none.
TEST(TableChoice, IsTheCheapestThatKeepsTheAccuracy) {
  const AnyScheme given("rsid", 0.1);
  const RadiusRange range{20.0, 30.0};
  const std::vector<LookUpNeed> many(200'000, LookUpNeed{30.0, 0.1});
  const TableChoice coarse = choose_table(many, 1, range, 0.5, given);
  const TableChoice fine = choose_table(many, 1, range, 0.1, given);
  EXPECT_FALSE(coarse.rays_only);
  EXPECT_EQ(coarse.storage, Storage::sixteen_bits);
  EXPECT_LE(first_order_error(many[0], coarse.scheme.stencil_radius()), 0.5);
  EXPECT_LT(coarse.scheme.size(), 100'000U);
  EXPECT_FALSE(fine.rays_only);
  EXPECT_LE(first_order_error(many[0], fine.scheme.stencil_radius()), 0.1);
  EXPECT_LT(fine.scheme.stencil_radius(), coarse.scheme.stencil_radius());
  EXPECT_TRUE(choose_table(many, 1, range, 0.005, given).rays_only);
  EXPECT_TRUE(choose_table(std::span(many).first(100), 1, range, 0.5, given).rays_only);
  EXPECT_EQ(choose_table(many, 1, range, 1e-5, given).storage, Storage::single_precision);
  EXPECT_EQ(choose_table(many, 1, range, 1e-7, given).storage, Storage::double_precision);
}

// Mutants: a plan that leaves out too much is caught by the comparison.
class SceneMutant : public ::testing::Test {
 protected:
  SceneMutant() {
    needs_.question = Question::first_contact;
    needs_.poses = {motion()[2]};
  }
  ScenePlan plan(Omissions omissions = Omissions::all()) const {
    return plan_scene(joint_, needs_, AnyScheme("rsid", kPrecision), omissions);
  }
  bool caught(const ScenePlan& mutant) const {
    return !same_answer(answer_scene(joint_, needs_, mutant), answer(joint_, needs_, Omissions::none()));
  }

  BallSocketPair joint_ = cam();
  SceneNeeds needs_;
};

TEST_F(SceneMutant, APlanAsItIsPasses) { EXPECT_FALSE(caught(plan())); }

TEST_F(SceneMutant, VerticesOfTheOtherHalfAreMissed) {
  ScenePlan mutant = plan();
  for (ScanPlan& scan : mutant.scans) {
    if (scan.vertices) scan.vertices->front().clear();
  }
  EXPECT_TRUE(caught(mutant));
}

TEST_F(SceneMutant, AScanIsDroppedThatMatters) {
  ScenePlan mutant = plan(Omissions::all().without(Omission::vertices));
  mutant.scans[answer(joint_, needs_, Omissions::none()).smallest->scanned == Surface::ball ? 0 : 1].wanted =
      false;
  EXPECT_TRUE(caught(mutant));
}

// A reach of one stencil radius is what the proof asks for: entries of another, smaller set are missed.
TEST_F(SceneMutant, EntriesAreMissing) {
  needs_.question = Question::all_gaps;
  ScenePlan mutant = plan();
  for (ScanPlan& scan : mutant.scans) {
    EntrySet fewer(mutant.table.scheme.size());
    std::size_t k = 0;
    scan.entries->for_each([&](std::size_t entry) {
      if (++k % 100 != 0) fewer.insert(entry);
    });
    fewer.number();
    scan.entries = std::move(fewer);
  }
  EXPECT_TRUE(caught(mutant));
}

// Vertices near a rim may have a gap, too.
TEST_F(SceneMutant, VerticesBesideARimAreMissed) {
  needs_.question = Question::all_gaps;
  ScenePlan mutant = plan();
  const NearFaces& faces = *mutant.scans[0].faces;
  std::vector<std::uint32_t>& vertices = mutant.scans[0].vertices->front();
  const std::size_t missed = std::erase_if(vertices, [&](std::uint32_t v) {
    return faces.near(to_socket(needs_.poses[0], joint_.ball.vertices[v])).rim;
  });
  EXPECT_GT(missed, 0U);
  EXPECT_FALSE(vertices.empty());
  EXPECT_TRUE(caught(mutant));
}

TEST(ScenePlanned, WhatAsksNothingIsRefused) {
  const BallSocketPair joint = make_ball_socket_pair(100);
  const AnyScheme scheme("rsid", 5.0);
  SceneNeeds needs;
  needs.poses.clear();
  EXPECT_THROW(plan_scene(joint, needs, scheme, Omissions::all()), std::invalid_argument);
  needs = {};
  needs.ball = needs.socket = false;
  EXPECT_THROW(plan_scene(joint, needs, scheme, Omissions::all()), std::invalid_argument);
  needs = {};
  needs.accuracy_mm = 0.0;
  EXPECT_THROW(plan_scene(joint, needs, scheme, Omissions::all()), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
