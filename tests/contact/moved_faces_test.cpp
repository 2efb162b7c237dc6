// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of moved meshes meet exactly where CGAL finds two faces that do, of the same rounded corners
// (reference/meeting_surfaces.hpp). Real bones need the folder that IMPINGE_BONES names.
#include "contact/moved_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "joint/joint_folder.hpp"
#include "mesh/bodies.hpp"
#include "mesh/collinear.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/io.hpp"
#include "mesh/lengths.hpp"
#include "reference/meeting_surfaces.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

using test::Dice;

// Answers that are as expected, and how many there were of each kind.
struct Answers {
  int meeting = 0;
  int clear = 0;
  void add(bool found, bool expected, double where) {
    EXPECT_EQ(found, expected) << where;
    ++(expected ? meeting : clear);
  }
  void expect_both(int least) const { EXPECT_GT(std::min(meeting, clear), least); }
};

bool meet(const TriangleMesh& ball, const TriangleMesh& socket, const Pose& pose = {}) {
  return surfaces_meet(MovedFaces(ball), FixedFaces(socket), pose);
}
bool expected(const TriangleMesh& ball, const TriangleMesh& socket, const Pose& pose = {}) {
  return surfaces_meet(test::ball_in_socket_frame(ball, pose), socket);
}

TriangleMesh scaled(TriangleMesh mesh, double by) {
  for (Vec3& x : mesh.vertices) x *= by;
  return mesh;
}

// Triangles from slivers to large ones, here and there within 30 mm, some of them twice.
TriangleMesh mixed(Dice& dice, int faces) {
  TriangleMesh mesh;
  const double size = dice.power(-0.5, 1.5);
  for (int f = 0; f < faces; ++f) {
    const Vec3 a = 30.0 * dice.between(0.0, 1.0) * dice.direction();
    const Vec3 along = size * dice.direction();
    const Vec3 across = dice.power(-12.0, 0.0) * size * dice.direction();
    test::add_face(mesh, a, a + along, a + dice.between(-1.0, 1.0) * along + across);
    if (dice.whole(0, 4) == 0) mesh.faces.push_back(mesh.faces.back());
  }
  return mesh;
}

TEST(TheoremNear, MeetWhereCgalSaysSo) {
  Dice dice(1);
  Answers seen;
  for (int round = 0; round < 100; ++round) {
    const TriangleMesh ball = mixed(dice, dice.whole(1, 80));
    const TriangleMesh socket = mixed(dice, dice.whole(1, 80));
    const MovedFaces moved(ball);
    const FixedFaces fixed(socket);
    for (int k = 0; k < 12; ++k) {
      const Vec3 shift = k < 6 ? Vec3::Zero() : Vec3(dice.power(-6.0, 2.0) * dice.direction());
      const Pose pose{dice.rotation(), shift};
      seen.add(surfaces_meet(moved, fixed, pose), expected(ball, socket, pose), round);
    }
  }
  seen.expect_both(200);
}

TEST(MovedFaces, LengthsOfAnySize) {
  Dice dice(2);
  Answers seen;
  for (const double scale : {1e-12, 1e-3, 1e6, 1e15, 5e15}) {
    for (int round = 0; round < 40; ++round) {
      const TriangleMesh ball = scaled(mixed(dice, 30), scale);
      const TriangleMesh socket = scaled(mixed(dice, 30), scale);
      const Pose pose{dice.rotation(), scale * dice.between(0.0, 3.0) * dice.direction()};
      seen.add(meet(ball, socket, pose), expected(ball, socket, pose), scale);
    }
  }
  seen.expect_both(20);
  const TriangleMesh half = octahedron(0.5 * kMostFloatLength);
  for (const auto& [shift, meets] : {std::pair{0.9, true}, {1.0, true}, {1.01, false}}) {
    const Vec3 by = shift * kMostFloatLength * Vec3::UnitX();
    EXPECT_EQ(meet(half, half, {Eigen::Matrix3d::Identity(), by}), meets) << shift;
  }
  for (const double length : {0.5 * kLeastFloatLength, 2.0 * kMostFloatLength}) {
    EXPECT_THROW(MovedFaces{octahedron(length)}, std::invalid_argument);
    EXPECT_THROW(FixedFaces{octahedron(length)}, std::invalid_argument);
  }
}

// Common planes, edges and corners, in turns that are exact.
TEST(MovedFaces, CornersOnAGrid) {
  Dice dice(3);
  Answers seen;
  TriangleMesh socket;
  std::optional<FixedFaces> fixed;
  const auto corner = [&] { return Vec3(dice.whole(-2, 2), dice.whole(-2, 2), dice.whole(-2, 2)); };
  const auto some = [&](int faces) {
    TriangleMesh mesh;
    while (faces > 0) {
      const Vec3 a = corner();
      const Vec3 b = corner();
      const Vec3 c = corner();
      if (collinear(a, b, c)) continue;
      test::add_face(mesh, a, b, c);
      --faces;
    }
    return mesh;
  };
  for (int round = 0; round < 3000; ++round) {
    const TriangleMesh ball = some(dice.whole(1, 3));
    if (round % 50 == 0) {
      socket = some(dice.whole(1, 2));
      fixed.emplace(socket);
    }
    Pose pose;
    for (int turn = dice.whole(0, 5); turn > 0; --turn) {
      const Eigen::Matrix3d quarter = (Eigen::Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();
      const Eigen::Matrix3d third = (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();
      pose.rotation = (turn % 2 == 0 ? quarter : third) * pose.rotation;
    }
    pose.translation = corner();
    seen.add(surfaces_meet(MovedFaces(ball), *fixed, pose), expected(ball, socket, pose), round);
  }
  seen.expect_both(300);
}

// A corner within some last digits of a face, of an edge or of a corner, in a frame that is turned anyhow.
TEST(MovedFaces, LastDigits) {
  Dice dice(4);
  Answers seen;
  TriangleMesh socket;
  std::optional<FixedFaces> fixed;
  for (int round = 0; round < 2000; ++round) {
    if (round % 40 == 0) {
      socket = {};
      test::add_face(socket, 20.0 * dice.direction(), 20.0 * dice.direction(), 20.0 * dice.direction());
      fixed.emplace(socket);
    }
    const Pose pose{dice.rotation(), dice.whole(0, 1) * dice.direction()};
    Vec3 share(dice.between(0.0, 1.0), dice.whole(0, 1) * dice.between(0.0, 1.0), dice.whole(0, 2) / 2.0);
    share /= share.sum();
    Vec3 on = Vec3::Zero();
    for (Eigen::Index k = 0; k < 3; ++k) on += share[k] * socket.vertices[static_cast<std::size_t>(k)];
    const Vec3 tip = to_ball(pose, on) + 1e-15 * dice.whole(0, 6) * dice.direction();
    TriangleMesh ball;
    test::add_face(ball, tip, tip + dice.power(-3.0, 1.0) * dice.direction(), tip + dice.direction());
    seen.add(surfaces_meet(MovedFaces(ball), *fixed, pose), expected(ball, socket, pose), round);
  }
  seen.expect_both(300);
}

// A head in a shell, both of many faces: clear along all rays until a shift closes the gap.
TEST(MovedFaces, HeadInAShell) {
  Dice dice(5);
  Answers seen;
  const TriangleMesh head = icosphere(20.0, 3);
  for (const double gap : {1e-3, 0.1, 1.0}) {
    // The chords of the shell are nearer to the centre than its corners, by up to this much.
    const TriangleMesh shell = icosphere(20.25 + gap, 3);
    const MovedFaces moved(head);
    const FixedFaces fixed(shell);
    for (int round = 0; round < 12; ++round) {
      const Pose pose{dice.rotation(), dice.between(0.0, 0.5 + 2.0 * gap) * dice.direction()};
      seen.add(surfaces_meet(moved, fixed, pose), expected(head, shell, pose), gap);
    }
  }
  seen.expect_both(5);
}

TEST(MovedFaces, FewAreLookedAt) {
  const TriangleMesh head = icosphere(20.0, 4);
  const MovedFaces moved(head);
  std::size_t apart = 0;
  std::size_t touching = 0;
  EXPECT_FALSE(surfaces_meet(moved, FixedFaces(icosphere(21.0, 4)), {}, &apart));
  EXPECT_EQ(apart, 0);
  const Pose shifted{Eigen::Matrix3d::Identity(), Vec3(1.0, 0.0, 0.0)};
  EXPECT_TRUE(surfaces_meet(moved, FixedFaces(icosphere(20.9, 4)), shifted, &touching));
  EXPECT_GT(touching, 0);
  EXPECT_LT(touching, head.faces.size() / 20);
}

// Behind the socket, as the centre sees it, and beyond any side of its grid.
TEST(MovedFaces, NoneIsLookedAtBesideTheGrid) {
  const TriangleMesh body = icosphere(2.0, 2);
  for (const Vec3& way :
       {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    TriangleMesh socket = body;
    for (Vec3& x : socket.vertices) x += 20.0 * way;
    std::size_t looked_at = 0;
    const Pose behind{Eigen::Matrix3d::Identity(), 26.0 * way};
    EXPECT_FALSE(surfaces_meet(MovedFaces(body), FixedFaces(socket), behind, &looked_at));
    EXPECT_EQ(looked_at, 0) << way.transpose();
  }
}

TEST(NearCells, AreNoMoreThanThirtyTwoForAFace) {
  for (std::size_t halvings = 0; halvings < 5; ++halvings) {
    const TriangleMesh mesh = icosphere(20.0, halvings);
    EXPECT_LE(NearCells(FaceRuns(mesh)).square.size(), 32 * (128 + mesh.faces.size()));
  }
}

// Calls visit(x) for points of the faces, corners among them.
template <class Visit>
void for_points_of(const FaceRuns& surface, Dice& dice, const Visit& visit) {
  for (const Face& f : surface.faces) {
    for (int k = 0; k < 6; ++k) {
      Vec3 share(dice.between(0.0, 1.0), dice.between(0.0, 1.0), dice.between(0.0, 1.0));
      if (k < 3) share = Vec3::Unit(k);
      share /= share.sum();
      visit(Vec3(share[0] * surface.vertices[f[0]] + share[1] * surface.vertices[f[1]] +
                 share[2] * surface.vertices[f[2]]));
    }
  }
}

TEST(TheoremNear, NoFartherThanPoints) {
  Dice dice(8);
  for (int round = 0; round < 60; ++round) {
    const FaceRuns surface(mixed(dice, dice.whole(1, 60)));
    const NearCells grid(surface);
    const auto square_at = [&](const Vec3& x) -> double {
      const Vec3 at = ((x - grid.origin) / grid.size).array().floor();
      const double place = at.x() + grid.cells[0] * (at.y() + grid.cells[1] * at.z());
      return grid.square[static_cast<std::size_t>(place)];
    };
    const Vec3 extent = grid.size * Vec3(grid.cells[0], grid.cells[1], grid.cells[2]);
    int apart = 0;
    for_points_of(surface, dice, [&](const Vec3& x) {
      EXPECT_EQ(square_at(x), 0.0);
      const Vec3 way = dice.power(0.0, 1.5) * grid.size * dice.direction();
      const Vec3 y = (x + way).cwiseMax(grid.origin).cwiseMin(grid.origin + 0.9999 * extent);
      if (square_at(y) <= 1.0) return;
      ++apart;
      EXPECT_LE(std::sqrt(square_at(y) - 1.0) * grid.size, (y - x).norm() * (1.0 + 1e-9));
    });
    EXPECT_GT(apart, 0);
  }
}

// Faces of 30 mm a thousandth of that from the centre: more than there are cuts for.
TriangleMesh large_and_near(Dice& dice) {
  TriangleMesh mesh;
  for (int f = 0; f < 12; ++f) {
    const Vec3 up = dice.direction();
    const Vec3 along = 30.0 * up.unitOrthogonal();
    const Vec3 across = up.cross(along);
    const Vec3 foot = 0.03 * up;
    test::add_face(mesh, foot + along, foot - 0.5 * along + across, foot - 0.5 * along - across);
  }
  return mesh;
}

TEST(TheoremNear, NoLargerThanThoseOfPoints) {
  Dice dice(9);
  for (int round = 0; round < 60; ++round) {
    const FaceRuns surface(round > 0 ? mixed(dice, dice.whole(1, 60)) : large_and_near(dice));
    const LeastRadii radii(surface);
    for_points_of(surface, dice, [&](const Vec3& x) {
      for (std::size_t level = 0; level < LeastRadii::kLevels; ++level) {
        const int cells = LeastRadii::kFinest >> level;
        std::size_t place = radii.first[level];
        for (Eigen::Index axis = 2, times = cells * cells; axis >= 0; --axis, times /= cells) {
          const double near = x.normalized()[axis] + dice.between(-1.999, 1.999) / cells;
          const double at = std::clamp(std::floor((near + 1.0) * (0.5 * cells)), 0.0, cells - 1.0);
          place += static_cast<std::size_t>(static_cast<Eigen::Index>(at) * times);
        }
        EXPECT_LE(radii.square[place], x.squaredNorm()) << level;
      }
    });
  }
}

// Faces that the centre lies in or beside, with no direction of their own.
TEST(MovedFaces, FacesAtTheCentre) {
  Dice dice(6);
  Answers seen;
  for (int round = 0; round < 200; ++round) {
    const Vec3 near = dice.whole(0, 1) * dice.power(-17.0, 0.0) * dice.direction();
    TriangleMesh socket = mixed(dice, 10);
    test::add_face(socket, near, near + 5.0 * dice.direction(), near - 5.0 * dice.direction());
    TriangleMesh ball = scaled(mixed(dice, 40), dice.power(-4.0, 0.0));
    const Pose pose{dice.rotation(), dice.whole(0, 1) * dice.power(-17.0, 0.0) * dice.direction()};
    EXPECT_EQ(meet(socket, ball, pose), expected(socket, ball, pose)) << round;
    seen.add(meet(ball, socket, pose), expected(ball, socket, pose), round);
  }
  seen.expect_both(20);
}

// A pose takes the middle of a face to the centre, but for little or nothing: it is in all directions.
TEST(MovedFaces, RoundTheCentre) {
  Dice dice(10);
  Answers seen;
  TriangleMesh socket;
  std::optional<FixedFaces> fixed;
  for (int round = 0; round < 200; ++round) {
    if (round % 20 == 0) {
      socket = mixed(dice, 10);
      fixed.emplace(socket);
    }
    TriangleMesh ball;
    test::add_face(ball, 20.0 * dice.direction(), 20.0 * dice.direction(), 20.0 * dice.direction());
    const Vec3 low = ball.vertices[0].cwiseMin(ball.vertices[1]).cwiseMin(ball.vertices[2]);
    const Vec3 high = ball.vertices[0].cwiseMax(ball.vertices[1]).cwiseMax(ball.vertices[2]);
    Pose pose{dice.rotation(), Vec3::Zero()};
    pose.translation = dice.power(-6.0, -3.0) * dice.direction() - pose.rotation * (0.5 * (low + high));
    seen.add(surfaces_meet(MovedFaces(ball), *fixed, pose), expected(ball, socket, pose), round);
  }
  seen.expect_both(20);
}

// A sliver that is too thin for the filter, and no line.
TEST(MovedFaces, ASliverOfTheLastDigitsIsAFace) {
  TriangleMesh wall;
  test::add_face(wall, Vec3(1.5, -3, -3), Vec3(1.5, 3, -3), Vec3(1.5, 0, 3));
  for (const double thick : {0.0, 0x1p-60}) {
    TriangleMesh sliver;
    test::add_face(sliver, Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, thick, 0));
    EXPECT_EQ(FaceRuns(sliver).faces.size(), thick > 0.0 ? 1U : 0U);
    EXPECT_EQ(meet(sliver, wall), thick > 0.0);
    EXPECT_EQ(meet(wall, sliver), thick > 0.0);
  }
}

TEST(MovedFaces, WithoutAreaMeetNothing) {
  TriangleMesh needle;
  test::add_face(needle, Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(0, 0, 2));
  TriangleMesh floor;
  test::add_face(floor, Vec3(-3, -3, 0), Vec3(3, -3, 0), Vec3(0, 3, 0));
  EXPECT_TRUE(meet(floor, floor));
  for (const TriangleMesh& nothing : {needle, TriangleMesh{}}) {
    EXPECT_FALSE(meet(nothing, floor));
    EXPECT_FALSE(meet(floor, nothing));
    EXPECT_FALSE(meet(nothing, nothing));
    EXPECT_FALSE(FixedFaces(nothing).meet({Vec3(-3, -3, 0), Vec3(3, -3, 0), Vec3(0, 3, 0)}));
  }
  for (int k = 0; k < 20; ++k) needle.faces.push_back(needle.faces.front());
  EXPECT_FALSE(meet(needle, floor));
  test::add_face(needle, Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, 0, 2));
  EXPECT_TRUE(meet(needle, floor));
}

// By CGAL, of the faces in each cube of 4 mm: a common point lies in one.
bool bones_meet(const TriangleMesh& ball, const TriangleMesh& socket) {
  constexpr double kCube = 4.0;
  std::map<std::array<int, 3>, std::pair<TriangleMesh, TriangleMesh>> cubes;
  const auto add = [&](const TriangleMesh& mesh, TriangleMesh std::pair<TriangleMesh, TriangleMesh>::*which) {
    for (const Face& face : mesh.faces) {
      const auto [a, b, c] = corners_of(mesh, face);
      const Vec3 low = (a.cwiseMin(b).cwiseMin(c) / kCube).array().floor();
      const Vec3 high = (a.cwiseMax(b).cwiseMax(c) / kCube).array().floor();
      for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); ++x) {
        for (int y = static_cast<int>(low.y()); y <= static_cast<int>(high.y()); ++y) {
          for (int z = static_cast<int>(low.z()); z <= static_cast<int>(high.z()); ++z)
            test::add_face(cubes[{x, y, z}].*which, a, b, c);
        }
      }
    }
  };
  add(ball, &std::pair<TriangleMesh, TriangleMesh>::first);
  add(socket, &std::pair<TriangleMesh, TriangleMesh>::second);
  return std::ranges::any_of(
      cubes, [](const auto& cube) { return surfaces_meet(cube.second.first, cube.second.second); });
}

// From poses at random halfway to the change of the answer between two, again and again: both ends.
TEST(MovedFaces, BonesNextToContact) {
  const char* bones = std::getenv("IMPINGE_BONES");  // NOLINT(concurrency-mt-unsafe)
  if (bones == nullptr) GTEST_SKIP() << "no real joints: set IMPINGE_BONES";
  int joints = 0;
  for (const JointFolder& joint : find_joints(bones).joints) {
    const std::filesystem::path folder = joint.ball.parent_path();
    if (!joint.centre || !std::filesystem::exists(folder / "pelvis.ply")) continue;
    ++joints;
    const TriangleMesh femur = relative_to(read_mesh(folder / "femur.ply"), *joint.centre);
    const TriangleMesh pelvis = relative_to(read_mesh(folder / "pelvis.ply"), *joint.centre);
    const MovedFaces moved(femur);
    const FixedFaces fixed(pelvis);
    Dice dice(7);
    for (int pair = 0; pair < 3; ++pair) {
      const auto random_pose = [&](bool meeting) {
        Pose pose;
        do {
          pose = {dice.rotation(), dice.between(0.0, 0.5) * dice.direction()};
        } while (surfaces_meet(moved, fixed, pose) != meeting);
        return pose;
      };
      std::array ends{random_pose(false), random_pose(true)};
      for (int k = 0; k < 24; ++k) {
        const Eigen::Quaterniond from(ends[0].rotation);
        const Eigen::Quaterniond middle = from.slerp(0.5, Eigen::Quaterniond(ends[1].rotation));
        const Pose pose{middle.normalized().toRotationMatrix(),
                        0.5 * (ends[0].translation + ends[1].translation)};
        ends[surfaces_meet(moved, fixed, pose) ? 1 : 0] = pose;
      }
      for (std::size_t end = 0; end < 2; ++end)
        EXPECT_EQ(bones_meet(test::ball_in_socket_frame(femur, ends[end]), pelvis), end == 1)
            << joint.subject;
    }
  }
  EXPECT_GT(joints, 0);
}

}  // namespace
}  // namespace impinge
