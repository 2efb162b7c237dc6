// SPDX-License-Identifier: GPL-3.0-or-later
// What comes into a bone through an opening: poses, limits and their ranges for other centres. By the closed
// forms that bodies were made from, and by a stepped look at all faces.
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limits/mesh_end.hpp"
#include "limits/near_poses.hpp"
#include "limits/turn_limit.hpp"
#include "limits/turn_oracle.hpp"
#include "mesh/bodies.hpp"
#include "mesh/edges.hpp"
#include "mesh/icosphere.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/opened.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

constexpr double kFlaskAt = 50.0;     // mm from the axis, +z, to the middle of a flask
constexpr double kFlaskRadius = 8.0;  // of it
constexpr double kNeedle = 6.0;       // of a needle
constexpr double kBefore = 40.0;      // degrees that it is before the flask

TriangleMesh flask(const Vec3& towards, double angle) {
  return test::moved(test::opened(icosphere(kFlaskRadius, 4), towards, angle), {kFlaskAt, 0, 0});
}

// Along its way, whose direction is +y in the middle of the flask.
TriangleMesh needle(double degrees) {
  TriangleMesh mesh = octahedron(1.0);
  for (Vec3& x : mesh.vertices) x = Vec3(kFlaskAt + 0.1 * x.x(), 0.5 * kNeedle * x.y(), 0.1 * x.z());
  return test::turned(mesh, degrees * kDegree, Vec3::UnitZ());
}

BallSocketPair joint_beside() { return {icosphere(5.0, 2), cup(8.0, 60.0, 100)}; }

const JointTurn kTurnIn{.axis = Vec3::UnitZ()};
constexpr double kMostDegrees = 60.0;

// Up to the upper end surfaces have met about each of these centres; returns whether there is one.
bool check_range(const TriangleMesh& bone, const TurnLimits& limits, const TurnLimit& limit) {
  const CentreQuestion question{CentreDoubt::common, 1.0, 0.0};
  const CentreInterval range = limits.centre_interval(kTurnIn, limit, kMostDegrees, question);
  EXPECT_LE(range.low_deg, limit.low_deg);
  test::Dice dice(3);
  for (int k = 0; range.limited && k < 20; ++k) {
    const test::TurnOracle oracle({needle(-kBefore), bone}, kTurnIn.axis,
                                  {0.999 * dice.direction(), Vec3::Zero()});
    EXPECT_TRUE(oracle.meets_by(range.high_deg, 1e-6L)) << k << ": " << range.high_deg;
  }
  return range.limited;
}

// The needle turns in through a hole and on to the wall behind: whatever the hole is of, no centre's surfaces
// are said to have met before they have. The hole closes within its box, where the needle's tip begins to be
// inside. Of a bowl, a sheet, surfaces alone are asked, and behind them nothing is known.
TEST(Openings, LetANeedleIn) {
  for (const double angle : {0.35, 0.5, 0.8, 1.5}) {
    const TriangleMesh bone = flask(-Vec3::UnitY(), angle);
    const TurnLimits limits(joint_beside(), {{needle(-kBefore)}, {bone}});
    const TurnLimit limit = limits.first_contact(kTurnIn, kMostDegrees);
    const double inside = kBefore + 1.0;  // degrees
    EXPECT_EQ(limits.verdict(kTurnIn, inside).contact, angle > 0.7 ? Contact::unknown : Contact::yes)
        << angle;
    EXPECT_EQ(limits.verdict(kTurnIn, inside).rule, ContactRule::inside) << angle;
    EXPECT_FALSE(check_range(bone, limits, limit)) << angle;
    ASSERT_EQ(limit.state, LimitState::limited) << angle;
    const double tip = std::atan2(0.5 * kNeedle, kFlaskAt) / kDegree;
    const double wall = kBefore + std::asin(kFlaskRadius / kFlaskAt) / kDegree - tip;
    if (angle > 0.7) {
      EXPECT_NEAR(limit.low_deg, wall, 0.3);
      continue;
    }
    const auto at = [&](double y) { return kBefore + std::asin(y / kFlaskAt) / kDegree - tip; };
    EXPECT_GT(limit.low_deg, at(-kFlaskRadius - 0.1)) << angle;
    EXPECT_LT(limit.low_deg, at(-kFlaskRadius * std::cos(angle)) + 0.2) << angle;
    EXPECT_GT(limit.high_deg, limit.low_deg);
    EXPECT_LT(limit.high_deg, at(-kFlaskRadius * std::cos(angle)) + 0.8) << angle;
  }
}

// A hole farther from the axis than what is met changes nothing.
TEST(Openings, ElsewhereLeaveALimitAndItsRange) {
  const TriangleMesh whole = flask(Vec3::UnitX(), 0.0);
  const TurnLimit expected =
      TurnLimits(joint_beside(), {{needle(-kBefore)}, {whole}}).first_contact(kTurnIn, kMostDegrees);
  for (const double angle : {0.1, 0.35, 0.5}) {
    const TriangleMesh bone = flask(Vec3::UnitX(), angle);
    ASSERT_FALSE(boundary_edges(bone).empty());
    const TurnLimits limits(joint_beside(), {{needle(-kBefore)}, {bone}});
    const TurnLimit limit = limits.first_contact(kTurnIn, kMostDegrees);
    EXPECT_EQ(limit.state, LimitState::limited);
    EXPECT_NEAR(limit.low_deg, expected.low_deg, 1e-9);
    EXPECT_NEAR(limit.high_deg, expected.high_deg, 1e-9);
    EXPECT_TRUE(check_range(bone, limits, limit)) << angle;
  }
}

// Never inside, but through the box of the hole: unknown from there on.
TEST(Openings, PassedAtTheMouthAreUnknown) {
  TriangleMesh bone = flask(Vec3::UnitX(), 0.5);
  TriangleMesh probe = test::moved(octahedron(0.2), {kFlaskAt + kFlaskRadius * std::cos(0.45), 0, 0});
  probe = test::turned(probe, -kBefore * kDegree, Vec3::UnitZ());
  const TurnLimits limits(joint_beside(), {{probe}, {bone}});
  const TurnLimit limit = limits.first_contact(kTurnIn, kMostDegrees);
  EXPECT_NE(limit.state, LimitState::free);
  EXPECT_LT(limit.low_deg, kBefore);
  EXPECT_NE(limits.verdict(kTurnIn, kBefore).contact, Contact::no);
}

// A rod with a round head and a cut end, 150 mm below its centre; or closed there.
TriangleMesh rod(double radius, bool closed) {
  constexpr VertexIndex kRound = 24;
  TriangleMesh mesh;
  const auto ring = [&](double r, double z) {
    for (VertexIndex k = 0; k < kRound; ++k)
      mesh.vertices.emplace_back(r * std::cos(2.0 * kPi * k / kRound), r * std::sin(2.0 * kPi * k / kRound),
                                 z);
  };
  mesh.vertices.emplace_back(0, 0, radius);
  for (const double polar : {0.3, 0.6, 0.9, 1.2, 1.5})
    ring(radius * std::sin(polar), radius * std::cos(polar));
  ring(radius, -75.0);
  ring(radius, -150.0);
  for (VertexIndex k = 0; k < kRound; ++k) {
    const VertexIndex next = (k + 1) % kRound;
    mesh.faces.push_back({0, 1 + k, 1 + next});
    for (VertexIndex row = 1; row < 1 + 6 * kRound; row += kRound) {
      mesh.faces.push_back({row + k, row + k + kRound, row + next + kRound});
      mesh.faces.push_back({row + k, row + next + kRound, row + next});
    }
    if (closed)
      mesh.faces.push_back(
          {static_cast<VertexIndex>(mesh.vertices.size()), 1 + 6 * kRound + next, 1 + 6 * kRound + k});
  }
  if (closed) mesh.vertices.emplace_back(0, 0, -150.0);
  return mesh;
}

TriangleMesh head_of(TriangleMesh bone) {
  std::erase_if(bone.faces, [&](const Face& face) { return bone.vertices[face[1]].z() < 0.0; });
  return bone;
}

// A femur whose shaft is cut: what is in it is inside, wholly or with its tip, and what is below it is not.
TEST(Openings, OfACutShaftLeaveItsInside) {
  for (const bool closed : {true, false}) {
    for (const bool turned : {false, true}) {
      const Eigen::Matrix3d turn =
          turned ? Eigen::AngleAxisd(0.4, Vec3(1, 2, 0.3).normalized()).toRotationMatrix()
                 : Eigen::Matrix3d::Identity();
      const TriangleMesh femur = test::turned(rod(20.0, closed), turn);
      BoneParts bones;
      bones.whole_ball = femur;
      const BallSocketPair main{test::turned(head_of(rod(20.0, closed)), turn),
                                test::turned(cup(23.0, 60.0, 200), turn)};
      const auto said = [&](double z, double length) {
        BoneParts with = bones;
        TriangleMesh screw = octahedron(1.0);
        for (Vec3& x : screw.vertices) x = turn * Vec3(3.0 + x.x(), 2.0 + x.y(), z + 0.5 * length * x.z());
        with.socket.push_back(screw);
        return BodyPairs(main, with).verdict({}).contact;
      };
      EXPECT_EQ(said(-60.0, 30.0), Contact::yes);
      EXPECT_EQ(said(-120.0, 20.0), Contact::yes);
      EXPECT_EQ(said(-150.0, 120.0), Contact::yes) << "from below, with its tip";
      EXPECT_EQ(said(-220.0, 100.0), Contact::no);
      EXPECT_EQ(said(-152.0, 3.0), Contact::no);
    }
  }
}

// A pelvis whose back is cut open has an inside still: radii do not decide, what is in its bone is, and what
// is behind is not.
TEST(Openings, OfACutPelvisMakeItNoSheet) {
  const TriangleMesh inner = cup(26.0, 60.0, 400);
  const TriangleMesh back = test::opened(cup(30.0, 60.0, 400), Vec3(0.5, 0.0, 0.85).normalized(), 0.15);
  const TriangleMesh pelvis = test::with_back(inner, back);
  ASSERT_FALSE(boundary_edges(pelvis).empty());
  BoneParts whole;
  whole.whole_socket = pelvis;
  const BallSocketPair main{icosphere(1.0, 2), inner};
  const BodyPairs pairs(main, whole);
  EXPECT_TRUE(pairs.has_inside());
  const auto said = [&](const Vec3& at) { return pairs.verdict({Eigen::Matrix3d::Identity(), at}).contact; };
  EXPECT_EQ(said({0, 0, 20}), Contact::no);
  EXPECT_EQ(said({-14, 0, 24.2}), Contact::yes);
  EXPECT_EQ(said({-20, 0, 40}), Contact::no);
  EXPECT_NE(said({0.5 * 31, 0, 0.85 * 31}), Contact::yes);
}

// Patches between two meridians and two arcs of great circles over them turn past directions: where the
// cover of a direction ends is known in closed form.

using test::Dice;

constexpr std::size_t kPoints = 4;
constexpr double kFarthestEnd = 2.5;  // radians: no patch comes round again before

// Corners at latitudes +-height and at azimuths width before and behind its middle, radians.
struct Patch {
  double middle;
  double width;
  double height;

  double slope() const { return std::tan(height) / std::cos(width); }  // tan of the latitude amid the arcs
  // Angles at which it covers a direction; none if they end before they begin.
  AngleSpan over(double azimuth, double latitude) const {
    const double share = std::tan(std::abs(latitude)) / slope();
    const double half = std::abs(latitude) <= height ? width : share <= 1.0 ? std::acos(share) : -1.0;
    return {azimuth - middle - half, azimuth - middle + half};
  }
};

Vec3 direction(double azimuth, double latitude) {
  return turned(Vec3(std::cos(latitude), 0, std::sin(latitude)), azimuth);
}

// Borders may be at any radius.
void add_border(const Patch& patch, Dice& random, MeshEnd& end) {
  const auto first = static_cast<VertexIndex>(end.ball.size());
  for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    end.ball.emplace_back(random.between(10.0, 30.0) *
                          direction(patch.middle + x * patch.width, y * patch.height));
  for (VertexIndex k = 0; k < 4; ++k) end.border.push_back({first + k, first + (k + 1) % 4});
}

// One patch, or two, which may overlap: a border of one is then covered by the other.
struct EndCase {
  MeshEnd end;
  std::vector<std::vector<AngleSpan>> covered;  // of each point, by each patch
};

EndCase random_end(Dice& random) {
  EndCase made;
  std::vector<Patch> patches(random.between(0.0, 1.0) < 0.5 ? 1 : 2);
  for (Patch& patch : patches) {
    patch = {random.between(-1.0, 1.0), random.between(0.1, 1.3), random.between(0.1, 1.0)};
    add_border(patch, random, made.end);
  }
  for (std::size_t k = 0; k < kPoints; ++k) {
    const double azimuth = random.between(-1.0, 1.0);
    const double latitude = random.between(-0.999, 0.999) * std::atan(patches[0].slope());
    made.end.socket.emplace_back(random.between(20.0, 40.0) * direction(azimuth, latitude));
    auto& spans = made.covered.emplace_back();
    for (const Patch& patch : patches) spans.push_back(patch.over(azimuth, latitude));
  }
  return made;
}

// The end of the cover over an angle, by one patch after the other; nothing where there is none.
std::optional<double> end_of_cover(const std::vector<AngleSpan>& spans, double angle) {
  for (const AngleSpan& span : spans) {
    if (span.from <= angle && angle < span.to) return end_of_cover(spans, span.to).value_or(span.to);
  }
  return std::nullopt;
}

std::optional<double> known_end(const EndCase& given, double largest) {
  std::optional<double> first;
  for (const auto& spans : given.covered) {
    const std::optional<double> end = end_of_cover(spans, 0.0);
    if (end && *end <= first.value_or(largest)) first = end;
  }
  return first;
}

TEST(MeshEnd, IsWhereTheCoverOfADirectionEnds) {
  Dice random(23);
  std::size_t ended = 0;
  const std::size_t cases = random_cases();
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    EndCase given = random_end(random);
    given.end.covered = [&](std::size_t point, double angle) {
      return end_of_cover(given.covered[point], angle).has_value();
    };
    const double largest = random.between(0.0, kFarthestEnd);
    const std::optional<double> known = known_end(given, largest);
    const std::optional<double> found = first_beyond(given.end, largest);
    ASSERT_EQ(found.has_value(), known.has_value()) << k;
    if (!known) continue;
    ASSERT_NEAR(*found, *known, 1e-9) << k;
    ++ended;
  }
  EXPECT_GT(ended, cases / 4);
  EXPECT_LT(ended, cases * 3 / 4);
}

// A ray may have any direction where its point is shifted by more than its distance.
TEST(MeshEnd, IsAtTheStartForAPointThatIsShiftedPastTheCentre) {
  const MeshEnd end{{{20.0, 0.0, 0.0}, {0.0, 20.0, 0.0}, {0.0, 0.0, 20.0}},
                    {{0, 1}, {1, 2}, {2, 0}},
                    {{5.0, 5.0, 5.0}},
                    [](std::size_t, double) { return true; }};
  EXPECT_EQ(first_near_border(end, 1.0, 9.0, 0.0), 0.0);
  EXPECT_GT(first_near_border(end, 1.0, 0.1, 0.0).value_or(1.0), 0.1);
}

// A speck of a sheet in a flask of the ball, and radii that are clear: seen from the centre the flask is
// before the speck.
TEST(Openings, LetASheetIntoTheBall) {
  const TriangleMesh bottle =
      test::moved(test::opened(icosphere(8.0, 4), -Vec3::UnitZ(), 0.35), {0.0, 0.0, -60.0});
  for (const double place : {-60.0, -75.0}) {
    const BallSocketPair joint{
        test::joined(icosphere(20.0, 2), bottle),
        test::joined(cup(26.0, 60.0, 100), test::moved(octahedron(0.3), {0.0, 0.0, place}))};
    const BodyPairs bodies(joint, {});
    ASSERT_TRUE(bodies.has_radial());
    EXPECT_EQ(bodies.verdict({}).contact, place > -61.0 ? Contact::yes : Contact::no);
    EXPECT_EQ(bodies.may_meet({.turn = 0.01}, true).has_value(), place > -61.0);
    EXPECT_EQ(bodies.each_close({.turn = 0.01}, true, [](const ClosePair&) { return true; }), place < -61.0);
  }
}

// Each face twice changes nothing.
TEST(MeshEnd, IsFoundWhereFacesRepeat) {
  TriangleMesh ball = cup(20.0, 60.0, 1000);
  ball.faces.insert(ball.faces.end(), ball.faces.begin(), ball.faces.begin() + 1000);
  const TurnLimits limits({ball, cup(26.0, 20.0, 1000)});
  const TurnLimit limit = limits.first_contact({.axis = Vec3::UnitX()}, 90.0);
  ASSERT_TRUE(limit.leaves_mesh_deg);
  EXPECT_NEAR(*limit.leaves_mesh_deg, 40.0, 0.5);
}

// A shaft of 10 mm along z that is closed below and cut at z = 25, where its last faces are 0.01 mm high.
TEST(InnerBalls, KeepOffACut) {
  constexpr VertexIndex kCorners = 24;
  constexpr double kEnd = 25.0;
  TriangleMesh shaft;
  for (const double z : {-kEnd, kEnd - 0.01, kEnd})
    for (VertexIndex k = 0; k < kCorners; ++k) {
      const double azimuth = 2.0 * kPi * k / kCorners;
      shaft.vertices.emplace_back(10.0 * std::cos(azimuth), 10.0 * std::sin(azimuth), z);
    }
  shaft.vertices.emplace_back(0.0, 0.0, -kEnd);
  const VertexIndex below = 3 * kCorners;
  for (VertexIndex k = 0; k < kCorners; ++k) {
    const VertexIndex next = (k + 1) % kCorners;
    shaft.faces.push_back({below, next, k});
    for (VertexIndex ring = 0; ring < 2 * kCorners; ring += kCorners) {
      shaft.faces.push_back({ring + k, ring + next, ring + kCorners + next});
      shaft.faces.push_back({ring + k, ring + kCorners + next, ring + kCorners + k});
    }
  }
  const double within = 10.0 * std::cos(kPi / kCorners);
  const auto holds = [&](const Vec3& x) { return x.head<2>().norm() < within && std::abs(x.z()) < kEnd; };
  const SweptParts faces(turn_faces(shaft));
  const InnerBalls balls(faces, {holds, [&](const Vec3& x) { return kEnd - x.z(); }});
  for (const double turn : {1.0, 0.1, 0.01, 1e-4}) {
    const auto& found = balls.of(turn).parts();
    EXPECT_FALSE(found.empty());
    for (const TurnFace& ball : found) {
      const Vec3& x = ball.corner[0];
      EXPECT_GT(ball.doubt, 2.5e-4 * faces.nodes()[0].radius);  // smaller ones are left out
      EXPECT_LT(x.head<2>().norm() + ball.doubt, 10.0);
      EXPECT_LT(std::abs(x.z()) + ball.doubt, kEnd);
    }
  }
}

}  // namespace
}  // namespace impinge
