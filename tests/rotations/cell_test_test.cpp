// SPDX-License-Identifier: GPL-3.0-or-later
// No rotation in a cell that is called free has a contact, and every one in a cell that is called blocked
// has. Where the socket is a sheet, radii decide: all pairs of faces say so of the first thousand, the culled
// overlay of the others (support/exact_touch.hpp). Where both bones have an inside, CGAL's exact intersection
// of all faces and solid angles do.
#include "rotations/cell_test.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/bodies.hpp"
#include "mesh/edges.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/star_shape.hpp"
#include "reference/meeting_surfaces.hpp"
#include "rotations/cell_part.hpp"
#include "rotations/mesh_holes.hpp"
#include "rotations/rotation_cells.hpp"
#include "rotations/seen_surface.hpp"
#include "support/closed_bones.hpp"
#include "support/dice.hpp"
#include "support/exact_touch.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

// Rotations near the border of what is free are few: cells whose parent is open are asked.
struct Asked {
  std::size_t free = 0;
  std::size_t blocked = 0;
};

RotationCell any_cell(std::mt19937_64& engine, std::uint32_t level) {
  std::normal_distribution<double> normal;
  Quaternion4 q;
  for (double& x : q) x = normal(engine);
  return cell_of(q, level);
}

Vec3 any_direction(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  return Vec3(normal(engine), normal(engine), normal(engine)).normalized();
}

Quaternion4 any_of(const RotationCell& cell, std::mt19937_64& engine) {
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::array<double, 3> along{};
  for (double& x : along) x = std::clamp(1.3 * place(engine), -1.0, 1.0);  // borders too
  return point_of(cell, along);
}

// impinged(rotation) is what the cells must hold.
template <class Impinged>
Asked attack(const CellTest& test, std::size_t rotations, const Impinged& impinged) {
  CellSearch search(test);
  std::mt19937_64 engine(11);
  Asked asked;
  for (std::size_t round = 0; asked.free + asked.blocked < rotations; ++round) {
    RotationCell cell = any_cell(engine, kFinestCells);
    // From coarse to fine, as a refinement would: the first that is decided.
    CellVerdict verdict;
    for (std::uint32_t level = 2; level <= 9 && verdict.state == CellState::open; ++level) {
      const RotationCell part{level, cell.number >> (3 * (kFinestCells - level))};
      verdict = search.decide(part, verdict.hint);
      if (verdict.state != CellState::open) cell = part;
    }
    if (verdict.state == CellState::open || verdict.state == CellState::unknown) continue;
    const Quaternion4 q = any_of(cell, engine);
    const bool blocked = verdict.state == CellState::blocked;
    ++(blocked ? asked.blocked : asked.free);
    EXPECT_EQ(impinged(rotation_of(q)), blocked) << cell.level << " " << cell.number << " " << q.transpose();
  }
  return asked;
}

Asked attack_by_radii(const BallSocketPair& joint) {
  const CellTest test(joint);
  EXPECT_FALSE(test.bodies().has_inside());
  test::ExactTouch overlay(joint);
  return attack(test, random_cases() / 2, [&](const Eigen::Matrix3d& rotation) {
    return overlay.impinged({rotation, Vec3::Zero()});
  });
}

TEST(TheoremVolume, IsNeverWrongOfBonesWithAnInside) {
  const test::ClosedBones bones;
  ASSERT_TRUE(boundary_edges(bones.joint.socket).empty());
  const CellTest test(bones.joint);
  ASSERT_TRUE(test.bodies().has_inside());
  test::ExactTouch overlay(bones.joint);
  std::size_t behind = 0;  // of radii that overlap, where bones are clear
  const Asked asked =
      attack(test, std::min<std::size_t>(random_cases(), 2000), [&](const Eigen::Matrix3d& rotation) {
        const bool contact = bones.meet(rotation);
        if (!contact && overlay.impinged({rotation, Vec3::Zero()})) ++behind;
        return contact;
      });
  EXPECT_GT(asked.free, 50U);
  EXPECT_GT(asked.blocked, 50U);
  EXPECT_GT(behind, 20U);
}

// Parts of open cells, at random and a hair within their planes, where a wrong one would be found first.
TEST(TheoremVolume, PartsAreNeverWrongOfBonesWithAnInside) {
  const test::ClosedBones bones;
  const CellTest test(bones.joint);
  CellSearch search(test);
  test::Dice dice(61);
  Asked asked;
  for (std::size_t k = 0;
       k < 200 * random_cases() && std::min(asked.free, asked.blocked) < random_cases() / 2; ++k) {
    std::mt19937_64 engine(k);
    const RotationCell cell = any_cell(engine, static_cast<std::uint32_t>(dice.whole(5, 9)));
    const CellVerdict verdict = search.decide(cell);
    if (verdict.state != CellState::open) continue;
    const CellPart part = search.part_of(cell, verdict.hint);
    for (std::size_t n = 0; n < 12; ++n) {
      const std::vector<CellPlane>& planes = n % 2 == 0 ? part.free : part.blocked;
      Vec3 t(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
      if (n % 3 == 0 && !planes.empty()) {
        const CellPlane& plane = planes[n % planes.size()];
        const Vec3 slope(plane.slope[0], plane.slope[1], plane.slope[2]);
        t -= (plane.at(t) - 1e-7) * slope / slope.squaredNorm();
        t = t.cwiseMax(-1.0).cwiseMin(1.0);
      }
      const bool blocked = part.state == CellState::blocked || part.is_blocked(t);
      if (!blocked && part.state != CellState::free && !part.is_free(t)) continue;
      ++(blocked ? asked.blocked : asked.free);
      EXPECT_EQ(bones.meet(rotation_of(point_of(cell, {t[0], t[1], t[2]}))), blocked)
          << cell.level << " " << cell.number << " " << t.transpose();
    }
  }
  EXPECT_GT(asked.free, random_cases() / 50);
  EXPECT_GT(asked.blocked, random_cases() / 50);
}

// Two spheres 50 mm from the centre, nearly touching: parts of a cell are blocked no farther than the spheres
// meet, and free no nearer than spheres within the meshes do.
TEST(TheoremVolume, PartsAreThoseOfSpheresInClosedForm) {
  constexpr double kFar = 50.0;
  constexpr std::array<double, 2> kRadius{6.0, 5.0};
  std::array<TriangleMesh, 2> part;
  double within = 0.0;  // the sum of both radii, of spheres that the meshes hold
  for (std::size_t n = 0; n < 2; ++n) {
    part[n] = icosphere(kRadius[n], 3);
    double least = kRadius[n];
    for (const Face& face : part[n].faces)
      least = std::min(least, area_vector(part[n], face).normalized().dot(corner(part[n], face, 0)));
    within += least;
    for (Vec3& x : part[n].vertices) x += kFar * Vec3::UnitX();
  }
  const TriangleMesh inner = cup(300.0, 60.0, 100);
  TriangleMesh back = inner;
  for (Vec3& x : back.vertices) x *= 1.1;
  const CellTest test({icosphere(5.0, 1), test::with_back(inner, back)}, {}, {{part[0]}, {part[1]}});
  ASSERT_TRUE(test.bodies().has_inside());
  CellSearch search(test);
  test::Dice dice(62);
  Asked asked;
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const double apart = kRadius[0] + kRadius[1] + dice.between(-0.3, 0.3);
    const auto turn = [](double angle, const Vec3& axis) {
      return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
    };
    const Eigen::Quaterniond r = turn(dice.between(0.0, 2.0 * kPi), Vec3::UnitX()) *
                                 turn(2.0 * std::asin(0.5 * apart / kFar), Vec3::UnitZ()) *
                                 turn(dice.between(0.0, 2.0 * kPi), Vec3::UnitX());
    const RotationCell cell =
        cell_of({r.w(), r.x(), r.y(), r.z()}, static_cast<std::uint32_t>(dice.whole(7, 10)));
    const CellVerdict verdict = search.decide(cell);
    if (verdict.state != CellState::open) continue;
    const CellPart found = search.part_of(cell, verdict.hint);
    for (const bool blocked : {false, true}) {
      for (const CellPlane& plane : blocked ? found.blocked : found.free) {
        Vec3 t(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
        const Vec3 slope(plane.slope[0], plane.slope[1], plane.slope[2]);
        t -= (plane.at(t) - 1e-7) * slope / slope.squaredNorm();
        if (t.cwiseAbs().maxCoeff() > 1.0 || !(blocked ? found.is_blocked(t) : found.is_free(t))) continue;
        ++(blocked ? asked.blocked : asked.free);
        const Eigen::Matrix3d rotation = rotation_of(point_of(cell, {t[0], t[1], t[2]}));
        const double distance = kFar * (rotation * Vec3::UnitX() - Vec3::UnitX()).norm();
        if (blocked)
          EXPECT_LE(distance, kRadius[0] + kRadius[1]) << cell.level << " " << cell.number;
        else
          EXPECT_GE(distance, within) << cell.level << " " << cell.number;
      }
    }
  }
  EXPECT_GT(asked.free, random_cases() / 10);
  EXPECT_GT(asked.blocked, random_cases() / 10);
}

TEST(TheoremVolume, IsNeverWrongOfAHip) {
  const Hip hip = make_hip(hip_preset("cam"), 1500);
  const Asked asked = attack_by_radii({hip.ball, hip.socket});
  EXPECT_GT(asked.free, random_cases() / 20);
  EXPECT_GT(asked.blocked, random_cases() / 20);
}

TEST(TheoremVolume, IsNeverWrongOfAPair) {
  const Asked asked = attack_by_radii(make_ball_socket_pair(600, impinging_cam()));
  EXPECT_GT(asked.blocked, 0U);
}

// A ball with holes under a socket that it never touches. In every rotation of a free cell each direction of
// the socket meets the ball, in every one of an unknown cell some direction does not: by rays against all
// faces of both, along vertices and random points of the socket, and along directions of the ball that `draw`
// gives.
template <class Draw>
std::map<CellState, std::size_t> attack_holes(const BallSocketPair& joint, const Draw& draw,
                                              const CellQuestion& question = {}) {
  const CellTest test(joint, question);
  const RayCaster ball(joint.ball);
  const RayCaster socket(joint.socket);
  std::mt19937_64 engine(23);
  const auto misses = [&](const Eigen::Matrix3d& rotation, const Vec3& y) {
    return std::isnan(ball.cast((rotation.transpose() * y).normalized(), Layer::farthest));
  };
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto some_point = [&] {
    const auto corners = corners_of(joint.socket, joint.socket.faces[engine() % joint.socket.faces.size()]);
    const double a = part(engine);
    const double b = (1.0 - a) * part(engine);
    return Vec3(a * corners[0] + b * corners[1] + (1.0 - a - b) * corners[2]);
  };
  std::map<CellState, std::size_t> asked;
  CellSearch search(test);
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const RotationCell cell = any_cell(engine, 2 + static_cast<std::uint32_t>(round % 7));
    const CellState state = search.decide(cell).state;
    ++asked[state];
    const Eigen::Matrix3d rotation = rotation_of(any_of(cell, engine));
    bool missed =
        std::ranges::any_of(joint.socket.vertices, [&](const Vec3& y) { return misses(rotation, y); });
    const std::size_t points = state == CellState::free ? 100 : state == CellState::unknown ? 30000 : 0;
    for (std::size_t k = 0; k < points && !missed; ++k) {
      const Vec3 along = rotation * draw(engine);
      missed = misses(rotation, some_point()) ||
               (!std::isnan(socket.cast(along, Layer::nearest)) && misses(rotation, along));
    }
    if (points == 0) continue;
    EXPECT_EQ(missed, state == CellState::unknown) << cell.level << " " << cell.number;
  }
  EXPECT_GT(asked[CellState::free], random_cases() / 20);
  EXPECT_GT(asked[CellState::unknown], random_cases() / 20);
  EXPECT_EQ(asked[CellState::blocked], 0U);
  return asked;
}

// A wide hole, and narrow ones; for one centre, and for all about it.
TEST(TheoremVolume, IsNeverWrongWhereTheBallEnds) {
  BallSocketPair joint{sphere(20.0, 1000), cup(26.0, 30.0, 300)};
  std::mt19937_64 engine(23);
  std::erase_if(joint.ball.faces, [&](const Face& face) {
    const auto corners = corners_of(joint.ball, face);
    return angle_between(corners[0] + corners[1] + corners[2], {0.3, -0.4, 0.7}) < 0.2 || engine() % 200 == 0;
  });
  for (const double within : {0.0, 0.2})
    attack_holes(joint, [](std::mt19937_64& dice) { return any_direction(dice); },
                 {.centre_within_mm = within});
}

// Two halves of a ball of this width, degrees.
TriangleMesh halves(double width) {
  const TriangleMesh half = cup(20.0, 0.5 * width, 1000);
  return test::joined(half, test::turned(half, kPi, Vec3::UnitX()));
}

// A slit all round that is narrower than the cells of holes, which are 0.35 degrees wide.
TEST(TheoremVolume, IsNeverWrongWhereTheBallHasASlit) {
  const BallSocketPair joint{halves(179.8), cup(26.0, 40.0, 300)};
  const std::vector<Edge> ends = boundary_edges(joint.ball);
  const auto asked = attack_holes(joint, [&](std::mt19937_64& dice) {
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const Edge& edge = ends[dice() % ends.size()];
    const Vec3& a = joint.ball.vertices[edge[0]];
    return Vec3((a + part(dice) * (joint.ball.vertices[edge[1]] - a)).normalized() +
                1e-3 * any_direction(dice))
        .normalized();
  });
  EXPECT_LT(3 * asked.at(CellState::open), random_cases());
}

// Nor is there a hole where the halves overlap by less than that.
TEST(CellTest, HalvesThatOverlapLeaveNoHole) {
  EXPECT_TRUE(mesh_holes(SeenSurface(test::askew(halves(180.2)), Layer::farthest)).caps.empty());
}

// Turned by half a turn about a centre 0.998 r off, a flap below the ball is where the socket's only face is:
// the turn of its direction is that of its own length, whatever a gap adds to that.
TEST(CellTest, AGapMakesNoDirectionTurnLess) {
  struct Case {
    double gap, within;
  };
  for (const auto& [gap, within] : {Case{0.0, 0.1}, Case{0.5, 0.1}, Case{2.0, 0.1}, Case{2.0, 0.5}}) {
    constexpr double kLength = 20.0;
    const double small = 1e-3 * within;
    TriangleMesh ball = sphere(0.5 * kLength, 8);
    test::add_face(ball, {-small, 0, -kLength}, {small, 0, -kLength}, {0, small, -kLength});
    const Vec3 off(0.0, 0.998 * within, 0.0);
    const Vec3 to = Vec3(0, 0, kLength) + 2.0 * off;
    TriangleMesh socket;
    test::add_face(socket, to + Vec3(-small, -0.1 * small, -1e-9), to + Vec3(small, -0.1 * small, -1e-9),
                   to + Vec3(0, small, -1e-9));
    const Eigen::Matrix3d half = Vec3(1.0, -1.0, -1.0).asDiagonal();
    ASSERT_TRUE(
        SurfaceOverlay(relative_to(ball, off), relative_to(socket, off)).impinged({half, Vec3::Zero()}));
    const CellTest test({ball, socket}, {gap, within});
    for (const double radius : {0.0, 1e-6, 1e-4})
      EXPECT_NE(CellSearch(test).decide(RotationBall{half, radius}).state, CellState::free)
          << gap << " " << radius;
  }
}

// Moved out by the gap, a corner may be rounded into a plane with the centre: its face counts as before.
TEST(CellTest, AFaceThatTheGapMakesEdgeOnCounts) {
  for (const double place : {7.9, 7.901, 7.902, 7.95}) {
    TriangleMesh ball = sphere(3.0, 8);
    test::add_face(ball, {4, 4, 0}, {place, std::nextafter(place, 9.0), 20}, {5, 5, 3});
    const TriangleMesh socket = sphere(15.0, 200);
    ASSERT_TRUE(SurfaceOverlay(ball, socket).impinged({Eigen::Matrix3d::Identity(), Vec3::Zero()}));
    const CellTest test({ball, socket}, {1.0, 0.0});
    EXPECT_NE(CellSearch(test).decide(RotationBall{Eigen::Matrix3d::Identity(), 1e-3}).state, CellState::free)
        << place;
  }
}

// The cells of a level hold every rotation once; no rotation of a cell is farther than its radius; shares are
// Haar's measure; sides meet sides.

Quaternion4 random_quaternion(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  Quaternion4 q;
  for (double& x : q) x = normal(engine);
  return q.normalized();
}

RotationCell random_cell(std::mt19937_64& engine, std::uint32_t finest) {
  const auto level = std::uniform_int_distribution<std::uint32_t>(0, finest)(engine);
  return {level,
          std::uniform_int_distribution<std::uint64_t>(0, (std::uint64_t{4} << (3 * level)) - 1)(engine)};
}

TEST(RotationCells, SharesSumToOne) {
  for (const std::uint32_t level : {0U, 1U, 4U, 5U}) {
    double sum = 0.0;
    for (std::uint64_t number = 0; number < (std::uint64_t{4} << (3 * level)); ++number)
      sum += share({level, number});
    EXPECT_NEAR(sum, 1.0, kShareError) << level;
  }
}

// 1 - sin(a) / a of a turn by up to 2 a is what Haar's measure gives to angles up to 2 a: rotations drawn at
// random fall into a cell as often as its share says.
TEST(RotationCells, SharesAreThoseOfRandomRotations) {
  std::mt19937_64 engine(7);
  constexpr std::size_t kDraws = 200000;
  std::vector<std::size_t> found(4 * 64);
  for (std::size_t k = 0; k < kDraws; ++k) ++found[cell_of(random_quaternion(engine), 2).number];
  for (std::uint64_t number = 0; number < found.size(); ++number) {
    const double expected = share({2, number}) * kDraws;
    EXPECT_NEAR(static_cast<double>(found[number]), expected, 6.0 * std::sqrt(expected));
  }
}

TEST(RotationCells, HoldWhatTheyAreFoundFor) {
  std::mt19937_64 engine(8);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Quaternion4 q = random_quaternion(engine);
    const auto level = static_cast<std::uint32_t>(k % (kFinestCells + 1));
    const RotationCell cell = cell_of(q, level);
    const Quaternion4 middle = centre(cell);
    Eigen::Index cube = 0;
    middle.cwiseAbs().maxCoeff(&cube);
    const double side = std::ldexp(1.0, -static_cast<int>(level));
    EXPECT_LE((q / q[cube] - middle).cwiseAbs().maxCoeff(), side * (1.0 + 1e-9));
    const Eigen::AngleAxisd turn(rotation_of(middle).transpose() * rotation_of(q));
    EXPECT_LE(turn.angle(), angular_radius(cell));
    if (level > 0) {
      EXPECT_EQ(parent(cell), cell_of(q, level - 1));
    }
  }
}

// Quaternions with components of one size lie on borders: of the first cell, of the last one, and of two
// cubes.
TEST(RotationCells, HoldTheirBorders) {
  for (const std::uint32_t level : {0U, 1U, 5U, kFinestCells}) {
    for (int k = 0; k < 81; ++k) {
      const Quaternion4 q(k % 3 - 1, k / 3 % 3 - 1, k / 9 % 3 - 1, k / 27 - 1);
      if (q.isZero(0.0)) continue;
      const RotationCell cell = cell_of(q, level);
      ASSERT_LT(cell.number >> (3 * level), 4U);
      EXPECT_LE(CellFrame(cell).place(q).cwiseAbs().maxCoeff(), 1.0) << q.transpose() << " " << level;
    }
  }
}

// The farthest of a fine grid of points of a cell, by the angle of the matrices.
TEST(TheoremVolume, RadiusIsTheLeast) {
  std::mt19937_64 engine(9);
  for (int round = 0; round < 30; ++round) {
    const RotationCell cell = random_cell(engine, 8);
    const Eigen::Quaterniond middle(rotation_of(centre(cell)));
    double farthest = 0.0;
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        for (int k = -4; k <= 4; ++k) {
          const Quaternion4 q = point_of(cell, {0.25 * i, 0.25 * j, 0.25 * k});
          farthest = std::max(
              farthest, middle.angularDistance(Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized()));
        }
      }
    }
    EXPECT_LE(farthest, angular_radius(cell));
    EXPECT_NEAR(farthest, angular_radius(cell), 1e-7);
  }
}

// A form is nowhere below its half-space, near half turns and at the seams of the cubes too; the share of
// what planes leave of a cell is no more than that of random rotations in it, and near to it.
TEST(CellParts, FormsAndSharesAreLowerBounds) {
  std::mt19937_64 engine(12);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const auto vector = [&] { return Vec3(normal(engine), normal(engine), normal(engine)); };
  double all_lost = 0.0;
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const RotationCell cell = any_cell(engine, 1 + static_cast<std::uint32_t>(round % 9));
    const CellFrame frame(cell);
    const Vec3 x = vector();
    const Vec3 n = round % 3 == 0 ? Vec3(rotation_of(centre(cell)) * x + 0.1 * vector()) : vector();
    const double sign = round % 2 == 0 ? 1.0 : -1.0;
    const double k = n.dot(rotation_of(any_of(cell, engine)) * x);  // 0 within the cell
    const FormOverCell form = frame.form(n, x, k, sign, 0.0);
    const CellPlane plane = form.plane();
    CellPolytope left;
    ASSERT_TRUE(left.clip(plane, 6));
    std::size_t within = 0;
    constexpr std::size_t kDraws = 200;
    double most = 0.0;
    double sum = 0.0;
    for (std::size_t draw = 0; draw < kDraws; ++draw) {
      const Vec3 t(place(engine), place(engine), place(engine));
      const Quaternion4 q = point_of(cell, {t[0], t[1], t[2]});
      EXPECT_LE((frame.place(q) - t).norm(), 1e-9);
      const double value = sign * (n.dot(rotation_of(q) * x) - k);
      EXPECT_GE(value * q.squaredNorm(), form.middle + form.slope.dot(t) + form.least - 1e-12);
      EXPECT_EQ(plane.normal(frame).dot(q) > 0.0, plane.at(t) > 0.0);
      const double density = 1.0 / (q.squaredNorm() * q.squaredNorm());
      sum += density;
      if (plane.at(t) < 0.0) continue;
      EXPECT_GE(value, 0.0);
      ++within;
      most += density;
    }
    const double lost = most / sum - left.share(frame) / share(cell);
    EXPECT_GE(lost, -0.25) << within;
    if (cell.level >= 4) all_lost += lost / static_cast<double>(random_cases());
  }
  EXPECT_LT(all_lost, 0.1);
}

TEST(RotationCells, SidesMeetSides) {
  std::mt19937_64 engine(10);
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const RotationCell cell = random_cell(engine, 9);
    for (std::size_t side = 0; side < 6; ++side) {
      const RotationCell other = beside(cell, side);
      std::array<double, 3> along{0.2, 0.4, -0.3};  // not along a diagonal
      along[side / 2] = (side % 2 == 1 ? 1.0 : -1.0) * (1.0 + 1e-6);
      EXPECT_EQ(cell_of(point_of(cell, along), cell.level), other) << side;
      std::size_t back = 0;
      for (std::size_t of = 0; of < 6; ++of) back += beside(other, of) == cell ? 1U : 0U;
      EXPECT_EQ(back, cell.level == 0 ? back : 1U);
    }
  }
}

// Which faces may have a direction in a cap, and where a surface is missing, against points of the faces and
// rays against all of them.

Vec3 moved_by_angle(const Vec3& x, const Vec3& about, double angle) {
  return Eigen::AngleAxisd(angle, about.cross(x).normalized()) * x;
}

// Caps whose border a point of the face just reaches: of fat faces and slivers, by inner points, sides and
// corners.
TEST(SeenSurface, IsNearWhatTouchesTheCap) {
  test::Dice dice(5);
  std::size_t far = 0;
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const double size = dice.power(-4.0, 0.0);
    const Vec3 middle = dice.direction();
    TriangleMesh mesh;
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(30.0 * (middle + size * dice.vector()));
    mesh.faces.push_back({0, 1, 2});
    const SeenSurface surface(mesh, Layer::farthest);
    ASSERT_EQ(surface.faces().size(), 1U);
    Vec3 shares(dice.between(0.0, 1.0), dice.between(0.0, 1.0), dice.between(0.0, 1.0));
    for (std::size_t k = 0; k < round % 3; ++k) shares[dice.whole(0, 2)] = 0.0;
    Vec3 point = shares[0] * mesh.vertices[0] + shares[1] * mesh.vertices[1] + shares[2] * mesh.vertices[2];
    if (point.norm() < 1e-3) continue;
    const double radius = dice.power(-4.0, 0.2);
    const Vec3 axis = moved_by_angle(point.normalized(), dice.direction(), radius * (1.0 - 1e-9));
    EXPECT_TRUE(near(surface.faces()[0], {axis, radius})) << round;
    EXPECT_TRUE(surface.any_near({axis, radius})) << round;
    if (!near(surface.faces()[0], {dice.direction(), std::min(radius, 0.1)})) ++far;
  }
  EXPECT_GT(far, random_cases() / 4);
}

TEST(MeshHoles, HoldWhatNoFaceCovers) {
  test::Dice dice(6);
  TriangleMesh ball = sphere(20.0, 1000);
  const Vec3 hole = dice.direction();
  std::erase_if(ball.faces, [&](const Face& face) {
    const auto corners = corners_of(ball, face);
    return angle_between(corners[0] + corners[1] + corners[2], hole) < 0.3 || dice.whole(0, 99) == 0;
  });
  const MeshHoles holes = mesh_holes(SeenSurface(ball, Layer::farthest));
  const RayCaster rays(ball);
  const auto covered = [&](const Vec3& u) { return !std::isnan(rays.cast(u, Layer::farthest)); };
  std::size_t missing = 0;
  std::size_t beside = 0;
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const Vec3 u = dice.direction();
    const bool held = std::ranges::any_of(
        holes.caps, [&](const DirectionCap& cap) { return angle_between(cap.axis, u) <= cap.radius; });
    EXPECT_TRUE(held || covered(u)) << u.transpose();
    if (!covered(u)) ++missing;
    if (held && covered(u)) ++beside;
    const DirectionCap& empty = holes.empty[round % holes.empty.size()];
    EXPECT_FALSE(covered(moved_by_angle(empty.axis, u, empty.radius * dice.between(0.0, 1.0))))
        << u.transpose();
  }
  EXPECT_GT(missing, random_cases() / 50);
  EXPECT_LT(beside, missing);  // the caps are not much wider than the holes
}

}  // namespace
}  // namespace impinge
