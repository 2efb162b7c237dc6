// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of bone beside a joint against CGAL's exact intersection of all faces, in random poses; insides by
// the solid angle that a closed mesh fills.
#include "motion/body_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <CGAL/intersections.h>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/meeting_faces.hpp"
#include "mesh/star_shape.hpp"
#include "reference/closest_point.hpp"
#include "reference/kernel_point.hpp"
#include "reference/meeting_surfaces.hpp"
#include "support/dice.hpp"
#include "support/hip_with_parts.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

TriangleMesh posed(const TriangleMesh& mesh, const Pose& pose) {
  TriangleMesh moved = mesh;
  for (Vec3& x : moved.vertices) x = to_socket(pose, x);
  return moved;
}

// Of a closed mesh; edges of a vertex in it by much less than the size of a face are not asked.
bool is_inside(const TriangleMesh& mesh, const Vec3& x) {
  double angle = 0.0;
  for (const Face& face : mesh.faces)
    angle += solid_angle(corner(mesh, face, 0) - x, corner(mesh, face, 1) - x, corner(mesh, face, 2) - x);
  return std::abs(angle) > 2.0 * kPi;
}

Kernel::Triangle_3 exact(const Triangle& face) {
  return {kernel_point(face[0]), kernel_point(face[1]), kernel_point(face[2])};
}

// On a small grid every kind of degenerate meeting turns up: in one plane, along a side, in a corner.
TEST(MeetingFaces, AreThoseOfCgal) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> grid(0, 3);
  std::size_t met = 0;
  std::size_t apart = 0;
  while (met + apart < 2 * random_cases()) {
    const auto triangle = [&] {
      Triangle face;
      for (Vec3& x : face) x = Vec3(grid(random), grid(random), grid(random) > 1 ? 1.0 : 0.0);
      return face;
    };
    const Triangle a = triangle();
    const Triangle b = triangle();
    if (exact(a).is_degenerate() || exact(b).is_degenerate()) continue;
    const bool meet = CGAL::do_intersect(exact(a), exact(b));
    ASSERT_EQ(faces_meet(a, b), meet);
    ++(meet ? met : apart);
  }
  EXPECT_GT(std::min(met, apart), random_cases() / 5);
}

struct Hips {
  Hip hip = make_hip(test::hip_with_parts(), 700);
  BallSocketPair main = main_surfaces(hip);
  BoneParts beside{part_surfaces(hip.ball, hip.ball_parts), part_surfaces(hip.socket, hip.socket_parts)};
};

// Shifts take bodies to each other that a turn alone never brings near.
TEST(BodyPairs, MeetWhereCgalSays) {
  const Hips hips;
  const BodyPairs pairs(hips.main, hips.beside);
  test::Dice dice(2);
  std::size_t met = 0;
  std::size_t inside = 0;
  std::size_t apart = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(random_cases() / 10, 400); ++k) {
    const double far = k % 2 == 0 ? 0.0 : 12.0;
    const Pose pose{dice.rotation(), far * dice.vector()};
    bool meet = false;
    bool holds = false;
    const auto compare = [&](const TriangleMesh& ball, const TriangleMesh& socket, bool closed) {
      const TriangleMesh moved = posed(ball, pose);
      meet = meet || surfaces_meet(moved, socket);
      holds =
          holds || is_inside(moved, socket.vertices[0]) || (closed && is_inside(socket, moved.vertices[0]));
    };
    for (const TriangleMesh& spine : hips.beside.socket) {
      compare(hips.main.ball, spine, true);
      for (const TriangleMesh& part : hips.beside.ball) compare(part, spine, true);
    }
    for (const TriangleMesh& part : hips.beside.ball) {
      const TriangleMesh moved = posed(part, pose);
      meet = meet || surfaces_meet(moved, hips.main.socket);
    }
    if (!meet && !holds) {
      ++apart;
      // The shaft is open at its end, of which a solid angle is not sure.
      EXPECT_FALSE(pairs.impinged(pose)) << k;
    } else {
      ++(meet ? met : inside);
      EXPECT_TRUE(pairs.impinged(pose)) << k;
    }
  }
  EXPECT_GT(met, 10U);
  EXPECT_GT(apart, 10U);
  RecordProperty("inside", static_cast<int>(inside));
}

// A sphere in another one, of which either may be the larger, and beside it.
TEST(BodyPairs, OneInsideTheOtherIsContact) {
  const auto at = [](double radius, double x) { return test::moved(icosphere(radius, 2), {x, 0.0, 0.0}); };
  const BallSocketPair main{icosphere(20.0, 2), icosphere(300.0, 2)};
  for (const auto& [ball, socket] : {std::pair{5.0, 9.0}, std::pair{9.0, 5.0}}) {
    EXPECT_TRUE(BodyPairs(main, {{at(ball, 60.0)}, {at(socket, 61.0)}}).impinged({}));
    EXPECT_FALSE(BodyPairs(main, {{at(ball, 60.0)}, {at(socket, 90.0)}}).impinged({}));
  }
  EXPECT_TRUE(BodyPairs(main, {{}, {at(3.0, 10.0)}}).impinged({})) << "in the head";
  EXPECT_FALSE(BodyPairs(main, {{}, {at(3.0, 30.0)}}).impinged({})) << "beside the head";
}

// What is said of all rotations near one, in random ones of them, at their end too, and with shifts.
class ManyRotations : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(OfAShaft, ManyRotations, testing::Bool(), [](const auto& cut) {
  return std::string(cut.param ? "ThatIsCut" : "ThatIsWhole");
});

TEST_P(ManyRotations, HoldInEveryOne) {
  Hips hips;
  if (GetParam()) {
    std::erase_if(hips.main.ball.faces, [&](const Face& face) {
      return std::ranges::any_of(face, [&](VertexIndex v) { return hips.main.ball.vertices[v].z() < -45.0; });
    });
    ASSERT_FALSE(boundary_edges(hips.main.ball).empty());
    hips.beside.socket.push_back(
        test::moved(icosphere(6.0, 1), {30.0, 40.0, 95.0}));  // to come behind the cut
  }
  const BodyPairs pairs(hips.main, hips.beside);
  test::Dice dice(3);
  std::size_t apart = 0;
  std::size_t overlap = 0;
  const std::size_t draws = std::min<std::size_t>(2 * random_cases(), 20'000);
  for (std::size_t k = 0; k < draws; ++k) {
    const Eigen::Matrix3d rotation = dice.rotation();
    const double turn = dice.power(-3.0, 0.0) * 0.6;
    const double shift = k % 3 == 0 ? dice.between(0.0, 2.0) : 0.0;
    const bool clear = !pairs.may_meet({rotation, turn, shift});
    const bool within = pairs.overlap({rotation, turn, shift});
    ASSERT_FALSE(clear && within);
    apart += clear ? 1 : 0;
    overlap += within ? 1 : 0;
    for (int j = 0; (clear || within) && j < 3; ++j) {
      const double angle = turn * (j == 0 ? 1.0 : dice.between(0.0, 1.0));
      const Pose pose{Eigen::AngleAxisd(angle, dice.direction()).toRotationMatrix() * rotation,
                      shift * (j == 0 ? 1.0 : dice.between(0.0, 1.0)) * dice.direction()};
      ASSERT_EQ(pairs.impinged(pose), within) << k << ": " << turn << " rad, " << shift << " mm";
    }
  }
  EXPECT_GT(apart, draws / 20);
  EXPECT_GT(overlap, draws / 40);
}

// A face that is there twice changes nothing, and one that hangs on an edge of two others makes no inside.
TEST(BodyPairs, CountAFaceOnce) {
  const TriangleMesh spine = test::moved(icosphere(6.0, 1), {60.0, 0.0, 0.0});
  const TriangleMesh part = test::moved(icosphere(2.0, 1), {60.0, 0.0, 0.0});
  const BallSocketPair main{icosphere(20.0, 2), icosphere(300.0, 2)};
  for (std::size_t k = 0; k < spine.faces.size(); ++k) {
    TriangleMesh twice = spine;
    twice.faces.push_back(spine.faces[k]);
    const BodyPairs pairs(main, {{part}, {twice}});
    EXPECT_TRUE(pairs.impinged({})) << k;
    EXPECT_TRUE(pairs.overlap({.turn = 0.01})) << k;
  }
  TriangleMesh fin = spine;
  fin.vertices.push_back(80.0 * Vec3::UnitX());
  fin.faces.push_back({fin.faces[0][0], fin.faces[0][1], static_cast<VertexIndex>(fin.vertices.size() - 1)});
  EXPECT_FALSE(BodyPairs(main, {{part}, {fin}}).overlap({.turn = 0.01}));
}

// Two spheres 50 mm from the centre: proven apart for all turns by less than about what it takes, and one
// inside the other for all that leave it there.
TEST(BodyPairs, AreToldApartUntilTheyAreNear) {
  const auto at = [](double radius, double turned) {
    return test::moved(icosphere(radius, 3), 50.0 * Vec3(std::cos(turned), std::sin(turned), 0.0));
  };
  const BallSocketPair main{icosphere(20.0, 2), icosphere(300.0, 2)};
  for (const double turned : {0.5, 1.0, 2.0}) {
    const BodyPairs pairs(main, {{at(5.0, 0.0)}, {at(6.0, turned)}});
    const double apart = 100.0 * std::sin(0.5 * turned) - 11.0;
    const double reach = 2.0 * std::asin(apart / 112.0);  // of the farthest point, 56 mm from the centre
    EXPECT_FALSE(pairs.may_meet({.turn = 0.95 * reach})) << turned;
    EXPECT_FALSE(pairs.may_meet({.shift_mm = 0.95 * std::min(apart, 19.0)}))
        << turned << ", and from the balls";
    const auto met = pairs.may_meet({.turn = 1.2 * turned});
    ASSERT_TRUE(met) << turned;
    EXPECT_EQ(met->ball, 1U);
    EXPECT_EQ(met->socket, 1U);
  }
  const BodyPairs inside(main, {{at(2.0, 0.0)}, {at(9.0, 0.0)}});
  EXPECT_TRUE(inside.overlap({.turn = 0.1}));
  EXPECT_TRUE(inside.may_meet({.turn = 0.01})) << "its surface is nowhere near";
  EXPECT_FALSE(inside.overlap({.turn = 0.4}));
}

// Two spheres, and rotations about one that turn the angle between their middles by `turn` at most: clear
// where they are farther apart than the gap in all, in contact where they are nearer in all. The meshes are
// within their spheres, by no more than a sagitta.
TEST(BodyPairs, AreWithinAGapOfSpheresInClosedForm) {
  const BallSocketPair main{icosphere(5.0, 2), icosphere(300.0, 2)};
  test::Dice dice(7);
  std::size_t clear = 0;
  std::size_t within = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(random_cases(), 2000); ++k) {
    const std::array<double, 2> radius{dice.between(1.0, 6.0), dice.between(1.0, 6.0)};
    const std::array<double, 2> far{dice.between(30.0, 50.0), dice.between(30.0, 50.0)};
    const double between = dice.between(0.0, 0.6);
    double sagitta = 0.0;
    std::array<TriangleMesh, 2> part;
    for (std::size_t n = 0; n < 2; ++n) {
      part[n] = icosphere(radius[n], 2);
      for (const Face& face : part[n].faces) {
        const auto [a, b, c] = corners_of(part[n], face);
        sagitta = std::max(sagitta, radius[n] - ((a + b + c) / 3.0).norm());
      }
      const double at = n == 0 ? 0.0 : between;
      part[n] = test::moved(part[n], far[n] * Vec3(std::cos(at), std::sin(at), 0.0));
    }
    const double gap = dice.between(0.0, 6.0);
    const double turn = dice.power(-3.0, 0.0) * 0.5;
    const auto distance = [&](double angle) {
      const double squared = far[0] * far[0] + far[1] * far[1] - 2.0 * far[0] * far[1] * std::cos(angle);
      return std::sqrt(squared) - radius[0] - radius[1];
    };
    const double nearest = distance(std::max(0.0, between - turn));
    const double farthest = distance(between + turn);
    const double motion = 2.0 * (std::max(far[0], far[1]) + 6.0) * std::sin(0.5 * turn);
    const BodyPairs pairs(main, {{part[0]}, {part[1]}});
    const NearPoses poses{.turn = turn, .gap_mm = gap};
    const bool apart = !pairs.may_meet(poses);
    const bool touch = pairs.overlap(poses);
    ASSERT_FALSE(apart && nearest + 2.0 * sagitta < gap) << k;
    ASSERT_FALSE(touch && farthest > gap) << k;
    if (distance(between) > gap + motion + 1e-6) {
      ASSERT_TRUE(apart) << k;
    }
    // A vertex is that near where the surfaces are nearer by what a sphere's vertices leave out of it.
    if (distance(between) > 0.0 && distance(between) + 2.0 * sagitta + 1.0 < gap - motion) {
      ASSERT_TRUE(touch) << k;
    }
    clear += apart ? 1 : 0;
    within += touch ? 1 : 0;
  }
  EXPECT_GT(clear, 50U);
  EXPECT_GT(within, 50U);
}

// The nearest of several bodies, and how near it is.
TEST(BodyPairs, AreNearestInClosedForm) {
  const auto sphere = [](double radius, const Vec3& at) { return test::moved(icosphere(radius, 3), at); };
  const BallSocketPair main{icosphere(5.0, 3), icosphere(300.0, 2)};
  EXPECT_FALSE(BodyPairs(main, {}).nearest({}));
  const BodyPairs pairs(main, {{sphere(3.0, {40, 0, 0}), sphere(6.0, {0, 40, 0})},
                               {sphere(4.0, {0, 0, 60}), sphere(2.0, {0, 47, 20})}});
  test::Dice dice(13);
  for (std::size_t k = 0; k < 20; ++k) {
    const Pose pose{dice.rotation(), dice.vector()};
    double least = HUGE_VAL;
    std::array<std::size_t, 2> bodies{};
    const std::array<std::pair<double, Vec3>, 3> ball{
        {{5.0, Vec3::Zero()}, {3.0, {40, 0, 0}}, {6.0, {0, 40, 0}}}};
    const std::array<std::pair<double, Vec3>, 2> socket{{{4.0, {0, 0, 60}}, {2.0, {0, 47, 20}}}};
    for (std::size_t b = 0; b < ball.size(); ++b) {
      for (std::size_t s = 0; s < socket.size(); ++s) {
        const double distance =
            (to_socket(pose, ball[b].second) - socket[s].second).norm() - ball[b].first - socket[s].first;
        if (distance < least) bodies = {b, s + 1};
        least = std::min(least, distance);
      }
    }
    const BodyPairs::Nearest found = pairs.nearest(pose).value();
    EXPECT_EQ(found.touch, pairs.impinged(pose));
    if (found.touch) continue;
    EXPECT_GT(found.distance_mm, least - 1e-9);
    EXPECT_LT(found.distance_mm,
              least + 0.05);  // faces are inside of spheres of 6 and 4 mm by 0.026 and 0.017
    if (least < 10.0) {
      EXPECT_EQ((std::array{found.pair.ball, found.pair.socket}), bodies);
    }
  }
}

// Of a hip with parts, by CGAL's exact distances of vertices.
TEST(BodyPairs, AreWithinAGapWhereCgalSays) {
  const Hips hips;
  const BodyPairs pairs(hips.main, hips.beside);
  test::Dice dice(11);
  std::size_t clear = 0;
  std::size_t within = 0;
  for (std::size_t k = 0; clear + within < 24 && k < 10'000; ++k) {
    const Eigen::Matrix3d rotation = dice.rotation();
    const double gap = dice.between(2.0, 12.0);
    const double turn = dice.between(0.0, 0.05);
    const NearPoses poses{.rotation = rotation, .turn = turn, .gap_mm = gap};
    const bool apart = !pairs.may_meet(poses) && clear < 12;
    const bool touch =
        !apart && within < 12 && !pairs.overlap({.rotation = rotation, .turn = turn}) && pairs.overlap(poses);
    if (!apart && !touch) continue;
    ++(apart ? clear : within);
    const Pose pose{Eigen::AngleAxisd(turn, dice.direction()).toRotationMatrix() * rotation, Vec3::Zero()};
    double least = HUGE_VAL;
    const auto compare = [&](const TriangleMesh& ball, const TriangleMesh& socket) {
      const TriangleMesh moved = posed(ball, pose);
      for (const double d : closest_distances(moved, {socket.vertices})) least = std::min(least, d);
      for (const double d : closest_distances(socket, {moved.vertices})) least = std::min(least, d);
    };
    for (const TriangleMesh& spine : hips.beside.socket) {
      compare(hips.main.ball, spine);
      for (const TriangleMesh& part : hips.beside.ball) compare(part, spine);
    }
    for (const TriangleMesh& part : hips.beside.ball) compare(part, hips.main.socket);
    if (apart)
      EXPECT_GT(least, gap) << k;
    else
      EXPECT_TRUE(least <= gap || pairs.impinged(pose)) << k;
  }
  EXPECT_EQ(clear, 12U);
  EXPECT_EQ(within, 12U);
}

// Vertices at a known distance along the ray.
TEST(BodyPairs, AVertexIsNearAlongItsRay) {
  const TriangleMesh near = test::moved(icosphere(5.0, 2), {0.0, 0.0, 50.0});
  const TriangleMesh far = test::moved(icosphere(5.0, 2), {0.0, 0.0, 64.0});
  const BodyPairs pairs({icosphere(20.0, 2), icosphere(300.0, 2)}, {{near}, {far}});
  double least = HUGE_VAL;  // of a vertex of either along its ray, by all faces
  const auto measure = [&least](const TriangleMesh& of, const TriangleMesh& met) {
    for (const Vec3& x : of.vertices) {
      for (const Face& face : met.faces) {
        const auto [a, b, c] = corners_of(met, face);
        Eigen::Matrix3d corners;
        corners << a, b, c;
        const Vec3 share = corners.inverse() * x.normalized();
        if (share.minCoeff() >= 0.0) least = std::min(least, std::abs(1.0 / share.sum() - x.norm()));
      }
    }
  };
  measure(near, far);
  measure(far, near);
  ASSERT_LT(least, 10.0);
  EXPECT_FALSE(pairs.vertex_within({}, least - 1e-6));
  EXPECT_TRUE(pairs.vertex_within({}, least + 1e-6));
}

}  // namespace
}  // namespace impinge
