// SPDX-License-Identifier: GPL-3.0-or-later
// The interval of a limit holds for random centres within the distance, on its sphere and inside: about each
// of them surfaces meet in no pose up to the lower end, and have met up to the upper end.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limits/centre_walls.hpp"
#include "limits/turn_limit.hpp"
#include "limits/turn_oracle.hpp"
#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/jump_edges.hpp"
#include "mesh/triangle_distance.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

using test::Dice;

constexpr int kCentres = 4;

constexpr double kLargest = 170.0;    // degrees, of a motion
constexpr long double kNear = 1e-6L;  // mm: surfaces that come as near as that perhaps meet

struct CentreCase {
  BallSocketPair joint;
  JointTurn motion;
  CentreQuestion question;
};

struct CentreCounts {
  std::size_t limited = 0;  // at the origin
  std::size_t bounded = 0;  // with a proven upper end
  std::size_t lower = 0;    // with a lower end above 0
};

test::OracleCentre centre_within(const CentreQuestion& question, Dice& random) {
  const double length =
      question.within_mm * (random.between(0.0, 1.0) < 0.7 ? 1.0 : random.between(0.0, 1.0));
  const Vec3 by = random.rotation() * Vec3(0, 0, 0.999999 * length);
  return question.doubt == CentreDoubt::common ? test::OracleCentre{by, Vec3::Zero()}
                                               : test::OracleCentre{Vec3::Zero(), by};
}

void check_interval(const CentreCase& given, Dice& random, std::size_t number, CentreCounts& counts) {
  const TurnLimits limits(given.joint);
  const TurnLimit limit = limits.first_contact(given.motion, kLargest);
  if (limit.state == LimitState::blocked) return;
  const CentreInterval interval = limits.centre_interval(given.motion, limit, kLargest, given.question);
  ASSERT_LE(interval.low_deg, limit.low_deg + 1e-9) << number;
  ASSERT_GE(interval.high_deg, limit.high_deg - 1e-9) << number;
  counts.limited += limit.state == LimitState::limited ? 1 : 0;
  counts.bounded += interval.limited ? 1 : 0;
  counts.lower += interval.low_deg > 0.0 ? 1 : 0;
  for (int k = 0; k < kCentres; ++k) {
    const test::TurnOracle oracle(given.joint, given.motion.axis, centre_within(given.question, random));
    for (const double share : {1.0, random.between(0.9, 1.0), random.between(0.0, 1.0)})
      ASSERT_FALSE(interval.low_deg > 0.0 && oracle.surely_meets(share * interval.low_deg)) << number;
    if (interval.limited) {
      ASSERT_TRUE(oracle.meets_by(interval.high_deg, kNear)) << number;
    }
  }
}

CentreQuestion random_question(CentreDoubt doubt, Dice& random) {
  return {.doubt = doubt, .within_mm = random.power(-2.0, 0.3)};
}

class TheoremCentre : public testing::TestWithParam<CentreDoubt> {};

INSTANTIATE_TEST_SUITE_P(Doubts, TheoremCentre, testing::Values(CentreDoubt::common, CentreDoubt::play),
                         [](const auto& of) { return of.param == CentreDoubt::common ? "Common" : "Play"; });

TEST_P(TheoremCentre, OfLooseTriangles) {
  Dice random(11);
  CentreCounts counts;
  const std::size_t cases = random_cases() / 2;
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    CentreCase given;
    for (int f = 0; f < 2; ++f) {
      for (TriangleMesh* mesh : {&given.joint.ball, &given.joint.socket}) {
        const Vec3 middle = random.rotation() * Vec3(0, 0, random.between(4.0, 25.0));
        const double size = random.power(0.0, 1.2);
        const auto corner = [&] { return Vec3(middle + random.rotation() * Vec3(0, 0, size)); };
        test::add_face(*mesh, corner(), corner(), corner());
      }
    }
    given.motion.axis = random.rotation() * Vec3::UnitX();
    given.question = random_question(GetParam(), random);
    check_interval(given, random, k, counts);
  }
  EXPECT_GT(counts.limited, cases / 10);
  EXPECT_GT(counts.lower, cases / 4);
}

// A ball with a spike below a roof of four faces: the spike turns into the roof, or behind its rim.
TEST_P(TheoremCentre, OfASpikeBelowARoof) {
  Dice random(12);
  CentreCounts counts;
  const std::size_t cases = random_cases() / 8;
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    CentreCase given{
        {octahedron(10.0), test::inside_out(octahedron(26.0))}, {}, random_question(GetParam(), random)};
    given.joint.ball.vertices[1] *= random.between(1.2, 3.5);
    std::erase_if(given.joint.socket.faces, [&](const Face& face) {
      Vec3 middle = Vec3::Zero();
      for (const VertexIndex v : face) middle += given.joint.socket.vertices[v];
      return middle.z() < 0.0;
    });
    const Eigen::Matrix3d before = random.rotation();
    for (Vec3& x : given.joint.ball.vertices) x = before * x;
    for (Vec3& x : given.joint.socket.vertices) x *= random.between(0.8, 1.2);
    given.motion.axis = random.rotation() * Vec3::UnitX();
    check_interval(given, random, k, counts);
  }
  EXPECT_GT(counts.limited, cases / 10);
  EXPECT_GT(counts.bounded, cases / 20);
  EXPECT_GT(counts.lower, cases / 10);
}

// A sheet that slopes from 28 mm to 22 about the azimuth `at`, as wide as that on both sides of z = 0; faces
// towards the centre. Its ends are far off.
TriangleMesh slope(double at, double below, double above, double sag = 0.0) {
  const auto place = [&](double along, double z) {
    const double azimuth = at + 0.4 * along;
    const double radius = 25.0 - 3.0 * along;
    return Vec3(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
  };
  TriangleMesh mesh{{place(-1, -below), place(1, -below), place(1, above), place(-1, above),
                     place(0, 0.5 * (above - below))},
                    {{1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}}};
  mesh.vertices[4] *= 1.0 - sag / 25.0;
  return mesh;
}

// A head, and far out a small face that leads with a corner.
TriangleMesh head_with_a_tip() {
  TriangleMesh ball = octahedron(5.0);
  test::add_face(ball, {25, 0, 0}, Eigen::AngleAxisd(-1e-3, Vec3::UnitZ()) * Vec3(25, 0, 0.01),
                 Eigen::AngleAxisd(-1e-3, Vec3::UnitZ()) * Vec3(25, 0, -0.01));
  return ball;
}

// The tip crosses a sheet beside its rim: about other centres it may pass round that.
TEST_P(TheoremCentre, OfATipBesideARim) {
  Dice random(13);
  CentreCounts counts;
  const std::size_t cases = random_cases() / 25;
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    const double below = random.power(-2.0, 1.0);
    CentreCase given{{head_with_a_tip(), slope(random.between(0.7, 2.0), below, random.power(-2.0, 1.0))},
                     {.axis = Vec3::UnitZ()},
                     {.doubt = GetParam(), .within_mm = random.power(-2.0, 0.3)}};
    const Eigen::Matrix3d turned = random.rotation();
    for (TriangleMesh* mesh : {&given.joint.ball, &given.joint.socket}) *mesh = test::turned(*mesh, turned);
    given.motion.axis = turned * given.motion.axis;
    check_interval(given, random, k, counts);
  }
  EXPECT_EQ(counts.limited, cases);
  EXPECT_GT(counts.bounded, cases / 10);
  EXPECT_LT(counts.bounded, cases * 9 / 10);
}

// A threshold likewise. What was turned before the motion begins makes other centres shift the ball across
// the plane of the turn too.
TEST(TheoremCentre, OfAThresholdBesideARim) {
  Dice random(16);
  std::size_t bounded = 0;
  const std::size_t cases = random_cases() / 25;
  for (std::size_t k = 0; k < cases; ++k) {
    const BallSocketPair joint{
        head_with_a_tip(), slope(random.between(0.7, 2.0), random.power(-2.0, 1.0), random.power(-2.0, 1.0))};
    const JointTurn turn{.axis = Vec3::UnitZ(), .inner = random.rotation()};
    const CentreQuestion question{CentreDoubt::common, random.power(-2.0, 0.0), random.between(0.01, 0.1)};
    const TriangleMesh ball = test::turned(joint.ball, turn.inner.transpose());
    const TurnLimits limits({ball, joint.socket});
    const TurnLimit limit = limits.gap_of(turn, question.gap_mm, kLargest);
    const CentreInterval interval = limits.centre_interval(turn, limit, kLargest, question);
    bounded += interval.limited ? 1 : 0;
    for (int j = 0; interval.limited && j < kCentres; ++j) {
      const Vec3 t = centre_within(question, random).centre;
      const BallSocketPair about{test::turned(relative_to(ball, t), turn.inner),
                                 relative_to(joint.socket, t)};
      const test::TurnOracle oracle(about, turn.axis);
      bool reached = oracle.meets_by(interval.high_deg, kNear);
      for (double angle = interval.high_deg; angle > 0.0 && !reached; angle -= 0.02)
        reached = oracle.smallest_gap(angle, -test::TurnOracle::kMargin) <= question.gap_mm + 0.005;
      ASSERT_TRUE(reached) << k << ": " << interval.high_deg;
    }
  }
  EXPECT_GT(bounded, cases / 10);
}

// Up to the lower end no centre has the threshold. Against the turn above, the tip comes in under the rim
// that is nearest to the centre, where the gap jumps.
TEST(TheoremCentre, OfAThresholdHasNoneBeforeTheLowerEnd) {
  Dice random(26);
  std::size_t lower = 0;
  const std::size_t cases = random_cases() / 5;
  for (std::size_t k = 0; k < cases; ++k) {
    const BallSocketPair joint{head_with_a_tip(), slope(random.between(-2.0, -0.8), random.power(-2.0, 1.0),
                                                        random.power(-2.0, 1.0))};
    const JointTurn turn{.axis = -Vec3::UnitZ(), .inner = random.rotation()};
    const CentreQuestion question{random.sign() > 0.0 ? CentreDoubt::common : CentreDoubt::play,
                                  random.power(-2.0, 0.0), random.between(0.01, 0.1)};
    const TriangleMesh ball = test::turned(joint.ball, turn.inner.transpose());
    const TurnLimits limits({ball, joint.socket});
    const TurnLimit limit = limits.gap_of(turn, question.gap_mm, kLargest);
    const double low = limits.centre_interval(turn, limit, kLargest, question).low_deg;
    lower += low > 0.0 ? 1 : 0;
    for (int j = 0; low > 0.0 && j < 3 * kCentres; ++j) {
      const test::OracleCentre at = centre_within(question, random);
      const BallSocketPair about{test::turned(relative_to(ball, at.centre), turn.inner),
                                 relative_to(joint.socket, at.centre)};
      const test::TurnOracle oracle(about, turn.axis, {Vec3::Zero(), at.shift});
      for (const double angle : {low, random.between(0.95, 1.0) * low, random.between(0.0, 1.0) * low})
        ASSERT_GT(oracle.smallest_gap(angle, 1e-9L), question.gap_mm - 1e-9) << k << ": " << angle;
    }
  }
  EXPECT_GT(lower, cases / 4);
}

// Three sheets with one border, which is none of the mesh: the tip crosses all three, and with play passes
// beside them.
TEST_P(TheoremCentre, OfSheetsThatShareABorder) {
  Dice random(14);
  CentreCounts counts;
  for (std::size_t k = 0; k < 50 && !HasFailure(); ++k) {
    const double width = random.between(0.2, 1.5);
    const double at = random.between(0.7, 2.0);
    TriangleMesh bubble = slope(at, width, width);
    for (const double sag : {-0.3, 0.3}) {
      const TriangleMesh layer = slope(at, width, width, sag);
      bubble.vertices.push_back(layer.vertices[4]);
      const auto middle = static_cast<VertexIndex>(bubble.vertices.size() - 1);
      for (const Face& face : layer.faces) bubble.faces.push_back({face[0], face[1], middle});
    }
    const CentreCase given{{head_with_a_tip(), bubble},
                           {.axis = Vec3::UnitZ()},
                           {.doubt = GetParam(), .within_mm = random.between(0.5, 1.5)}};
    check_interval(given, random, k, counts);
  }
  EXPECT_EQ(counts.limited, 50U);
}

// The tip crosses a closed slab beside a sheet. In the plane of the turn the slab has an edge on its front
// and none on its back: rays there meet two faces and one.
TEST_P(TheoremCentre, OfASlabWithAnEdgeInThePlaneOfTheTurn) {
  Dice random(15);
  CentreCounts counts;
  for (std::size_t k = 0; k < 50 && !HasFailure(); ++k) {
    const double width = random.between(0.2, 0.9);
    const double at = random.between(0.7, 2.0);
    TriangleMesh slab = slope(at, width, width, 0.0);
    const Vec3 middle = slab.vertices[4];
    slab.vertices[4] = 0.5 * (slab.vertices[0] + slab.vertices[3]);  // the front as two halves
    slab.vertices.push_back(0.5 * (slab.vertices[1] + slab.vertices[2]));
    slab.vertices.push_back(1.01 * middle + Vec3(0, 0, 0.1 * width));
    slab.faces = {{0, 4, 5}, {0, 5, 1}, {4, 3, 2}, {4, 2, 5}};
    for (const auto& [a, b] : {std::pair{0U, 1U}, {1U, 5U}, {5U, 2U}, {2U, 3U}, {3U, 4U}, {4U, 0U}})
      slab.faces.push_back({a, b, 6});
    TriangleMesh sheet;
    test::add_face(sheet, {-30, -10, 40}, {-30, 10, 40}, {-30, 0, -40});
    const CentreCase given{{head_with_a_tip(), test::joined(slab, sheet)},
                           {.axis = Vec3::UnitZ()},
                           {.doubt = GetParam(), .within_mm = random.between(1.0, 1.5)}};
    check_interval(given, random, k, counts);
  }
  EXPECT_EQ(counts.limited, 50U);
}

// The socket has no face but one whose plane holds the centre.
TEST_P(TheoremCentre, OfASocketThatIsEdgeOn) {
  TriangleMesh wall;
  test::add_face(wall, {0, 20, 10}, {0, 20, -10}, {0, 30, 0});
  const TurnLimits limits({head_with_a_tip(), wall});
  const JointTurn turn{.axis = Vec3::UnitZ()};
  const TurnLimit limit = limits.first_contact(turn, kLargest);
  EXPECT_NEAR(limit.high_deg, 90.0, 1e-6);
  for (const double gap : {0.0, 0.5}) {  // no ray meets the socket
    const CentreInterval interval = limits.centre_interval(turn, limit, kLargest, {GetParam(), 0.5, gap});
    EXPECT_GT(interval.low_deg, 80.0);
    EXPECT_GE(interval.high_deg, limit.high_deg);
  }
}

// A tip at 5 mm turns under, or over, a small sheet that it does not touch, 2 mm farther in, or out: it has
// the gap, and about centres on +z it passes beside the sheet. With these within r no upper end is proven.
TEST(TheoremCentre, OfAThresholdInASmallShadow) {
  struct Shadow {
    double sheet;   // mm from the centre
    double within;  // r
    bool near;      // is there another face, 1 mm from the centre?
  };
  for (const auto& [sheet, within, near] : {Shadow{3.0, 1.5, false}, {7.0, 1.1, false}, {3.0, 0.8, true}}) {
    const bool of_ball = sheet < 5.0;  // the tip
    const auto place = [&](double far, double degrees, double z) {
      const double at = (of_ball ? -degrees : degrees) * kDegree;
      return Vec3(far * std::cos(at), far * std::sin(at), z);
    };
    TriangleMesh tip;
    test::add_face(tip, place(5, 0, 0), place(5, 0.1, 0.01), place(5, 0.1, -0.01));
    TriangleMesh patch;
    test::add_face(patch, place(sheet, -20, 0.1), place(sheet, -20, -0.1), place(sheet, -24, 0));
    if (near) test::add_face(patch, {-1, -0.1, -0.1}, {-1, 0.1, -0.1}, {-1, 0, 0.1});
    const BallSocketPair joint = of_ball ? BallSocketPair{tip, patch} : BallSocketPair{patch, tip};
    const JointTurn turn{.axis = Vec3::UnitZ()};
    const TurnLimits limits(joint);
    const TurnLimit limit = limits.gap_of(turn, 0.7, 90.0);
    ASSERT_EQ(limit.state, LimitState::limited) << sheet;
    EXPECT_NEAR(limit.high_deg, 20.0, 0.1);
    const auto about = [&](double z) {
      return TurnLimits({relative_to(joint.ball, {0, 0, z}), relative_to(joint.socket, {0, 0, z})})
          .gap_of(turn, 0.7, 90.0)
          .state;
    };
    EXPECT_EQ(about(0.99 * within), LimitState::free) << sheet;
    for (const CentreDoubt doubt : {CentreDoubt::common, CentreDoubt::play})
      EXPECT_FALSE(limits.centre_interval(turn, limit, 90.0, {doubt, within, 0.7}).limited) << sheet;
    const auto low = [&](double r) {
      return limits.centre_interval(turn, limit, 90.0, {CentreDoubt::common, r, 0.7}).low_deg;
    };
    EXPECT_GT(low(0.02), 0.0) << sheet;
    if (near) {
      EXPECT_EQ(low(1.2), 0.0) << "a centre within r may be beyond a face";
    }
  }
}

// A start that is blocked: by bones for every common centre, as no turn has moved them; with play, where
// they are deep enough; a gap, or radii that overlap, only where rays from each centre find it.
TEST(TheoremCentre, OfABlockedStart) {
  const JointTurn turn{.axis = Vec3::UnitZ()};
  const auto interval = [](const BallSocketPair& joint, const CentreQuestion& question, double turned = 0.0) {
    const JointTurn begun{.axis = Vec3::UnitZ(),
                          .inner = Eigen::AngleAxisd(turned, Vec3::UnitX()).toRotationMatrix()};
    const TurnLimits limits(joint);
    const TurnLimit limit = question.gap_mm > 0.0 ? limits.gap_of(begun, question.gap_mm, 90.0)
                                                  : limits.first_contact(begun, 90.0);
    EXPECT_EQ(limit.state, LimitState::blocked);
    const CentreInterval said = limits.centre_interval(begun, limit, 90.0, question);
    EXPECT_EQ(said.low_deg, 0.0);
    EXPECT_EQ(said.high_deg, said.limited ? 0.0 : 90.0);
    return said.limited;
  };
  const BallSocketPair deep{octahedron(30.0), octahedron(20.0)};
  for (const double gap : {0.0, 0.5}) {
    EXPECT_TRUE(interval(deep, {CentreDoubt::common, 2.0, gap}));
    EXPECT_FALSE(interval(deep, {CentreDoubt::play, 30.0, gap}));
  }
  EXPECT_TRUE(interval(deep, {CentreDoubt::common, 0.5, 0.5}, 0.3)) << "the deepest vertex shows it";
  EXPECT_TRUE(interval(deep, {CentreDoubt::play, 0.5, 0.5}));
  // A tip 2 mm behind a sheet, and in front of it: about other centres it is beside it.
  TriangleMesh tip;
  test::add_face(tip, {5, 0, 0}, {5, 0.01, 0.01}, {5, 0.01, -0.01});
  for (const double sheet : {3.0, 6.0}) {
    TriangleMesh patch;
    test::add_face(patch, {sheet, -0.1, 0.1}, {sheet, -0.1, -0.1}, {sheet, 0.2, 0});
    const double gap = sheet < 5.0 ? 0.0 : 1.5;
    const TriangleMesh low = relative_to(tip, {0, 0, 1.5});
    const TriangleMesh beside = relative_to(patch, {0, 0, 1.5});
    const TurnLimits about({low, beside});
    EXPECT_EQ((gap > 0.0 ? about.gap_of(turn, gap, 90.0) : about.first_contact(turn, 90.0)).state,
              LimitState::free);
    for (const CentreDoubt doubt : {CentreDoubt::common, CentreDoubt::play})
      EXPECT_FALSE(interval({tip, patch}, {doubt, 1.5, gap})) << sheet;
    EXPECT_EQ(interval({tip, patch}, {CentreDoubt::common, 1e-3, gap}), gap > 0.0);
  }
}

// Parts that come together behind the angle at which other centres shift the ball the most.
TEST(TheoremCentre, OfPartsBehindTheLargestShift) {
  const auto sphere_at = [](double turned) {
    return test::moved(icosphere(7.0, 2),
                       40.0 * Vec3(std::cos(turned * kDegree), std::sin(turned * kDegree), 0.0));
  };
  const BallSocketPair main{icosphere(5.0, 2), cup(8.0, 60.0, 100)};
  const JointTurn turn{.axis = Vec3::UnitZ(),
                       .inner = Eigen::AngleAxisd(-0.5 * kPi, Vec3::UnitZ()).toRotationMatrix()};
  const TurnLimits limits(main, {{sphere_at(190.0)}, {sphere_at(75.0)}});  // the turn begins at 100
  const TurnLimit limit = limits.first_contact(turn, 350.0);
  ASSERT_EQ(limit.state, LimitState::limited);
  EXPECT_NEAR(limit.low_deg, 360.0 - 25.0 - 2.0 * std::asin(7.0 / 40.0) / kDegree, 0.5);
  const CentreInterval interval = limits.centre_interval(turn, limit, 350.0, {CentreDoubt::common, 0.5, 0.0});
  EXPECT_TRUE(interval.limited);
  double least = 360.0;
  double most = 0.0;
  for (int k = 0; k < 6; ++k) {
    const Vec3 t = 0.499 * Vec3(std::cos(k * kPi / 3.0), std::sin(k * kPi / 3.0), 0.0);
    const TurnLimit found =
        TurnLimits({relative_to(main.ball, t), relative_to(main.socket, t)},
                   {{relative_to(sphere_at(190.0), t)}, {relative_to(sphere_at(75.0), t)}})
            .first_contact(turn, 350.0);
    least = std::min(least, found.low_deg);
    most = std::max(most, found.high_deg);
  }
  EXPECT_LT(interval.low_deg, least);
  EXPECT_GT(interval.low_deg, least - 1.0);
  EXPECT_GT(interval.high_deg, most);
}

// The jump edges about every centre within the distance are listed, and no others but those next to a plane
// that such a centre may pass.

using test::Dice;

constexpr double kMeshRadius = 10.0;       // mm
constexpr double kShareInside = 0.999999;  // of r
constexpr int kOtherCentres = 5;           // besides those next to planes

// Folded, with holes, and with some faces turned round.
TriangleMesh random_surface(Dice& random) {
  TriangleMesh mesh = octahedron(kMeshRadius);
  const double moved = random.between(0.0, kMeshRadius);
  for (Vec3& x : mesh.vertices) x += random.rotation() * Vec3(0, 0, moved);
  std::erase_if(mesh.faces, [&](const Face&) { return random.between(0.0, 1.0) < 0.1; });
  for (Face& face : mesh.faces) {
    if (random.between(0.0, 1.0) < 0.2) std::swap(face[0], face[1]);
  }
  return mesh;
}

// On both sides towards every face, whose plane they pass if any centre within r does; and anywhere.
std::vector<Vec3> centres_within(const TriangleMesh& mesh, double r, Dice& random) {
  std::vector<Vec3> centres{Vec3::Zero()};
  for (const Face& face : mesh.faces) {
    const Vec3 way = kShareInside * r * area_vector(mesh, face).normalized();
    centres.insert(centres.end(), {way, -way});
  }
  for (int k = 0; k < kOtherCentres; ++k)
    centres.emplace_back(random.rotation() * Vec3(0, 0, r * random.between(0.0, kShareInside)));
  return centres;
}

std::set<Edge> jumps_about(TriangleMesh mesh, const Vec3& centre) {
  for (Vec3& x : mesh.vertices) x -= centre;
  std::set<Edge> edges;
  for (const JumpEdge& jump : jump_edges(mesh)) edges.insert({jump.from, jump.to});
  return edges;
}

// Edges of faces whose planes are as near as that.
std::set<Edge> edges_near(const TriangleMesh& mesh, double r) {
  std::set<Edge> near;
  for_each_edge(mesh, [&](std::span<const HalfEdge> uses) {
    const auto is_near = [&](HalfEdge h) {
      const Face& face = mesh.faces[h.face];
      return std::abs(area_vector(mesh, face).normalized().dot(corner(mesh, face, 0))) <= r;
    };
    if (std::ranges::any_of(uses, is_near)) near.insert(ends(mesh, uses.front()));
  });
  return near;
}

TEST(CentreWalls, AreOfTheEdgesThatMayJump) {
  Dice random(22);
  std::size_t edges = 0;
  std::size_t listed = 0;
  const std::size_t cases = random_cases();
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    const TriangleMesh mesh = random_surface(random);
    const double r = random.power(-2.0, 0.7);
    const std::vector<Edge> list = possible_jumps(mesh, r);
    const std::set<Edge> possible(list.begin(), list.end());
    for (const Vec3& centre : centres_within(mesh, r, random))
      ASSERT_TRUE(std::ranges::includes(possible, jumps_about(mesh, centre))) << k;
    std::set<Edge> allowed = edges_near(mesh, (1.0 + 1e-9) * r);
    allowed.merge(jumps_about(mesh, Vec3::Zero()));
    ASSERT_TRUE(std::ranges::includes(allowed, possible)) << k;
    edges += impinge::edges(mesh).size();
    listed += list.size();
  }
  EXPECT_GT(listed, edges / 5);
  EXPECT_LT(listed, edges * 4 / 5);
}

// The walls of an edge are wherever a point can meet them: no k y farther from it than the shift, the
// threshold and what other centres add has its triangles farther from it than these and their doubt.
TEST(CentreWalls, AreWhereAPointMayMeetThem) {
  Dice random(23);
  std::array<std::size_t, 3> of_kind{};  // of an edge that passes the centre, near the centre, and other ones
  for (std::size_t k = 0; k < random_cases() / 2 && !HasFailure(); ++k) {
    const auto corner = [&] { return Vec3(random.power(-1.0, 1.3) * random.direction()); };
    const TriangleMesh mesh{{corner(), corner()}, {}};
    WallQuestion asked{k % 2 == 0, k % 3 != 0, random.power(-2.0, 0.5), random.power(-1.0, 0.5)};
    asked.nearest = random.power(-2.0, 1.0);
    asked.farthest = asked.nearest * random.power(0.0, 1.0);
    const std::vector<TurnFace> walls = shells(mesh, {{0, 1}}, asked);
    const double nearest =
        std::sqrt(squared_distance_to_segment(Vec3::Zero(), mesh.vertices[0], mesh.vertices[1]));
    for (int j = 0; j < 30; ++j) {
      const double along = random.between(0.0, 1.0);
      const Vec3 y = (1.0 - along) * mesh.vertices[0] + along * mesh.vertices[1];
      const double shift = random.between(0.0, asked.common ? 2.0 : 1.0) * asked.r;
      const double l = asked.beyond ? random.power(0.0, 2.0) : random.between(0.0, 1.0);
      const double more = asked.common || asked.beyond ? std::abs(l - 1.0) * asked.r : 0.0;
      const double within = (asked.beyond || !asked.common ? shift : l * shift) + asked.gap + more;
      const Vec3 p = l * y + random.between(0.0, 1.0) * within * random.direction();
      if (p.norm() < asked.nearest || p.norm() > asked.farthest) continue;
      double least = HUGE_VAL;
      for (const TurnFace& face : walls) {
        const auto& [a, b, c] = face.corner;
        least = std::min(least, std::sqrt(squared_distance_to_triangle(p, a, b, c)) - face.doubt);
      }
      ASSERT_LE(least, shift + asked.gap + 1e-9) << k << ": " << l;
      ++of_kind[nearest <= asked.r ? 0 : l < 0.05 ? 1 : 2];
    }
  }
  for (const std::size_t found : of_kind) EXPECT_GT(found, 20U);
}

// Walls within an edge are made of k times its points, k from 0 to 1, where other centres add (1 - k) r: the
// most at the least k of a triangle.
TEST(CentreWalls, WithinAnEdgeAreNoFartherAndNoMoreInDoubtThanTheyMustBe) {
  Dice random(24);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const auto corner = [&] { return Vec3(random.power(0.0, 1.3) * random.direction()); };
    const TriangleMesh mesh{{corner(), corner()}, {}};
    WallQuestion asked{false, k % 2 == 0, random.power(-2.0, 0.0), random.power(-1.0, 0.5)};
    asked.nearest = random.power(-1.0, 1.0);
    asked.farthest = asked.nearest * random.power(0.0, 1.0);
    for (const TurnFace& face : shells(mesh, {{0, 1}}, asked)) {
      double least = 1.0;
      for (const Vec3& x : face.corner) {
        const Vec3& of = mesh.vertices[x.normalized().dot(mesh.vertices[0].normalized()) >
                                               x.normalized().dot(mesh.vertices[1].normalized())
                                           ? 0
                                           : 1];
        EXPECT_LE(x.norm(), of.norm() * (1.0 + 1e-12));
        least = std::min(least, x.norm() / of.norm());
      }
      EXPECT_NEAR(face.doubt, asked.common ? (1.0 - least) * asked.r : 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace impinge
