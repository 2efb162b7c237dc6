// SPDX-License-Identifier: GPL-3.0-or-later
// The first contacts that families know are those of the bones, by CGAL's exact predicates on all pairs of
// faces: none just before, one just behind, whatever k.
#include "stress/known_turn.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "reference/meeting_surfaces.hpp"

namespace impinge::lab {
namespace {

bool meet(const KnownTurn& known, double angle) {
  const Eigen::AngleAxisd by(angle, known.turn.axis);
  TriangleMesh ball = known.bones.ball;
  for (Vec3& x : ball.vertices) x = by * (known.turn.inner * x);
  return surfaces_meet(ball, known.bones.socket);
}

// `doubt`: radians by which rounding may move the contact.
void expect_first_contact(const KnownTurn& known, double doubt) {
  ASSERT_TRUE(known.contact.has_value());
  const double contact = *known.contact;
  EXPECT_FALSE(meet(known, contact - doubt));
  EXPECT_TRUE(meet(known, std::min(contact + doubt, known.deepest)));
  EXPECT_GT(known.depth_mm, 0.0);
  EXPECT_TRUE(meet(known, known.deepest));
  for (double share = 0.0; share < 0.999; share += 0.05) EXPECT_FALSE(meet(known, share * contact)) << share;
  // The distance falls by `rate` a radian: so far from the contact it is that much, to first order.
  EXPECT_GT(known.rate, 0.0);
}

TEST(KnownTurn, ARidgeGrazesWhereItIsSaid) {
  for (std::size_t k = 0; k < 12; ++k) {
    for (const double depth : {1e-1, 1e-4, 1e-8}) {
      const KnownTurn known = grazing_ridges(k, depth);
      expect_first_contact(known, 1e-6 * (known.deepest - *known.contact));
      EXPECT_NEAR(known.depth_mm, depth, 1e-14);
      EXPECT_FALSE(meet(known, 2.0 * known.deepest - *known.contact + 1e-6)) << "it has passed";
    }
  }
}

TEST(KnownTurn, RidgesMeetWhereverTheyPoint) {
  for (std::size_t k = 0; k < 12; ++k) {
    for (const double between : {1.0, 1e-3, 1e-9, 0.0})
      expect_first_contact(meeting_ridges(k, between), 1e-14);
  }
}

TEST(KnownTurn, ATipMeetsTheSheetBesideItsBorder) {
  for (std::size_t k = 0; k < 12; ++k) {
    for (const double beside : {1.0, 1e-3, 1e-8}) {
      const KnownTurn known = tip_beside_opening(k, beside);
      expect_first_contact(known, 1e-13);
      if (k % 2 == 0) {
        EXPECT_FALSE(meet(known, *known.contact + beside)) << "it has gone through the opening";
      }
    }
    const KnownTurn beyond = tip_beside_opening(k, -1e-3);
    EXPECT_FALSE(meet(beyond, *beyond.contact + 1e-9)) << "there is no sheet";
  }
}

TEST(KnownTurn, BonePassesBehindBone) {
  for (std::size_t k = 0; k < 12; ++k) {
    for (const double distance : {1.0, 1e-3, 1e-6, 1e-12}) {
      const KnownTurn known = passing_behind(k, distance);
      EXPECT_FALSE(known.contact.has_value());
      EXPECT_NEAR(known.depth_mm, -distance, 1e-14);
      for (double share = 0.0; share < 2.0; share += 0.1) EXPECT_FALSE(meet(known, share * known.deepest));
    }
    const KnownTurn into = passing_behind(k, -1e-6);
    EXPECT_TRUE(meet(into, into.deepest)) << "as near as that";
  }
}

TEST(KnownTurn, ATipSlidesAlongTheFace) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double angle : {0.1, 1e-2, 1e-3}) {
      const KnownTurn known = sliding_tip(k, angle, 26.0);
      expect_first_contact(known, 1e-6 * angle);
      EXPECT_NEAR(known.deepest - *known.contact, angle, 1e-9);
    }
  }
}

// The judge of turns: what is right has no failure, and what is wrong has the right one.

std::vector<StabilityCase> judged(const std::function<KnownTurn(std::size_t)>& turn_at) {
  std::vector<KnownTurn> turns;
  for (std::size_t k = 0; k < 4; ++k) turns.push_back(turn_at(k));
  return judge_turns(1.0, turns);
}

StabilityCase of(const std::vector<StabilityCase>& cases, const std::string& method, double step = 0.0) {
  const auto found = std::ranges::find_if(
      cases, [&](const StabilityCase& c) { return c.method == method && c.precision_deg == step; });
  EXPECT_NE(found, cases.end()) << method;
  return found == cases.end() ? StabilityCase{} : *found;
}

TEST(JudgeTurns, TheFirstContactHoldsItsBracketAndStepsMissAGraze) {
  const auto cases = judged([](std::size_t k) { return grazing_ridges(k, 1e-6); });
  EXPECT_EQ(of(cases, "first_contact").failures(), 0U);
  EXPECT_TRUE(of(cases, "first_contact").bound_holds().value());
  EXPECT_EQ(of(cases, "exact_test").failures(), 0U);
  EXPECT_EQ(of(cases, "cgal_pairs").failures(), 0U);
  EXPECT_EQ(of(cases, "exact_test_in_steps", 1.0).missed_hits, 4U);
  EXPECT_EQ(of(cases, "vertex_gaps_in_steps", 0.1).missed_hits, 4U);
}

TEST(JudgeTurns, AContactThatIsNotThereIsFalse) {
  const auto cases = judged([](std::size_t k) { return passing_behind(k, 1e-6); });
  EXPECT_EQ(of(cases, "first_contact").failures(), 0U);
  EXPECT_EQ(of(cases, "vertex_gaps_in_steps", 0.1).false_hits, 4U) << "radii overlap, nothing touches";
  EXPECT_EQ(of(cases, "exact_test_in_steps", 0.1).failures(), 0U);
}

TEST(JudgeTurns, ATruthThatIsAMicrometreOffIsNotMet) {
  const auto cases = judged([](std::size_t k) {
    KnownTurn known = meeting_ridges(k, 1e-3);
    *known.contact += 1e-3 / known.rate;
    return known;
  });
  EXPECT_EQ(of(cases, "first_contact").wrong, 4U);
  EXPECT_FALSE(of(cases, "first_contact").bound_holds().value());
}

}  // namespace
}  // namespace impinge::lab
