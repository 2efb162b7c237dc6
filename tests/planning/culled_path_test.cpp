// SPDX-License-Identifier: GPL-3.0-or-later
// A path of so many poses that whole caps of vertices are decided at once has the answers of the scans of
// whole tables, bit for bit: which poses touch, and the smallest gap with its place. So has one with vertices
// that are proven to touch and have no answer, for being next to a rim of the table.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "harness/answer_difference.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "planning/reachable.hpp"
#include "planning/scene_answer.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

using namespace lab;

constexpr double kPathPrecision = 2.0;  // degrees

SceneAnswer answer_at(double precision, const BallSocketPair& joint, const SceneNeeds& needs,
                      Omissions omissions) {
  const FillFull filler = [precision](const TriangleMesh& mesh, Layer layer) {
    return std::make_unique<FullTable<Rsid>>(fill_exact(mesh, Rsid::with_precision(precision), layer));
  };
  return answer_scene(joint, needs, AnyScheme("rsid", precision), omissions, filler);
}

// The cam comes under the socket after a third of the way.
std::vector<Pose> long_path(std::size_t poses) {
  std::vector<Pose> path;
  for (std::size_t k = 0; k < poses; ++k) {
    const double angle = 90.0 * static_cast<double>(k) / static_cast<double>(poses - 1);
    path.push_back({Eigen::AngleAxisd(-angle * kDegree, Vec3::UnitY()).toRotationMatrix(), Vec3::Zero()});
  }
  return path;
}

class CulledPath : public ::testing::TestWithParam<Question> {
 protected:
  void expect_same(const SceneNeeds& needs) const {
    const SceneAnswer everything = answer_at(kPathPrecision, joint_, needs, Omissions::none());
    EXPECT_FALSE(everything.path.culled);
    for (const Omissions omissions : {Omissions::none().with(Omission::single_vertices), Omissions::all()}) {
      const SceneAnswer planned = answer_at(kPathPrecision, joint_, needs, omissions);
      EXPECT_TRUE(planned.path.culled);
      EXPECT_TRUE(same_answer(planned, everything));
      EXPECT_LT(planned.cost.look_ups, everything.cost.look_ups / 10);
    }
  }

  BallSocketPair joint_ = make_ball_socket_pair(500, impinging_cam());
};

TEST_P(CulledPath, HasTheAnswersOfTheScans) {
  SceneNeeds needs;
  needs.question = GetParam();
  needs.poses = long_path(500);
  expect_same(needs);
  needs.socket = false;
  expect_same(needs);
}

TEST_P(CulledPath, HasThemFarFromAnyPathToo) {
  SceneNeeds needs;
  needs.question = GetParam();
  needs.poses = test::random_poses(180, 1.5, 4.5, 31);
  const auto near = test::random_poses(180, 0.1, 0.3, 32);
  needs.poses.insert(needs.poses.end(), near.begin(), near.end());
  expect_same(needs);
}

INSTANTIATE_TEST_SUITE_P(Questions, CulledPath, ::testing::Values(Question::touch, Question::first_contact));

// By the table of the other surface, mm; NaN for none.
double gap_in_table(const RadialTable<Rsid>& table, Surface scanned, const Vec3& x) {
  const double gap = table.radius_at(x) - x.norm();
  return scanned == Surface::ball ? gap : -gap;
}

bool lists(const std::vector<Reachable>& found, std::uint32_t vertex) {
  return std::ranges::any_of(found, [vertex](const Reachable& r) { return r.vertex == vertex; });
}

// What two ways found of one scan in one pose.
struct Listed {
  const std::vector<Reachable>& whole;
  const std::vector<Reachable>& culled;
  double limit_mm;
};

// Each vertex whose gap in the table is at the limit or less is listed by both; caps list none at the limit
// or less that looking at each leaves out. Returns how many such gaps there are.
std::size_t expect_listed(const Listed& listed, const std::vector<double>& gaps) {
  for (const Reachable& r : listed.culled)
    EXPECT_TRUE(r.low > listed.limit_mm || lists(listed.whole, r.vertex)) << r.vertex;
  std::size_t matter = 0;
  for (std::uint32_t v = 0; v < gaps.size(); ++v) {
    if (!(gaps[v] <= listed.limit_mm)) continue;
    ++matter;
    EXPECT_TRUE(lists(listed.culled, v)) << v;
    EXPECT_TRUE(lists(listed.whole, v)) << v;
  }
  return matter;
}

// So it is in every pose in which no vertex is proven to touch.
TEST(Reach, BothWaysListWhatMatters) {
  const BallSocketPair joint = make_ball_socket_pair(500, impinging_cam());
  const AnyScheme scheme("rsid", kPathPrecision);
  const Rsid rsid = Rsid::with_precision(kPathPrecision);
  const std::array tables{fill_exact(joint.socket, rsid, Layer::nearest),
                          fill_exact(joint.ball, rsid, Layer::farthest)};
  for (const Question question : {Question::touch, Question::first_contact}) {
    SceneNeeds needs;
    needs.question = question;
    needs.poses = long_path(20);
    std::vector<std::size_t> poses;
    for (std::size_t p = 0; p < needs.poses.size(); ++p) poses.push_back(p);
    std::array<ScanPlan, 2> scans;
    scans[1].scanned = Surface::socket;
    for (ScanPlan& scan : scans)
      scan.faces = std::make_unique<NearFaces>(mesh_of(joint, other(scan.scanned)), scheme.stencil_radius());
    const Reach whole = find_reach({joint, needs, poses, scans, false}, scheme.stencil_radius());
    const Reach culled = find_reach({joint, needs, poses, scans, true}, scheme.stencil_radius());
    EXPECT_EQ(whole.limit_mm, culled.limit_mm);
    EXPECT_EQ(whole.touches, culled.touches);
    EXPECT_EQ(std::ranges::count(whole.touches, true) > 5, question == Question::touch);
    EXPECT_EQ(whole.bytes, 0U);
    EXPECT_GT(culled.bytes, 0U);
    std::size_t matter = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const Surface scanned = scans[k].scanned;
      for (const std::size_t p : poses) {
        if (whole.touches[p]) continue;
        std::vector<double> gaps;
        for (const Vec3& v : mesh_of(joint, scanned).vertices)
          gaps.push_back(gap_in_table(tables[k], scanned, to_other(scanned, needs.poses[p], v)));
        matter += expect_listed({whole.found[k][p], culled.found[k][p], culled.limit_mm}, gaps);
      }
    }
    EXPECT_GT(matter, 0U);
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
TEST(Reach, HoldsForTablesThatReadFromAfar) {
  const Rsid scheme = Rsid::with_precision(15.0);
  const BallSocketPair joint{sphere(23.0, 400), dented(sphere(25.0, 5000), scheme)};
  const auto table = fill_exact(joint.socket, scheme, Layer::nearest);
  SceneNeeds needs;
  needs.question = Question::touch;
  needs.socket = false;
  needs.poses = test::random_poses(5, 3.0, 0.3, 34);
  const std::vector<std::size_t> poses{0, 1, 2, 3, 4};
  std::array<ScanPlan, 2> scans;
  scans[1].wanted = false;
  scans[0].faces = std::make_unique<NearFaces>(joint.socket, scheme.stencil_radius());
  const Reach reach = find_reach({joint, needs, poses, scans, true}, scheme.stencil_radius());
  std::size_t clear = 0;
  for (const std::size_t p : poses) {
    ASSERT_FALSE(reach.touches[p]);
    for (std::uint32_t v = 0; v < joint.ball.vertices.size(); ++v) {
      const Vec3 x = to_socket(needs.poses[p], joint.ball.vertices[v]);
      if (table.radius_at(x) > x.norm()) continue;
      EXPECT_TRUE(std::ranges::any_of(reach.found[0][p], [&](const Reachable& r) { return r.vertex == v; }));
      if (scans[0].faces->radius(x.normalized(), Layer::nearest) > x.norm()) ++clear;
    }
  }
  EXPECT_GT(clear, 20U) << "the faces alone would miss them";
}

// What the plan took for proven and the answer has not is not kept, whatever the other poses have.
TEST(Promises, AreKeptPoseByPose) {
  SceneNeeds needs;
  needs.question = Question::touch;
  needs.poses.resize(3);
  ScenePlan plan(AnyScheme("rsid", kPathPrecision));
  plan.poses = {0, 1};
  plan.same_as = {0, 1, 0};
  SceneAnswer answer;
  answer.touches = {true, false, true};
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
