// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of joints as no scan is: faces that are too wide for a plane or edge-on, gaps and doubts about the
// centre as large as the ball, hints that say nothing, and surfaces that nearly touch all round.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/split_faces.hpp"
#include "mesh/surface_vertices.hpp"
#include "rotations/cell_test.hpp"
#include "support/dice.hpp"
#include "support/exact_touch.hpp"
#include "support/joined.hpp"
#include "support/opened.hpp"
#include "support/random_cases.hpp"
#include "support/thrown.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

// A ball of 20 mm whose vertex on +z is 29 mm from the centre, under a sheet.
constexpr double kSpike = 29.0;
TriangleMesh ball_with_a_spike() {
  TriangleMesh ball = icosphere(20.0, 1);
  *std::ranges::max_element(ball.vertices, {}, [](const Vec3& x) { return x.z(); }) = kSpike * Vec3::UnitZ();
  return ball;
}

RotationCell cell_near(const Quaternion4& q, test::Dice& dice, int coarsest, int finest) {
  return cell_of(q, static_cast<std::uint32_t>(dice.whole(coarsest, finest)));
}

Quaternion4 quaternion_of(const Eigen::AngleAxisd& turn) {
  const Eigen::Quaterniond q(turn);
  return {q.w(), q.x(), q.y(), q.z()};
}

Vec3 place_in_cell(test::Dice& dice) {
  return {dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)};
}

// What the parts say at random places, beside the exact overlay.
struct Said {
  std::size_t free = 0;
  std::size_t blocked = 0;
};
void expect_right(const CellPart& part, const RotationCell& cell, test::ExactTouch& overlay, test::Dice& dice,
                  Said& said) {
  for (std::size_t n = 0; n < 12; ++n) {
    Vec3 t = place_in_cell(dice);
    const std::vector<CellPlane>& planes = n % 2 == 0 ? part.free : part.blocked;
    if (n % 3 == 0 && !planes.empty()) {  // a hair within a plane, where a wrong one would be found first
      const CellPlane& plane = planes[n % planes.size()];
      const Vec3 slope(plane.slope[0], plane.slope[1], plane.slope[2]);
      t -= (plane.at(t) - 1e-7) * slope / slope.squaredNorm();
      t = t.cwiseMax(-1.0).cwiseMin(1.0);
    }
    const bool blocked = part.state == CellState::blocked || part.is_blocked(t);
    if (!blocked && part.state != CellState::free && !part.is_free(t)) continue;
    ++(blocked ? said.blocked : said.free);
    EXPECT_EQ(overlay.impinged({rotation_of(point_of(cell, {t[0], t[1], t[2]})), Vec3::Zero()}), blocked)
        << cell.level << " " << cell.number << " " << t.transpose();
  }
}

// The spike comes to the rim of the cup about 70 degrees from its pole. Hints are guesses, right or wrong.
TEST(CellTest, PartsAreRightWhateverTheHint) {
  const BallSocketPair joint{ball_with_a_spike(), cup(26.0, 70.0, 60)};
  const CellTest test(joint);
  ASSERT_FALSE(test.bodies().has_inside());
  test::ExactTouch overlay(joint);
  CellSearch search(test);
  test::Dice dice(81);
  Said said;
  const auto some = [&](std::size_t count) {
    return dice.whole(0, 2) == 0 ? CellHint::kNone
                                 : static_cast<std::uint32_t>(dice.whole(0, static_cast<int>(count) - 1));
  };
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const double way = dice.between(0.0, 2.0 * kPi);
    const Eigen::AngleAxisd tilt((70.0 + dice.between(-6.0, 6.0)) * kDegree,
                                 Vec3(std::cos(way), std::sin(way), 0.0));
    const RotationCell cell = cell_near(quaternion_of(tilt), dice, 5, 9);
    const bool of_ball = dice.sign() > 0.0;
    const Surface of = of_ball ? Surface::ball : Surface::socket;
    const CellHint hint{some(joint.ball.faces.size()), some(joint.socket.faces.size()),
                        some(test.surface(of).vertices().size()), of_ball};
    expect_right(search.part_of(cell, hint), cell, overlay, dice, said);
  }
  EXPECT_GT(said.free, random_cases() / 50);
  EXPECT_GT(said.blocked, random_cases() / 10);
}

// Planes of neighbouring faces differ, edges meet edges, and the rim ends what a vertex of the ball can meet.
TEST(CellTest, PartsOfRoughSurfacesAreRight) {
  test::Dice dice(83);
  TriangleMesh ball = icosphere(24.2, 3);
  TriangleMesh socket = cup(26.5, 70.0, 300);
  for (TriangleMesh* mesh : {&ball, &socket})
    for (Vec3& x : mesh->vertices) x *= 1.0 + dice.between(-0.05, 0.05);
  const BallSocketPair joint{ball, socket};
  const CellTest test(joint);
  test::ExactTouch overlay(joint);
  CellSearch search(test);
  Said said;
  for (std::size_t k = 0; k < random_cases() / 4; ++k) {
    const RotationCell cell = cell_near(dice.quaternion(), dice, 5, 9);
    expect_right(search.part_of(cell, {}), cell, overlay, dice, said);
  }
  EXPECT_GT(said.free, random_cases() / 4);
  EXPECT_GT(said.blocked, random_cases() / 16);
}

// The spike points away from the cup.
TEST(CellTest, TakesNoCellApartThatIsTooCoarseOrTooFine) {
  const CellTest test({ball_with_a_spike(), cup(26.0, 70.0, 60)});
  CellSearch search(test);
  const Quaternion4 q = quaternion_of(Eigen::AngleAxisd(2.5, Vec3::UnitX()));
  for (std::uint32_t level = 0; level <= kFinestCells; ++level)
    EXPECT_EQ(search.part_of(cell_of(q, level), {}).state,
              level < 5 || level > 10 ? CellState::open : CellState::free)
        << level;
}

// A socket of one face that the centre sees nearly as a half-space: no plane is known, and ranges of radii do
// not tell whether the spike is beyond it.
TEST(CellTest, AFaceThatIsTooWideSaysNothing) {
  for (const double size : {120.0, 200.0}) {
    TriangleMesh socket;
    test::add_face(socket, {-size, -0.5 * size, 26.0}, {0.0, size, 26.0}, {size, -0.5 * size, 26.0});
    const CellTest test({ball_with_a_spike(), socket});
    ASSERT_TRUE(test.surface(Surface::socket).faces()[0].plane.isZero(0.0));
    CellSearch search(test);
    test::Dice dice(82);
    for (std::size_t k = 0; k < random_cases() / 10; ++k) {
      const Vec3 axis(1.0, dice.between(-1.0, 1.0), 0.0);
      const Eigen::AngleAxisd tilt(dice.between(0.0, 0.5), axis.normalized());
      const RotationCell cell = cell_near(quaternion_of(tilt), dice, 6, 10);
      const CellVerdict verdict = search.decide(cell);
      EXPECT_EQ(verdict.state, CellState::open);
      EXPECT_TRUE(search.part_of(cell, verdict.hint).empty());
      EXPECT_TRUE(search.part_of(cell, {}).empty());
    }
  }
}

// In the middle of a cell four spikes of each surface are a little before sloping faces of the other one, and
// turns about every axis drive some of them in.
TEST(CellTest, KeepsSixBlockedPartsOfACell) {
  test::Dice dice(83);
  Said said;
  std::size_t most = 0;
  for (std::size_t round = 0; round < 2; ++round) {
    const RotationCell cell = cell_of(dice.quaternion(), 6);
    const Eigen::Matrix3d back = rotation_of(centre(cell)).transpose();
    BallSocketPair joint;
    std::vector<Vec3> axes;
    for (std::size_t k = 0; k < 8; ++k) {
      const Vec3 d = Vec3(k & 1U ? 1.0 : -1.0, k & 2U ? 1.0 : -1.0, k & 4U ? 1.0 : -1.0).normalized();
      Vec3 x;
      do {
        x = d.cross(dice.vector()).normalized();
      } while (std::ranges::any_of(axes, [&](const Vec3& axis) { return angle_between(axis, x) < 0.6; }));
      axes.push_back(x);
      const bool of_ball = k % 2 == 0;
      // The spike is at 22 mm; the face meets its ray 0.15 mm farther, or nearer, and slopes as d turns it
      // in.
      const double at = of_ball ? 22.15 : 21.85;
      const Vec3 n = x + d.cross(x);
      const Vec3 along = d;
      const Vec3 up = n.cross(along).normalized();
      const auto corner = [&](double a, double b) { return Vec3(at * x + a * along + b * up); };
      TriangleMesh face;
      test::add_face(face, corner(-5.0, -4.0), corner(5.0, -4.0), corner(0.0, 7.0));
      TriangleMesh spike;
      const double beside = of_ball ? 12.0 : 40.0;
      test::add_face(spike, 22.0 * x, beside * (x + 0.02 * along), beside * (x + 0.02 * up));
      joint.ball = test::joined(joint.ball, test::turned(of_ball ? spike : face, back));
      joint.socket = test::joined(joint.socket, of_ball ? face : spike);
    }
    const CellTest test(joint);
    test::ExactTouch overlay(joint);
    CellSearch search(test);
    const CellPart part = search.part_of(cell, {});
    EXPECT_LE(part.blocked.size(), 6U);
    most = std::max(most, part.blocked.size());
    for (int n = 0; n < 10; ++n) expect_right(part, cell, overlay, dice, said);
  }
  EXPECT_EQ(most, 6U);
  EXPECT_GT(said.blocked, 20U);
}

// A closed box between a and b.
TriangleMesh box(const Vec3& a, const Vec3& b) {
  TriangleMesh mesh;
  for (std::size_t k = 0; k < 8; ++k)
    mesh.vertices.emplace_back(k & 1U ? b.x() : a.x(), k & 2U ? b.y() : a.y(), k & 4U ? b.z() : a.z());
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

// A small ball in a wide socket, both with an inside, for parts beside them.
BallSocketPair far_apart() {
  const TriangleMesh inner = cup(300.0, 60.0, 100);
  TriangleMesh outer = inner;
  for (Vec3& x : outer.vertices) x *= 1.1;
  return {icosphere(5.0, 1), test::with_back(inner, outer)};
}

// A plate in a slot with 0.01 mm to spare on either side: apart in the middle of the cell, in contact after a
// turn of a degree either way, and too little is left between for a part of the cell.
TEST(CellTest, FindsNoFreePartInASlot) {
  const BallSocketPair joint = far_apart();
  const TriangleMesh plate = box({40.0, -1.0, -8.0}, {60.0, 1.0, 8.0});
  const std::vector<TriangleMesh> slot{box({38.0, 1.01, -10.0}, {62.0, 4.0, 10.0}),
                                       box({38.0, -4.0, -10.0}, {62.0, -1.01, 10.0})};
  test::Dice dice(84);
  for (int round = 0; round < 2; ++round) {
    const RotationCell cell = cell_near(dice.quaternion(), dice, 5, 7);
    const Eigen::Matrix3d middle = rotation_of(centre(cell));
    const CellTest test(joint, {}, {{test::turned(plate, middle.transpose())}, slot});
    ASSERT_TRUE(test.bodies().has_inside());
    ASSERT_EQ(test.bodies().verdict({middle, Vec3::Zero()}).contact, Contact::no);
    for (const double angle : {-kDegree, kDegree}) {
      const Eigen::Matrix3d turned = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * middle;
      ASSERT_EQ(test.bodies().verdict({turned, Vec3::Zero()}).contact, Contact::yes);
    }
    CellSearch search(test);
    EXPECT_EQ(search.decide(cell).state, CellState::open);
    EXPECT_TRUE(search.part_of(cell, {}).free.empty());
    EXPECT_EQ(search.part_of(cell, {}).state, CellState::open);
  }
}

// A plate stays off a wall in the whole cell; so it does in fine faces, but they are too many to be looked
// at.
TEST(CellTest, LeavesACellOpenWhereTooManyFacesOfPartsAreClose) {
  const RotationCell cell = cell_of(Quaternion4::Unit(0), 10);
  const Eigen::Matrix3d back = rotation_of(centre(cell)).transpose();
  TriangleMesh plate = test::turned(box({46.5, -1.0, -3.5}, {53.5, 1.0, 3.5}), back);
  TriangleMesh wall = box({46.0, 1.14, -4.0}, {54.0, 3.0, 4.0});
  for (const bool fine : {false, true}) {
    for (int k = 0; k < (fine ? 6 : 0); ++k)
      for (TriangleMesh* mesh : {&plate, &wall})
        *mesh = split_faces(*mesh, std::vector<bool>(mesh->faces.size(), true)).mesh;
    const CellTest test(far_apart(), {}, {{plate}, {wall}});
    EXPECT_EQ(CellSearch(test).decide(cell).state, fine ? CellState::open : CellState::free);
  }
}

// A sheet of n squares each way, 0.05 mm wide, that a ray along +x meets at 20 degrees; every second row is
// farther out.
TriangleMesh rippled(VertexIndex n, double out, double ripple) {
  const Vec3 normal(std::cos(20.0 * kDegree), std::sin(20.0 * kDegree), 0.0);
  const Vec3 along = Vec3::UnitZ().cross(normal);
  TriangleMesh mesh;
  for (VertexIndex i = 0; i <= n; ++i)
    for (VertexIndex j = 0; j <= n; ++j)
      mesh.vertices.push_back(Vec3(50.0, 0.0, 0.0) + 0.05 * (i - 0.5 * n) * along +
                              0.05 * (j - 0.5 * n) * Vec3::UnitZ() +
                              (out + (i % 2 == 0 ? 0.0 : ripple)) * normal);
  for (VertexIndex i = 0; i < n; ++i)
    for (VertexIndex j = 0; j < n; ++j) {
      const VertexIndex at = i * (n + 1) + j;
      mesh.faces.push_back({at, at + n + 1, at + 1});
      mesh.faces.push_back({at + 1, at + n + 1, at + n + 2});
    }
  return mesh;
}

// Planes of the ripples go through the ball, which stays off them in the whole cell.
TEST(CellTest, LeavesACellOpenWhereTooManyFacesAreClose) {
  const RotationCell cell = cell_of(Quaternion4::Unit(0), 10);
  const Eigen::Matrix3d back = rotation_of(centre(cell)).transpose();
  const TriangleMesh head = test::opened(icosphere(45.0, 3), -Vec3::UnitX(), 1.0);
  for (const VertexIndex squares : {6U, 60U}) {
    const CellTest test(
        {test::joined(head, test::turned(rippled(squares, 0.0, 0.0), back)), rippled(squares, 0.05, 0.05)});
    CellSearch search(test);
    EXPECT_EQ(search.decide(cell).state, CellState::open) << squares;
    EXPECT_EQ(search.part_of(cell, {}).state, squares < 10 ? CellState::free : CellState::open);
  }
}

// A bump of the head comes into the bone of the socket through a hole of its wall, where radii are clear.
TEST(CellTest, NothingIsFreeWhereABumpComesThroughAHole) {
  const TriangleMesh inner = cup(26.0, 70.0, 3000);
  TriangleMesh outer = inner;
  for (Vec3& x : outer.vertices) x *= 32.0 / 26.0;
  BallSocketPair joint{sphere(22.0, 3000), test::with_back(inner, outer)};
  std::erase_if(joint.socket.faces, [&](const Face& face) {
    const auto [a, b, c] = corners_of(joint.socket, face);
    const Vec3 middle = (a + b + c) / 3.0;
    return middle.norm() < 29.0 && angle_between(middle, Vec3::UnitZ()) < 0.19;
  });
  *std::ranges::max_element(joint.ball.vertices, {}, [](const Vec3& x) { return x.z(); }) =
      25.9 * Vec3::UnitZ();
  const CellTest test(joint);
  ASSERT_TRUE(test.bodies().has_inside());
  ASSERT_FALSE(test::ExactTouch(joint).impinged({}));
  ASSERT_EQ(test.bodies().verdict({}).contact, Contact::yes);
  const Eigen::Matrix3d aside = Eigen::AngleAxisd(0.6, Vec3::UnitX()).toRotationMatrix();
  ASSERT_EQ(test.bodies().verdict({aside, Vec3::Zero()}).contact, Contact::no);
  for (const double radius : {0.01, 0.7})
    EXPECT_EQ(CellSearch(test).decide(RotationBall{aside, radius}).state,
              radius < 0.5 ? CellState::free : CellState::open);
}

// A part of the socket comes into a hollow ball through its mouth.
TEST(CellTest, NothingIsFreeWhereAPartComesThroughAMouth) {
  const TriangleMesh speck = test::moved(octahedron(0.1), {8.0, 0.0, -10.2});
  const CellTest test({cup(20.0, 120.0, 1000), cup(26.0, 30.0, 300)}, {}, {{}, {speck}});
  const Eigen::AngleAxisd in(3.0 * kDegree, Vec3::UnitY());
  ASSERT_EQ(test.bodies().verdict({}).contact, Contact::no);
  ASSERT_EQ(test.bodies().verdict({in.toRotationMatrix(), Vec3::Zero()}).contact, Contact::yes);
  for (const double radius : {0.002, 0.06})
    EXPECT_EQ(CellSearch(test).decide(RotationBall{Eigen::Matrix3d::Identity(), radius}).state,
              radius < 0.01 ? CellState::free : CellState::open);
}

// A small ball that ends 2.4 degrees beyond the rim of a cup, which a centre beside the origin sees bare.
TEST(CellTest, ABallEndsEarlierForAnotherCentre) {
  const BallSocketPair joint{cup(8.0, 62.4, 20000), cup(26.0, 60.0, 300)};
  const Vec3 off(0.25, 0.0, -0.433);
  const Vec3 rim = 26.0 * Vec3(std::sin(60.0 * kDegree), 0.0, std::cos(60.0 * kDegree));
  ASSERT_TRUE(
      std::isnan(RayCaster(relative_to(joint.ball, off)).cast((rim - off).normalized(), Layer::farthest)));
  for (const double within : {0.1, 0.5}) {
    const CellTest test(joint, {.centre_within_mm = within});
    EXPECT_EQ(CellSearch(test).decide(RotationBall{Eigen::Matrix3d::Identity(), 1e-4}).state,
              within < 0.2 ? CellState::free : CellState::open);
  }
}

TEST(CellTest, AVertexOfNoFaceInTheCentreChangesNothing) {
  const BallSocketPair joint{ball_with_a_spike(), cup(26.0, 70.0, 60)};
  BallSocketPair with = joint;
  with.ball.vertices.emplace_back(Vec3::Zero());
  const CellTest test(joint, {1.0, 0.0});
  const CellTest test_with(with, {1.0, 0.0});
  test::Dice dice(85);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const RotationCell cell = cell_near(dice.quaternion(), dice, 2, 7);
    const CellVerdict verdict = CellSearch(test).decide(cell);
    const CellVerdict same = CellSearch(test_with).decide(cell);
    EXPECT_EQ(verdict.state, same.state);
    EXPECT_EQ(verdict.hint, same.hint);
  }
}

// The length of a corner is rounded to 0: its face may be anywhere, and nothing is free beside it.
TEST(CellTest, AFaceFromTheCentreLeavesNoPartFree) {
  BallSocketPair joint{ball_with_a_spike(), cup(26.0, 70.0, 60)};
  const auto parts = [&](bool free) {
    const CellTest test(joint);
    CellSearch search(test);
    test::Dice dice(86);
    std::size_t found = 0;
    for (std::size_t k = 0; k < random_cases() / 10; ++k) {
      const Eigen::AngleAxisd tilt((70.0 + dice.between(-3.0, 30.0)) * kDegree, Vec3::UnitX());
      const CellPart part = search.part_of(cell_near(quaternion_of(tilt), dice, 5, 8), {});
      found += part.free.empty() && part.state != CellState::free ? 0U : 1U;
    }
    EXPECT_EQ(found > 0, free);
  };
  parts(true);
  test::add_face(joint.ball, Vec3::Constant(1e-200), {0, 0, -30}, {1, 0, -30});
  parts(false);
}

// A wall of the socket that lies in a plane with the origin reaches into the ball. Radii know nothing of it;
// from a centre beside that plane they overlap.
TEST(CellTest, AWallOfTheSocketThatTheOriginSeesEdgeOnCounts) {
  const TriangleMesh ball = sphere(20.0, 200);
  TriangleMesh socket = cup(30.0, 60.0, 100);
  test::add_face(socket, {0.0, 0.0, 15.0}, {0.0, 0.0, 30.0}, {8.0, 0.0, 25.0});
  ASSERT_TRUE(is_edge_on(socket, socket.faces.back()));
  const Vec3 off(0.0, 0.1, 0.0);
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity();
  ASSERT_TRUE(
      SurfaceOverlay(relative_to(ball, off), relative_to(socket, off)).impinged({rest, Vec3::Zero()}));
  const CellTest test({ball, socket}, {0.0, 0.2});
  EXPECT_EQ(CellSearch(test).decide(RotationBall{rest, 1e-3}).state, CellState::open);
  const CellTest exact({ball, socket});
  EXPECT_EQ(CellSearch(exact).decide(RotationBall{rest, 1e-3}).state, CellState::open);
}

// The gap moves a corner of the ball's face into a plane with the centre (as in
// AFaceThatTheGapMakesEdgeOnCounts).
TEST(CellTest, NoPartIsFreeWhereAFaceThatTheGapMakesEdgeOnTouches) {
  for (const double place : {7.9, 7.95}) {
    TriangleMesh ball = sphere(3.0, 8);
    test::add_face(ball, {4, 4, 0}, {place, std::nextafter(place, 9.0), 20}, {5, 5, 3});
    const TriangleMesh socket = sphere(15.0, 200);
    const Quaternion4 rest = Quaternion4::Unit(0);
    const CellTest test({ball, socket}, {1.0, 0.0});
    CellSearch search(test);
    for (std::uint32_t level = 6; level <= 10; ++level) {
      const RotationCell cell = cell_of(rest, level);
      for (const CellHint& hint : {CellHint{}, search.decide(cell).hint}) {
        const CellPart part = search.part_of(cell, hint);
        EXPECT_NE(part.state, CellState::free) << place;
        EXPECT_FALSE(part.is_free(CellFrame(cell).place(rest))) << place;
      }
    }
  }
}

// 20 mm and a gap of 14 reach beyond 26 mm in every rotation. A vertex of the socket, moved in by more than
// half of its radius, shows nothing.
TEST(CellTest, BlocksForAGapOfMoreThanHalfARadius) {
  const CellTest test({sphere(20.0, 500), cup(26.0, 70.0, 200)}, {14.0, 0.0});
  const CellTest unsure({sphere(20.0, 500), cup(26.0, 70.0, 200)}, {12.6, 1.0});
  test::Dice dice(86);
  for (std::size_t k = 0; k < random_cases() / 10; ++k) {
    const RotationCell cell = cell_near(dice.quaternion(), dice, 4, 7);
    EXPECT_EQ(CellSearch(test).decide(cell).state, CellState::blocked);
    EXPECT_NE(CellSearch(unsure).decide(cell).state, CellState::free);
  }
}

// A centre that may be outside of the ball says nothing of any rotation.
TEST(CellTest, DecidesNothingIfTheCentreMayBeOutsideOfTheBall) {
  const CellTest test({sphere(5.0, 100), cup(26.0, 70.0, 200)}, {0.0, 6.0});
  test::Dice dice(87);
  for (int k = 0; k < 20; ++k)
    EXPECT_EQ(CellSearch(test).decide(cell_near(dice.quaternion(), dice, 0, 9)).state, CellState::open);
}

// Nor does a centre on a face, at a corner or within, which some others have on this side of it and some on
// that.
TEST(CellTest, DecidesNothingIfTheCentreIsOnAFaceOfTheBall) {
  for (const Vec3& corner : {Vec3(0.0, 0.0, 0.0), Vec3(-4.0, -3.0, 0.0)}) {
    TriangleMesh ball = sphere(20.0, 200);
    test::add_face(ball, corner, {5.0, 0.0, 0.0}, {-4.0, 3.0, corner.isZero(0.0) ? 1.0 : 0.0});
    const CellTest test({ball, cup(26.0, 70.0, 200)}, {0.5, 0.1});
    test::Dice dice(88);
    for (int k = 0; k < 20; ++k)
      EXPECT_EQ(CellSearch(test).decide(cell_near(dice.quaternion(), dice, 0, 9)).state, CellState::open);
  }
}

// A spike that is longer than the farthest corner of a face, of which no plane is known.
TEST(CellTest, BlocksBeyondAFaceThatIsTooWide) {
  TriangleMesh socket;
  test::add_face(socket, {-120.0, -60.0, 26.0}, {0.0, 120.0, 26.0}, {120.0, -60.0, 26.0});
  TriangleMesh ball = sphere(20.0, 200);
  test::add_face(ball, {1.0, 0.0, 19.0}, {-1.0, 1.0, 19.0}, {0.0, 0.0, 150.0});
  const CellTest test({ball, socket});
  ASSERT_TRUE(test.surface(Surface::socket).faces()[0].plane.isZero(0.0));
  const auto& vertices = test.surface(Surface::ball).vertices();
  const auto tip = static_cast<std::uint32_t>(
      std::ranges::max_element(vertices, {}, [](const Vec3& x) { return x.z(); }) - vertices.begin());
  const CellHint hint{CellHint::kNone, CellHint::kNone, tip, true};
  EXPECT_EQ(CellSearch(test).decide(RotationBall{Eigen::Matrix3d::Identity(), 0.01}, hint).state,
            CellState::blocked);
}

// Beyond the edge at y = 0 the socket goes on with a face so steep that no plane of it is known.
TEST(CellTest, AVertexBlocksNothingBesideASteepFace) {
  TriangleMesh socket;
  socket.vertices = {{-8.0, 0.0, 26.0}, {8.0, 0.0, 26.0}, {0.0, -10.0, 26.0}, {0.0, 1e-5, 31.0}};
  socket.faces = {{0, 2, 1}, {0, 1, 3}};
  TriangleMesh ball = sphere(20.0, 200);
  test::add_face(ball, {1.0, 0.0, 19.0}, {-1.0, 1.0, 19.0}, {0.0, -1.0, 28.0});
  const CellTest test({ball, socket});
  const auto& faces = test.surface(Surface::socket).faces();
  ASSERT_EQ(std::ranges::count_if(faces, [](const DirectionFace& f) { return f.plane.isZero(0.0); }), 1);
  const auto& vertices = test.surface(Surface::ball).vertices();
  const auto tip = static_cast<std::uint32_t>(
      std::ranges::max_element(vertices, {}, [](const Vec3& x) { return x.z(); }) - vertices.begin());
  const CellHint hint{CellHint::kNone, CellHint::kNone, tip, true};
  for (const double radius : {0.01, 0.05})
    EXPECT_EQ(CellSearch(test).decide(RotationBall{Eigen::Matrix3d::Identity(), radius}, hint).state,
              radius < 1.0 / 28.0 ? CellState::blocked : CellState::open);
}

// Of two faces that are too small for planes through their sides, and too steep for a plane of their own,
// only their radii tell.
TEST(CellTest, TinySteepFacesAreApartByRadiiAlone) {
  const auto tiny = [](double r) {
    TriangleMesh mesh;
    test::add_face(mesh, {0.0, 0.0, r}, {0.0, 2e-13, r + 2e-6}, {2e-6, 0.0, r});
    return mesh;
  };
  const TriangleMesh ball = test::joined(test::opened(icosphere(10.0, 2), -Vec3::UnitZ(), 1.0), tiny(25.0));
  for (const double radius : {25.0, 25.5}) {
    const TriangleMesh other = test::turned(tiny(radius), 0.01, Vec3(0.8, 0.6, 0.0));
    const CellTest test({ball, test::joined(cup(30.0, 70.0, 60), other)});
    CellSearch search(test);
    for (std::uint32_t level = 5; level <= 7; ++level) {
      const CellPart part = search.part_of(cell_of(Quaternion4::Unit(0), level), {});
      EXPECT_EQ(part.state, radius > 25.1 ? CellState::free : CellState::open);
      EXPECT_TRUE(part.free.empty());
    }
  }
}

// A corner of the socket that is in the spike, and that some turns by up to 0.6 leave beside it.
TEST(CellTest, ACornerInASpikeBlocksWhereTheSpikeStays) {
  TriangleMesh socket;
  test::add_face(socket, {0.8, 0.5, 22.0}, {3.0, 30.0, 30.0}, {-3.0, 30.0, 30.0});
  const BallSocketPair joint{ball_with_a_spike(), socket};
  test::ExactTouch overlay(joint);
  const CellTest test(joint);
  const auto& vertices = test.surface(Surface::socket).vertices();
  const auto tip = static_cast<std::uint32_t>(
      std::ranges::min_element(vertices, {}, [](const Vec3& x) { return x.norm(); }) - vertices.begin());
  const CellHint hint{CellHint::kNone, CellHint::kNone, tip, false};
  const auto state = [&](double radius) {
    return CellSearch(test).decide(RotationBall{Eigen::Matrix3d::Identity(), radius}, hint).state;
  };
  EXPECT_EQ(state(0.01), CellState::blocked);
  const Eigen::AngleAxisd aside(0.6, Vec3::UnitX());
  ASSERT_FALSE(overlay.impinged({aside.toRotationMatrix(), Vec3::Zero()}));
  EXPECT_EQ(state(0.6), CellState::open);
}

// About another centre a quarter turn takes the ball away from a corner of the socket that is half a
// millimetre in it.
TEST(CellTest, ACornerBlocksOnlyIfItDoesForEveryCentre) {
  TriangleMesh socket;
  test::add_face(socket, {0.7, 0.9, 19.0}, {3.0, 30.0, 30.0}, {-3.0, 30.0, 30.0});
  const BallSocketPair joint{icosphere(20.0, 3), socket};
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5 * kPi, Vec3::UnitX()).toRotationMatrix();
  const Vec3 off = 0.99 * Vec3(0.0, std::sqrt(0.5), -std::sqrt(0.5));  // (I - R) off is 1.4 mm along -z
  const BallSocketPair other{relative_to(joint.ball, off), relative_to(joint.socket, off)};
  ASSERT_TRUE(test::ExactTouch(joint).impinged({turn, Vec3::Zero()}));
  ASSERT_FALSE(test::ExactTouch(other).impinged({turn, Vec3::Zero()}));
  for (const double within : {0.2, 1.0}) {
    const CellTest test(joint, {0.0, within});
    const auto& vertices = test.surface(Surface::socket).vertices();
    const auto tip = static_cast<std::uint32_t>(
        std::ranges::min_element(vertices, {}, [](const Vec3& x) { return x.norm(); }) - vertices.begin());
    const CellHint hint{CellHint::kNone, CellHint::kNone, tip, false};
    EXPECT_EQ(CellSearch(test).decide(RotationBall{turn, 1e-3}, hint).state,
              within < 0.5 ? CellState::blocked : CellState::open);
  }
}

// A small face of the ball twice as far out as one of the socket, beside it: a centre 0.98 mm off sees one
// behind the other.
TEST(CellTest, FacesBesideEachOtherTouchForAnotherCentre) {
  constexpr double kBeside = 0.0245;  // radians
  BallSocketPair joint{icosphere(10.0, 3), {}};
  const Vec3 x(0.0, 0.0, 40.0);
  const Vec3 y(20.0 * std::sin(kBeside), 0.0, 20.0 * std::cos(kBeside));
  for (const auto& [mesh, at] : {std::pair{&joint.ball, x}, {&joint.socket, y}})
    test::add_face(*mesh, at + Vec3(1e-3, 0, 0), at + Vec3(-5e-4, 8e-4, 0), at + Vec3(-5e-4, -8e-4, 0));
  const Vec3 off = y + y.z() / (x.z() - y.z()) * (y - x);
  ASSERT_LT(off.norm(), 1.0);
  const BallSocketPair other{relative_to(joint.ball, off), relative_to(joint.socket, off)};
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity();
  ASSERT_TRUE(test::ExactTouch(other).impinged({rest, Vec3::Zero()}));
  for (const double within : {0.1, 1.0}) {
    const CellTest test(joint, {0.0, within});
    EXPECT_EQ(CellSearch(test).decide(RotationBall{rest, 1e-6}).state,
              within < 0.5 ? CellState::free : CellState::open);
  }
}

// A gap is along rays from the centre: one 1 mm off sees a small face of the ball 9 mm below a corner of the
// socket that is beside it.
TEST(CellTest, AGapReachesAsideForAnotherCentre) {
  constexpr double kGap = 9.0;
  const Vec3 y(0.0, 0.0, 20.0);
  const Vec3 off(0.999, 0.0, 0.0);
  const Vec3 below = 1.002 * (y - kGap * (y - off).normalized());
  BallSocketPair joint{icosphere(10.2, 3), {}};
  test::add_face(joint.ball, below + Vec3(1e-2, 0, 0), below + Vec3(-5e-3, 8e-3, 0),
                 below + Vec3(-5e-3, -8e-3, 0));
  test::add_face(joint.socket, y, y + Vec3(1e-4, 1e-4, 1.0), y + Vec3(1e-4, -1e-4, 1.0));
  const BallSocketPair other{relative_to(joint.ball, off), relative_to(joint.socket, off)};
  const auto least = CulledJoint(other).least_gap({});
  ASSERT_TRUE(least && least->gap_mm < kGap);
  for (const double within : {0.1, 1.0}) {
    const CellTest test(joint, {kGap, within});
    EXPECT_EQ(CellSearch(test).decide(RotationBall{Eigen::Matrix3d::Identity(), 1e-6}).state,
              within < 0.5 ? CellState::free : CellState::open);
  }
}

// What was learnt of a cell says nothing of rotations elsewhere.
TEST(CellTest, AsksOfABallOfRotationsWhateverWasEntered) {
  const BallSocketPair joint{sphere(20.0, 300), test::with_back(cup(26.0, 70.0, 300), cup(30.0, 70.0, 300))};
  const CellTest test(joint);
  CellSearch search(test);
  test::Dice dice(89);
  for (int k = 0; k < 20; ++k) {
    search.enter(cell_near(dice.quaternion(), dice, 5, 6));
    const RotationBall about{dice.rotation(), 0.01};
    EXPECT_EQ(search.decide(about).state, CellSearch(test).decide(about).state);
    for (const int level : {0, 6, 11}) {
      const RotationCell cell = cell_near(dice.quaternion(), dice, level, level);
      EXPECT_EQ(search.decide(cell).state, CellSearch(test).decide(cell).state);
    }
  }
}

// About a quarter turn the cap of a vertex is too wide to be asked about, though that of all rotations is
// not: its bound is that of the vertex alone.
TEST(CellTest, BlocksNoQuarterTurn) {
  const CellTest test({icosphere(28.0, 2), test::turned(cup(26.0, 70.0, 200), 0.05, Vec3(0.6, 0.8, 0.0))},
                      {0.0, 1.0});
  const auto& vertices = test.surface(Surface::ball).vertices();
  const auto top = static_cast<std::uint32_t>(
      std::ranges::max_element(vertices, {}, [](const Vec3& x) { return x.z(); }) - vertices.begin());
  const CellHint hint{CellHint::kNone, CellHint::kNone, top, true};
  const auto state = [&](double radius) {
    return CellSearch(test).decide(RotationBall{Eigen::Matrix3d::Identity(), radius}, hint).state;
  };
  EXPECT_EQ(state(0.1), CellState::blocked);
  for (double radius = 1.4; radius < 1.57; radius += 0.0005) EXPECT_EQ(state(radius), CellState::open);
}

TEST(CellTest, RefusesADoubtBelowZeroAndASocketWithoutFaces) {
  const BallSocketPair joint{ball_with_a_spike(), cup(26.0, 70.0, 60)};
  EXPECT_EQ(test::thrown<std::invalid_argument>([&] {
              CellTest(joint, {0.0, -1.0});
            }),
            "motion volume: the gap, the distance of the centre and the play must be 0 mm or more");
  EXPECT_EQ(test::thrown<std::invalid_argument>([&] {
              CellTest({joint.ball, TriangleMesh{}});
            }),
            "motion volume: a surface has no face that the centre sees; give both meshes");
}

}  // namespace
}  // namespace impinge
