// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of bones against CGAL's exact intersection of all faces, in random poses; insides by the solid
// angle that a closed mesh fills, and of meshes with openings by what they were made from.
#include "limits/body_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <CGAL/intersections.h>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "contact/turn_surface.hpp"
#include "hip/hip.hpp"
#include "limits/near_poses.hpp"
#include "limits/swept_parts.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/bodies.hpp"
#include "mesh/collinear.hpp"
#include "mesh/edges.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/meeting_faces.hpp"
#include "mesh/star_shape.hpp"
#include "reference/closest_point.hpp"
#include "reference/kernel_point.hpp"
#include "reference/meeting_surfaces.hpp"
#include "support/dice.hpp"
#include "support/hip_with_parts.hpp"
#include "support/joined.hpp"
#include "support/poses.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

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

BodyPairs::Verdict verdict(const BodyPairs& pairs) { return pairs.verdict(Pose{}); }

// A head in a cropped socket, both far from what else there is.
BallSocketPair small_joint() { return {icosphere(5.0, 2), cup(8.0, 60.0, 100)}; }

// Of two parts beside the joint.
BodyPairs::Verdict verdict_of(const TriangleMesh& ball, const TriangleMesh& socket) {
  const BodyPairs::Verdict found = verdict(BodyPairs(small_joint(), {{ball}, {socket}}));
  if (found.contact != Contact::no) {
    EXPECT_EQ(found.pair.ball, 1U);
    EXPECT_EQ(found.pair.socket, 1U);
  }
  return found;
}

TriangleMesh sphere_at(double radius, std::size_t halvings, const Vec3& middle) {
  return test::moved(icosphere(radius, halvings), middle);
}

constexpr double kSpeck = 1e-3;  // mm
// A tetrahedron so small that it is a point to what it is in.
TriangleMesh speck(const Vec3& at) {
  return {{at + kSpeck * Vec3(1, 1, 1), at + kSpeck * Vec3(1, -1, -1), at + kSpeck * Vec3(-1, 1, -1),
           at + kSpeck * Vec3(-1, -1, 1)},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

const Vec3 kFar(60.0, 7.0, -3.0);  // of a part

// A thin tetrahedron from its point, as long as `along`.
TriangleMesh spike(const Vec3& point, const Vec3& along) {
  const Vec3 across = 0.1 * along.unitOrthogonal();
  const Vec3 aside = along.normalized().cross(across);
  const Vec3 end = point + along;
  return {{point, end + across, end - across + aside, end - across - aside},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

// Shifts take bodies to each other that a turn alone never brings near.
TEST(TheoremContact, MeetWhereCgalSays) {
  const Hips hips;
  const BodyPairs pairs(hips.main, hips.beside);
  ASSERT_FALSE(pairs.has_inside());
  std::vector<TriangleMesh> balls = hips.beside.ball;
  balls.push_back(hips.main.ball);
  std::vector<TriangleMesh> sockets = hips.beside.socket;
  sockets.push_back(hips.main.socket);
  test::Dice dice(2);
  std::array<std::size_t, 4> found{};  // surfaces, inside, radii, no
  for (std::size_t k = 0; k < std::min<std::size_t>(random_cases() / 10, 400); ++k) {
    const double far = std::array{0.0, 3.0, 12.0}[k % 3];
    const Pose pose{dice.rotation(), far * dice.vector()};
    bool meet = false;
    for (const TriangleMesh& ball : balls) {
      const TriangleMesh moved = test::ball_in_socket_frame(ball, pose);
      for (const TriangleMesh& socket : sockets) meet = meet || surfaces_meet(moved, socket);
    }
    const BodyPairs::Verdict said = pairs.verdict(pose);
    const bool by_surfaces = said.contact == Contact::yes && said.rule == ContactRule::surfaces;
    EXPECT_FALSE(by_surfaces && !meet) << k;
    EXPECT_FALSE(meet && said.contact != Contact::yes) << k;
    EXPECT_FALSE(meet && !pairs.meet(pose)) << k;
    if (!meet) {
      // No part of these is so large that another one is in it.
      EXPECT_FALSE(said.contact == Contact::yes && said.rule == ContactRule::inside && said.pair.ball != 0)
          << k;
    }
    ++found[said.contact == Contact::yes ? static_cast<std::size_t>(said.rule) : 3];
  }
  EXPECT_GT(found[0], 10U);
  EXPECT_GT(found[3], 5U);
}

// Closed bodies of random shape: in contact where the surfaces meet or the solid angle says that a corner of
// one is inside the other, and by which of these.
TEST(TheoremContact, OfClosedBodiesAreWhatSolidAnglesSay) {
  test::Dice dice(3);
  std::array<std::size_t, 3> found{};
  for (std::size_t k = 0; k < std::min<std::size_t>(random_cases(), 3000); ++k) {
    std::array<TriangleMesh, 2> body;
    for (TriangleMesh& mesh : body) {
      const TriangleMesh round = k % 2 == 0 ? octahedron(1.0) : icosphere(1.0, 1);
      mesh = test::turned(round, dice.rotation());
      const double size = dice.power(-1.0, 1.0);
      for (Vec3& x : mesh.vertices) x = kFar + size * dice.between(0.7, 1.0) * x;
    }
    body[0] = test::moved(body[0], dice.power(-1.0, 1.0) * dice.direction());
    const bool meet = surfaces_meet(body[0], body[1]);
    const bool holds = is_inside(body[0], body[1].vertices[0]) || is_inside(body[1], body[0].vertices[0]);
    const BodyPairs::Verdict said = verdict_of(body[0], body[1]);
    ASSERT_EQ(said.contact, meet || holds ? Contact::yes : Contact::no) << k;
    if (said.contact == Contact::yes) {
      ASSERT_EQ(said.rule, meet ? ContactRule::surfaces : ContactRule::inside) << k;
    }
    ++found[meet ? 0 : holds ? 1 : 2];
  }
  for (const std::size_t of_kind : found) EXPECT_GT(of_kind, 50U);
}

// A bone of which a face is missing, any one, has an inside still, and none in front of the hole.
TEST(BodyPairs, ABoneWithAHoleHasAnInside) {
  const TriangleMesh bone = sphere_at(10.0, 2, kFar);
  for (std::size_t f = 0; f < bone.faces.size(); f += 7) {
    TriangleMesh open = bone;
    open.faces.erase(open.faces.begin() + static_cast<std::ptrdiff_t>(f));
    const Vec3 hole = area_vector(bone, bone.faces[f]).normalized();
    EXPECT_EQ(verdict_of(speck(kFar), open).contact, Contact::yes) << f;
    EXPECT_EQ(verdict_of(open, speck(kFar - 5.0 * hole)).contact, Contact::yes) << f;
    EXPECT_EQ(verdict_of(speck(kFar + 8.0 * hole), open).contact, Contact::yes) << f;
    EXPECT_EQ(verdict_of(speck(kFar + 12.0 * hole), open).contact, Contact::no) << f;
    EXPECT_NE(verdict_of(speck(kFar - 12.0 * hole), open).contact, Contact::yes) << f;
  }
}

// A needle through a hole is inside with its point alone, whichever corner of it comes first; cells say so
// too.
TEST(BodyPairs, ANeedleThroughAHoleIsInside) {
  TriangleMesh bone = sphere_at(10.0, 3, kFar);
  const auto [a, b, c] = corners_of(bone, bone.faces[0]);
  const Vec3 middle = (a + b + c) / 3.0;
  const Vec3 out = area_vector(bone, bone.faces[0]).normalized();
  bone.faces.erase(bone.faces.begin());
  for (const double depth : {4.0, -1.0, -20.0}) {
    for (std::size_t first = 0; first < 4; ++first) {
      TriangleMesh needle = spike(middle - depth * out, 8.0 * out);
      std::swap(needle.vertices[0], needle.vertices[first]);
      for (const bool of_ball : {true, false}) {
        const BodyPairs pairs(small_joint(), {{of_ball ? needle : bone}, {of_ball ? bone : needle}});
        EXPECT_EQ(verdict(pairs).contact, depth > 0.0 ? Contact::yes : Contact::no) << first;
        EXPECT_EQ(verdict(pairs).rule, depth > 0.0 ? ContactRule::inside : verdict(pairs).rule);
        EXPECT_TRUE(depth < 0.0 || pairs.may_meet({.turn = 1e-6})) << first;
        // The point comes in where surfaces are apart all the time.
        EXPECT_EQ(pairs.may_meet({.shift_mm = 1.2}).has_value(), depth > -20.0) << first;
      }
    }
  }
}

// A point half a millimetre before a hole comes in with a shift of more than that. The rim is three times as
// far.
TEST(BodyPairs, ANeedleBeforeAHoleMayComeIn) {
  TriangleMesh bone = sphere_at(10.0, 1, kFar);
  const auto [a, b, c] = corners_of(bone, bone.faces[0]);
  const Vec3 middle = (a + b + c) / 3.0;
  const Vec3 out = area_vector(bone, bone.faces[0]).normalized();
  bone.faces.erase(bone.faces.begin());
  const TriangleMesh needle = spike(middle + 0.5 * out, 7.5 * out);
  for (const bool of_ball : {true, false}) {
    const BodyPairs pairs(small_joint(), {{of_ball ? needle : bone}, {of_ball ? bone : needle}});
    EXPECT_EQ(verdict(pairs).contact, Contact::no);
    EXPECT_FALSE(pairs.may_meet({.shift_mm = 0.4}));
    EXPECT_TRUE(pairs.may_meet({.shift_mm = 0.8}));
  }
}

// A needle through a bone with two holes is inside with none of its corners, and meets no surface. One that
// only is in front of a hole, aslant, with no corner near, is outside.
TEST(BodyPairs, ANeedleThroughTwoHolesIsNotKnownToBeOutside) {
  TriangleMesh bone = sphere_at(10.0, 3, kFar);
  const Vec3 out = area_vector(bone, bone.faces[0]).normalized();
  std::erase_if(bone.faces, [&](const Face& face) {
    return std::abs(area_vector(bone, face).normalized().dot(out)) > 1.0 - 1e-9;
  });
  ASSERT_EQ(bone.faces.size(), icosphere(1.0, 3).faces.size() - 2);
  const Vec3 aslant = 30.0 * (out + out.unitOrthogonal()).normalized();
  for (const bool of_ball : {true, false}) {
    const auto pairs_with = [&](const TriangleMesh& other) {
      return BodyPairs(small_joint(), {{of_ball ? other : bone}, {of_ball ? bone : other}});
    };
    const BodyPairs through = pairs_with(spike(kFar - 30.0 * out, 60.0 * out));
    EXPECT_EQ(verdict(through).contact, Contact::unknown);
    EXPECT_EQ(through.nearest_part({}).value().touch, Contact::unknown);
    EXPECT_TRUE(through.may_meet({.turn = 1e-6}));
    const BodyPairs before = pairs_with(spike(kFar + 15.0 * out - aslant, 2.0 * aslant));
    EXPECT_EQ(verdict(before).contact, Contact::no);
    EXPECT_FALSE(before.may_meet({.turn = 1e-6}));
  }
}

// Of a main ball with a hole, whose radii are clear: a spike of the socket, which is a sheet, has its point
// inside or in front of the hole.
TEST(BodyPairs, ASpikeOfASheetComesIntoABallThroughItsHole) {
  const TriangleMesh whole = icosphere(10.0, 3);
  const auto lowest = std::ranges::min_element(
      whole.faces, {}, [&](const Face& face) { return area_vector(whole, face).normalized().z(); });
  const Vec3 out = area_vector(whole, *lowest).normalized();
  for (const double depth : {4.0, -1.0}) {
    TriangleMesh ball = whole;
    ball.faces.erase(ball.faces.begin() + (lowest - whole.faces.begin()));
    const TriangleMesh socket = test::joined(cup(14.0, 60.0, 100), spike((10.0 - depth) * out, 12.0 * out));
    const BodyPairs pairs({ball, socket}, {});
    ASSERT_TRUE(pairs.has_radial());
    EXPECT_EQ(verdict(pairs).contact, depth > 0.0 ? Contact::yes : Contact::no);
    EXPECT_EQ(verdict(pairs).rule, depth > 0.0 ? ContactRule::inside : verdict(pairs).rule);
  }
}

// Nor does a speck meet the surface of the body that a turn of a right angle puts round it.
TEST(BodyPairs, ASpeckIsInsideWhereATurnTakesIt) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5 * kPi, Vec3::UnitZ()).toRotationMatrix();
  for (const bool of_ball : {true, false}) {
    const TriangleMesh ball = of_ball ? speck(kFar) : sphere_at(5.0, 2, kFar);
    const TriangleMesh socket = of_ball ? sphere_at(5.0, 2, turn * kFar) : speck(turn * kFar);
    const BodyPairs pairs(small_joint(), {{ball}, {socket}});
    const auto take = [](const ClosePair&) { return true; };
    EXPECT_TRUE(pairs.may_meet({.rotation = turn, .turn = 1e-3}));
    EXPECT_FALSE(pairs.each_close({.rotation = turn, .turn = 1e-3}, false, take));
    EXPECT_FALSE(pairs.may_meet({.rotation = turn.transpose(), .turn = 1e-3}));
    EXPECT_TRUE(pairs.each_close({.rotation = turn.transpose(), .turn = 1e-3}, false, take));
  }
}

// Faces towards the hollow are those of a socket, which does not hold what is in it. Behind the faces of a
// part nothing is known, whichever way they are wound; a main surface is that of a head that was cropped.
TEST(BodyPairs, WhatIsBehindASheetIsKnownOfMainSurfacesOnly) {
  for (const double opening : {60.0, 85.0, 90.0}) {
    const TriangleMesh socket = test::moved(cup(10.0, opening, 400), kFar);
    const TriangleMesh head = test::inside_out(socket);
    for (const double up : {9.0, 7.0}) {
      const Vec3 in_hollow = kFar + Vec3(0.3, 0.2, up);
      EXPECT_EQ(verdict_of(speck(in_hollow), socket).contact, Contact::no) << opening;
      EXPECT_EQ(verdict_of(speck(in_hollow), head).contact, Contact::unknown) << opening;
      for (const TriangleMesh& main : {cup(10.0, opening, 400), test::inside_out(cup(10.0, opening, 400))}) {
        const BodyPairs pairs({main, cup(20.0, opening, 400)}, {{}, {speck(in_hollow - kFar)}});
        EXPECT_EQ(verdict(pairs).contact, Contact::yes) << opening;
      }
    }
    EXPECT_NE(verdict_of(speck(kFar + Vec3(0.3, 0.2, 11.0)), socket).contact, Contact::yes) << opening;
    EXPECT_NE(verdict_of(speck(kFar + Vec3(0.3, 0.2, 11.0)), head).contact, Contact::yes) << opening;
    EXPECT_EQ(verdict_of(sphere_at(4.0, 1, kFar + Vec3(0, 0, 3)), socket).contact, Contact::no) << opening;
  }
}

// A thick wall that is cropped: its outer faces are farther from the centre, and more, than those of the
// bearing surface, whose normals tell on which side its bone is.
TEST(BodyPairs, ACroppedThickSocketHasItsBoneBehindTheBearingSurface) {
  TriangleMesh wall = test::with_back(cup(26.0, 60.0, 400), cup(40.0, 60.0, 400));
  std::erase_if(wall.faces, [&](const Face& face) {
    const Vec3 middle = (wall.vertices[face[0]] + wall.vertices[face[1]] + wall.vertices[face[2]]) / 3.0;
    return middle.norm() > 35.0 && middle.z() > 0.9 * middle.norm();
  });
  const auto in_pose = [&](const TriangleMesh& socket, double radius) {
    return verdict(BodyPairs({sphere(20.0, 400), socket}, {{speck(radius * Vec3(0.6, 0.0, 0.8))}, {}}))
        .contact;
  };
  for (const TriangleMesh& socket : {wall, test::inside_out(wall)}) {
    EXPECT_EQ(in_pose(socket, 33.0), Contact::yes);
    EXPECT_EQ(in_pose(socket, 23.0), Contact::no);
    EXPECT_EQ(in_pose(socket, 45.0), Contact::no);
  }
}

// Two sheets of which one is a part: none has an inside, so that contact in all of many poses is not shown.
// Between the main surfaces alone radii decide.
TEST(BodyPairs, TwoSheetsHaveNoInside) {
  const TriangleMesh sheet = test::inside_out(test::moved(cup(10.0, 60.0, 400), kFar));
  const TriangleMesh bone = sphere_at(2.0, 1, kFar);
  const BallSocketPair cropped{cup(5.0, 60.0, 100), test::inside_out(cup(8.0, 60.0, 100))};
  const auto told = [](const BallSocketPair& main, const BoneParts& beside) {
    return BodyPairs(main, beside).without_inside();
  };
  EXPECT_FALSE(told(cropped, {}));
  EXPECT_FALSE(told(cropped, {{bone}, {bone}}));
  EXPECT_FALSE(told(small_joint(), {{}, {sheet}})) << "a closed ball has an inside";
  EXPECT_TRUE(told(cropped, {{}, {}, cropped.ball, cropped.socket}))
      << "of whole bones radii do not decide alone";
  const auto parts = told(cropped, {{bone, sheet}, {bone, sheet}});
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->ball, 2U);
  EXPECT_EQ(parts->socket, 2U);
}

// Of main surfaces: a head behind a cropped socket, which nothing meets, is in contact by radii. What a
// motion comes to is asked without these.
TEST(BodyPairs, BehindASheetRadiiDecide) {
  BallSocketPair main = small_joint();
  const BodyPairs pairs(main, {});
  EXPECT_FALSE(pairs.has_inside());
  EXPECT_EQ(verdict(pairs).contact, Contact::no);
  const Pose behind{Eigen::Matrix3d::Identity(), Vec3(0, 0, 20)};
  const BodyPairs::Verdict said = pairs.verdict(behind);
  EXPECT_EQ(said.contact, Contact::yes);
  EXPECT_EQ(said.rule, ContactRule::radii);
  EXPECT_FALSE(pairs.meet(behind));
  const Pose through{Eigen::Matrix3d::Identity(), Vec3(0, 0, 5)};
  EXPECT_EQ(pairs.verdict(through).rule, ContactRule::surfaces);
  EXPECT_TRUE(pairs.meet(through));
  // A whole pelvis has an inside: what is behind it is not in contact.
  const TriangleMesh pelvis = test::with_back(main.socket, cup(12.0, 60.0, 100));
  ASSERT_TRUE(boundary_edges(pelvis).empty());
  BoneParts whole;
  whole.whole_socket = pelvis;
  main.ball = icosphere(1.0, 2);
  const BodyPairs bones(main, whole);
  EXPECT_EQ(bones.has_inside(), true);
  EXPECT_EQ(bones.verdict({Eigen::Matrix3d::Identity(), Vec3(0, 0, 20)}).contact, Contact::no);
  const BodyPairs::Verdict in_bone = bones.verdict({Eigen::Matrix3d::Identity(), Vec3(0, 0, 10)});
  EXPECT_EQ(in_bone.contact, Contact::yes);
  EXPECT_EQ(in_bone.rule, ContactRule::inside);
}

// Two layers, as those of cartilage, are hollow: about the centre, beside it, and far off behind both.
TEST(BodyPairs, AShellIsHollow) {
  for (const Vec3& off : {Vec3(0, 0, 0), Vec3(1e-3, -2e-3, 5e-4), Vec3(15, 10, 0), Vec3(40, 3, 5)}) {
    for (const bool turned : {false, true}) {
      TriangleMesh shell = test::joined(test::moved(octahedron(25.0), off),
                                        test::inside_out(test::moved(octahedron(20.0), off)));
      if (turned) shell = test::inside_out(shell);
      const auto said = [&](double far) {
        const BallSocketPair main{shell, cup(300.0, 60.0, 100)};
        return verdict(BodyPairs(main, {{}, {speck(off + far * Vec3(0.5, 0.3, 0.2))}})).contact;
      };
      EXPECT_EQ(said(0.0), Contact::no);
      EXPECT_EQ(said(19.0), Contact::no);
      EXPECT_EQ(said(22.0), Contact::yes);
      EXPECT_EQ(said(26.0), Contact::no);
      EXPECT_EQ(said(120.0), Contact::no);
    }
  }
}

// A half ball that is closed by a disc next to the centre, on either side of it, straight and tilted: behind
// the disc is outside, however near to it the centre is.
TEST(BodyPairs, ADiscNextToTheCentreClosesABone) {
  for (const double at : {0.0, 1e-15, -1e-15, 1e-6, -1e-6, 1e-3, -1e-3}) {
    for (const bool tilted : {false, true}) {
      TriangleMesh half = test::inside_out(cup(20.0, 90.0, 400));
      const std::vector<Edge> rim = boundary_edges(half);
      half.vertices.emplace_back(0, 0, 0);
      for (const auto& [a, b] : rim)
        half.faces.push_back({b, a, static_cast<VertexIndex>(half.vertices.size() - 1)});
      half = test::moved(half, {0, 0, at});
      const Eigen::Matrix3d turn = tilted
                                       ? Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix()
                                       : Eigen::Matrix3d::Identity();
      const BallSocketPair main{test::turned(half, turn), test::turned(cup(30.0, 60.0, 100), turn)};
      const auto said = [&](const Vec3& x) {
        return verdict(BodyPairs(main, {{}, {speck(turn * x)}})).contact;
      };
      EXPECT_EQ(said({3, 2, -0.01}), Contact::no) << at;
      EXPECT_EQ(said({3, 2, -60}), Contact::no) << at;
      EXPECT_EQ(said({50, 20, -1}), Contact::no) << at;
      EXPECT_EQ(said({3, 2, 0.01}), Contact::yes) << at;
      EXPECT_EQ(said({3, 2, 15}), Contact::yes) << at;
    }
  }
}

// A face that is there twice changes nothing, whichever way round, and one that hangs on an edge of two
// others makes no inside.
TEST(BodyPairs, CountAFaceOnce) {
  const TriangleMesh bone = sphere_at(6.0, 1, kFar);
  const TriangleMesh inner = sphere_at(2.0, 1, kFar);
  const BallSocketPair main = small_joint();
  for (std::size_t k = 0; k < bone.faces.size(); ++k) {
    TriangleMesh twice = bone;
    twice.faces.push_back(bone.faces[k]);
    if (k % 2 == 0) std::swap(twice.faces.back()[0], twice.faces.back()[1]);
    BodyPairs pairs(main, {{inner}, {twice}});
    pairs.find_inner_balls(main);
    EXPECT_EQ(verdict(pairs).contact, Contact::yes) << k;
    EXPECT_EQ(verdict_of(speck(kFar + Vec3(0, 0, 9)), twice).contact, Contact::no) << k;
    EXPECT_TRUE(pairs.overlap({.turn = 0.01})) << k;
  }
  TriangleMesh fin = bone;
  fin.vertices.push_back(kFar + 20.0 * Vec3::UnitX());
  fin.faces.push_back({fin.faces[0][0], fin.faces[0][1], static_cast<VertexIndex>(fin.vertices.size() - 1)});
  for (const double far : {7.0, 12.0, 18.0, 30.0})
    EXPECT_NE(verdict_of(speck(kFar + far * Vec3(0.9, 0.1, 0.4)), fin).contact, Contact::yes) << far;
}

// A T-junction that is closed by a face without area: one bone, without an opening.
TEST(BodyPairs, AFaceWithoutAreaClosesAJunction) {
  TriangleMesh bone = test::moved(octahedron(10.0), kFar);
  const auto [a, b, c] = bone.faces[0];
  const auto middle = static_cast<VertexIndex>(bone.vertices.size());
  bone.vertices.push_back(0.5 * (bone.vertices[a] + bone.vertices[b]));
  bone.faces[0] = {a, middle, c};
  bone.faces.push_back({middle, b, c});
  bone.faces.push_back({a, b, middle});
  ASSERT_TRUE(boundary_edges(bone).empty());
  test::Dice dice(5);
  for (int k = 0; k < 100; ++k) {
    const Vec3 x = dice.between(0.0, 15.0) * dice.direction();
    const double depth = 10.0 - x.cwiseAbs().sum();
    if (std::abs(depth) < 0.1) continue;
    EXPECT_EQ(verdict_of(speck(kFar + x), bone).contact, depth > 0.0 ? Contact::yes : Contact::no) << x;
  }
}

// Specks at the places of a lattice, in regular bodies on it: edges and corners are in line with many of
// them.
TEST(BodyPairs, OfALatticeAreItsPlaces) {
  TriangleMesh cube;  // 4 mm wide
  for (int k = 0; k < 8; ++k) cube.vertices.emplace_back(2 * (k & 1) - 1, (k & 2) - 1, (k & 4) / 2 - 1);
  for (Vec3& x : cube.vertices) x = kFar + 2.0 * x;
  cube.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const TriangleMesh eight = test::moved(octahedron(4.0), kFar);
  for (int k = 0; k < 343; ++k) {
    const Vec3 x(k % 7 - 3, k / 7 % 7 - 3, k / 49 - 3);
    const double of_cube = 2.0 - x.cwiseAbs().maxCoeff();
    const double of_eight = 4.0 - x.cwiseAbs().sum();
    const auto expect = [&](double depth) { return depth >= 0.0 ? Contact::yes : Contact::no; };
    EXPECT_EQ(verdict_of(speck(kFar + x), cube).contact, expect(of_cube)) << x.transpose();
    EXPECT_EQ(verdict_of(eight, speck(kFar + x)).contact, expect(of_eight)) << x.transpose();
    if (of_cube == 0.0) {
      EXPECT_EQ(verdict_of(speck(kFar + x), cube).rule, ContactRule::surfaces) << x.transpose();
    }
  }
}

// Bone of the ball beyond the socket: its tip turns over corners of the socket's back, at a distance. Beyond
// all of the socket's faces along its rays, it is in contact only where that distance is below 0.
TEST(BodyPairs, BonePassesBehindBone) {
  const TriangleMesh inner = cup(26.0, 60.0, 400);
  const TriangleMesh pelvis = test::with_back(inner, cup(30.0, 60.0, 400));
  ASSERT_TRUE(boundary_edges(pelvis).empty());
  std::size_t top = inner.vertices.size();  // of the back: its pole
  for (std::size_t v = top; v < pelvis.vertices.size(); ++v)
    if (pelvis.vertices[v].z() > pelvis.vertices[top].z()) top = v;
  ASSERT_NEAR(pelvis.vertices[top].z(), 30.0, 1e-12);
  for (const double distance : {5.0, 1e-3, 1e-6, -1e-6, -1e-3}) {
    // The tip begins 120 degrees off, and turns about +x to the pole and beyond.
    const auto place = [&](double radius, double degrees, double x) {
      return Vec3(x, radius * std::sin((degrees - 120.0) * kDegree),
                  radius * std::cos((degrees - 120.0) * kDegree));
    };
    TriangleMesh femur = icosphere(20.0, 2);
    const TriangleMesh wing{
        {place(30.0 + distance, 0, 0), place(50, -4, 0), place(50, 3, 5), place(50, 3, -5)},
        {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    BoneParts whole;
    whole.whole_ball = test::joined(femur, wing);
    whole.whole_socket = pelvis;
    const BallSocketPair main{femur, inner};
    const BodyPairs pairs(main, whole);
    EXPECT_TRUE(pairs.has_inside());
    const JointTurn turn{.axis = -Vec3::UnitX()};
    const auto pose = [&](double degrees) {
      return Pose{Eigen::AngleAxisd(degrees * kDegree, turn.axis).toRotationMatrix(), Vec3::Zero()};
    };
    const auto contact = pairs.first_contact(turn, {0.0, kPi});
    EXPECT_EQ(contact.has_value(), distance < 0.0) << distance;
    EXPECT_EQ(TurnLimits(main, whole).first_contact(turn, 180.0).state,
              distance < 0.0 ? LimitState::limited : LimitState::free)
        << distance;
    EXPECT_EQ(pairs.verdict(pose(120.0)).contact, distance < 0.0 ? Contact::yes : Contact::no) << distance;
    if (contact) {
      EXPECT_GT(contact->angle, 59.9 * kDegree) << "the rim has a corner on the way";
      EXPECT_LT(contact->angle, 120.0 * kDegree);
    }
    for (const double past : {100.0, 110.0, 130.0, 140.0})
      EXPECT_EQ(pairs.verdict(pose(past)).contact == Contact::yes, distance < -1e-2) << past;
    EXPECT_FALSE(pairs.may_meet({.rotation = pose(30.0).rotation, .turn = 0.1})) << distance;
  }
}

// Vertices within a distance of a place, and whether each is inside by a depth: by a look at all of them.
TEST(BodyPairs, VerticesNearAPlaceAreThoseOfALookAtAll) {
  const BallSocketPair main = small_joint();
  const TriangleMesh ball = sphere_at(6.0, 2, kFar);
  const TriangleMesh socket = sphere_at(9.0, 2, kFar + Vec3(7, 2, 1));
  const BodyPairs pairs(main, {{ball}, {socket}});
  test::Dice dice(6);
  std::size_t inside = 0;
  std::size_t listed = 0;
  for (int k = 0; k < 30; ++k) {
    const Pose pose{Eigen::AngleAxisd(0.05 * k / 30.0, dice.direction()).toRotationMatrix(),
                    dice.direction()};
    const Vec3 place = kFar + 8.0 * dice.vector();
    const double within = dice.between(1.0, 12.0);
    const auto of_ball = std::ranges::count_if(
        ball.vertices, [&](const Vec3& x) { return (to_socket(pose, x) - place).norm() <= within; });
    const auto of_socket =
        std::ranges::count_if(socket.vertices, [&](const Vec3& y) { return (y - place).norm() <= within; });
    const auto found = pairs.near({1, 1}, pose, place, within);
    EXPECT_EQ(std::ssize(found), of_ball + of_socket) << k;
    listed += found.size();
    for (const BodyPairs::Vertex& vertex : found) {
      const TriangleMesh& own = vertex.of_ball ? ball : socket;
      ASSERT_NE(std::ranges::find(own.vertices, vertex.x), own.vertices.end());
      const Vec3 x = vertex.of_ball ? to_socket(pose, vertex.x) : to_ball(pose, vertex.x);
      const TriangleMesh& other = vertex.of_ball ? socket : ball;
      const double far = closest_distances(other, {std::span(&x, 1)})[0];
      const bool holds = is_inside(other, x);
      inside += holds ? 1 : 0;
      EXPECT_EQ(pairs.is_inside_by(vertex, pose, far - 1e-6), holds && far > 1e-6) << k;
      EXPECT_FALSE(pairs.is_inside_by(vertex, pose, far + 1e-6)) << k;
    }
  }
  EXPECT_GT(inside, 20U);
  EXPECT_GT(listed, inside + 20U);
}

// A sphere in another one, of which either may be the larger, and beside it.
TEST(BodyPairs, OneInsideTheOtherIsContact) {
  const BallSocketPair main{icosphere(20.0, 2), cup(300.0, 60.0, 100)};
  const auto at = [](double radius, double x) { return sphere_at(radius, 2, {x, 0.0, 0.0}); };
  const auto inside = [&](const BoneParts& parts) {
    const BodyPairs::Verdict said = verdict(BodyPairs(main, parts));
    return said.contact == Contact::yes && said.rule == ContactRule::inside;
  };
  for (const auto& [ball, socket] : {std::pair{5.0, 9.0}, std::pair{9.0, 5.0}}) {
    EXPECT_TRUE(inside({{at(ball, 60.0)}, {at(socket, 61.0)}}));
    EXPECT_EQ(verdict(BodyPairs(main, {{at(ball, 60.0)}, {at(socket, 90.0)}})).contact, Contact::no);
  }
  EXPECT_TRUE(inside({{}, {at(3.0, 10.0)}})) << "in the head";
  EXPECT_FALSE(inside({{}, {at(3.0, 30.0)}})) << "beside the head";
}

// What is said of all rotations near one, in random ones of them, at their end too, and with shifts.
class TheoremContactInManyRotations : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(OfAShaft, TheoremContactInManyRotations, testing::Bool(), [](const auto& cut) {
  return std::string(cut.param ? "ThatIsCut" : "ThatIsWhole");
});

TEST_P(TheoremContactInManyRotations, HoldInEveryOne) {
  Hips hips;
  if (GetParam()) {
    std::erase_if(hips.main.ball.faces, [&](const Face& face) {
      return std::ranges::any_of(face, [&](VertexIndex v) { return hips.main.ball.vertices[v].z() < -45.0; });
    });
    ASSERT_FALSE(boundary_edges(hips.main.ball).empty());
    hips.beside.socket.push_back(
        test::moved(icosphere(6.0, 1), {30.0, 40.0, 95.0}));  // to come behind the cut
  }
  BodyPairs pairs(hips.main, hips.beside);
  pairs.find_inner_balls(hips.main);
  test::Dice dice(3);
  std::size_t apart = 0;
  std::size_t overlap = 0;
  const std::size_t draws = std::min<std::size_t>(2 * random_cases(), 3000);
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
      ASSERT_EQ(pairs.meet(pose), within) << k << ": " << turn << " rad, " << shift << " mm";
    }
  }
  EXPECT_GT(apart, draws / 20);
  EXPECT_GT(overlap, draws / 40);
}

// Two spheres 50 mm from the centre: proven apart for all turns by less than about what it takes, and one
// inside the other for all that leave it there.
TEST(BodyPairs, AreToldApartUntilTheyAreNear) {
  const auto at = [](double radius, double turned) {
    return test::moved(icosphere(radius, 3), 50.0 * Vec3(std::cos(turned), std::sin(turned), 0.0));
  };
  const BallSocketPair main{icosphere(20.0, 2), cup(300.0, 60.0, 100)};
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
  BodyPairs inside(main, {{at(2.0, 0.0)}, {at(9.0, 0.0)}});
  inside.find_inner_balls(main);
  EXPECT_TRUE(inside.overlap({.turn = 0.1}));
  EXPECT_TRUE(inside.may_meet({.turn = 0.01})) << "its surface is nowhere near";
  EXPECT_FALSE(inside.overlap({.turn = 0.4}));
}

// Two spheres, and rotations about one that turn the angle between their middles by `turn` at most: clear
// where they are farther apart than the gap in all, in contact where they are nearer in all. The meshes are
// within their spheres, by no more than a sagitta.
TEST(BodyPairs, AreWithinAGapOfSpheresInClosedForm) {
  const BallSocketPair main{icosphere(5.0, 2), cup(300.0, 60.0, 100)};
  test::Dice dice(7);
  std::size_t clear = 0;
  std::size_t within = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(random_cases(), 300); ++k) {
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
    BodyPairs pairs(main, {{part[0]}, {part[1]}});
    pairs.find_inner_balls(main);
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
  const BallSocketPair main{icosphere(5.0, 3), cup(300.0, 60.0, 100)};
  EXPECT_FALSE(BodyPairs(main, {}).nearest_part({}));
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
    const BodyPairs::Nearest found = pairs.nearest_part(pose).value();
    EXPECT_EQ(found.touch == Contact::yes, pairs.meet(pose));
    if (found.touch == Contact::yes) continue;
    EXPECT_GT(found.distance_mm, least - 1e-9);
    EXPECT_LT(found.distance_mm,
              least + 0.05);  // faces are inside of spheres of 6 and 4 mm by 0.026 and 0.017
    if (least < 10.0) {
      EXPECT_EQ((std::array{found.pair.ball, found.pair.socket}), bodies);
    }
  }
}

// Of a hip with parts, by CGAL's exact distances of vertices.
TEST(TheoremContact, AreWithinAGapWhereCgalSays) {
  const Hips hips;
  BodyPairs pairs(hips.main, hips.beside);
  pairs.find_inner_balls(hips.main);
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
      const TriangleMesh moved = test::ball_in_socket_frame(ball, pose);
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
      EXPECT_TRUE(least <= gap || pairs.meet(pose)) << k;
  }
  EXPECT_EQ(clear, 12U);
  EXPECT_EQ(within, 12U);
}

// Of two faces that do not meet some plane is found, if their normals are among the ways, and of two that
// meet none. A plane does what it says of the corners.
TEST(ClosePair, HasAPlaneUnlessItsFacesMeet) {
  test::Dice dice(77);
  std::array<std::size_t, 2> asked{};  // apart, meet
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const auto face = [&] { return Triangle{dice.vector(), dice.vector(), dice.vector()}; };
    const Triangle moved = face();
    Triangle other = face();
    const double size = dice.power(-2.0, 0.5);
    for (Vec3& x : other) x = moved[0] + size * x;
    const Vec3 to = other[0] + other[1] + other[2] - moved[0] - moved[1] - moved[2];
    const auto normal = [&](const Triangle& of) {
      const Vec3 n = (of[1] - of[0]).cross(of[2] - of[0]).normalized();
      return n.dot(to) < 0.0 ? Vec3(-n) : n;
    };
    const std::array<Vec3, 3> ways{dice.direction(), normal(moved), normal(other)};
    const bool meet = faces_meet(moved, other);
    const double gap = dice.whole(0, 1) == 0 ? 0.0 : 0.1;
    const ClosePair pair{moved, moved, other, ways, gap};
    bool found = false;
    for (std::size_t n = 0; n < ClosePair::kPlanes; ++n) {
      const std::optional<ApartPlane> plane = pair.plane(n);
      if (!plane) continue;
      found = true;
      EXPECT_NEAR(plane->normal.norm(), 1.0, 1e-12);
      for (const Vec3& x : moved) EXPECT_LT(plane->normal.dot(x), plane->least);
      for (const Vec3& y : other) EXPECT_GE(plane->normal.dot(y), plane->least + gap - 1e-12);
    }
    EXPECT_FALSE(meet && found) << k;
    EXPECT_TRUE(meet || found || gap > 0.0) << k;
    ++asked[meet ? 1 : 0];
  }
  EXPECT_GT(asked[0], random_cases() / 10);
  EXPECT_GT(asked[1], random_cases() / 50);
}

// A part of which no face has an area is in contact with nothing, however near.
TEST(BodyPairs, APartWithoutFacesIsNowhere) {
  const TriangleMesh flat{{kFar, kFar + Vec3::UnitX(), kFar + 2.0 * Vec3::UnitX()}, {{0, 1, 2}}};
  const TriangleMesh bone = sphere_at(6.0, 1, kFar);
  const BallSocketPair main{octahedron(5.0), cup(8.0, 60.0, 20)};
  for (const bool of_ball : {true, false}) {
    BodyPairs pairs(main, {{of_ball ? flat : bone}, {of_ball ? bone : flat}});
    pairs.find_inner_balls(main);
    EXPECT_EQ(verdict(pairs).contact, Contact::no);
    EXPECT_FALSE(pairs.may_meet({.turn = 0.01, .shift_mm = 0.5}));
    for (const NodePairs& left : pairs.left({.turn = kPi}, true)) EXPECT_TRUE(left.empty());
    EXPECT_FALSE(pairs.overlap({.turn = 0.01}));
    EXPECT_TRUE(pairs.each_close({.turn = 0.01}, false, [](const ClosePair&) { return false; }));
    EXPECT_TRUE(pairs.deepest({.turn = 0.01}, false, 5).empty());
    const BodyPairs::Nearest found = pairs.nearest_part({}).value();
    EXPECT_NE(of_ball ? found.pair.ball : found.pair.socket, 1U) << "of the bones only";
  }
  EXPECT_FALSE(BodyPairs({flat, main.socket}, {{}, {bone}}).nearest_part({}));
}

// Two places that are not known are told as the first of them, and one contact after them as the contact.
TEST(BodyPairs, TellTheFirstThatIsNotKnown) {
  const TriangleMesh sheet = test::inside_out(test::moved(cup(10.0, 60.0, 400), kFar));
  const TriangleMesh inside = speck(kFar + Vec3(0.3, 0.2, 9.0));
  const BodyPairs::Verdict said = verdict(BodyPairs(small_joint(), {{inside}, {sheet, sheet}}));
  EXPECT_EQ(said.contact, Contact::unknown);
  EXPECT_EQ(said.pair.socket, 1U);
  const BodyPairs::Verdict later =
      verdict(BodyPairs(small_joint(), {{inside}, {sheet, sheet, sphere_at(12.0, 1, kFar)}}));
  EXPECT_EQ(later.contact, Contact::yes);
  EXPECT_EQ(later.pair.socket, 3U);
}

// Of bodies that touch the surfaces are 0 mm apart, inside too; of two at the same angle of a turn the first
// is told.
TEST(BodyPairs, ThatTouchAreNearest) {
  const Vec3 turned = Eigen::AngleAxisd(0.6, Vec3::UnitZ()) * kFar;
  const BodyPairs pairs(small_joint(),
                        {{sphere_at(2.0, 1, kFar)}, {sphere_at(3.0, 1, turned), sphere_at(3.0, 1, turned)}});
  EXPECT_EQ(pairs.nearest_part({}).value().touch, Contact::no);
  for (const Vec3& off : {Vec3(0, 0, 0), Vec3(0, 0, 3)}) {
    const BodyPairs::Nearest found =
        pairs.nearest_part({Eigen::Matrix3d::Identity(), turned - kFar + off}).value();
    EXPECT_EQ(found.touch, Contact::yes);
    EXPECT_EQ(found.distance_mm, 0.0);
    EXPECT_EQ(found.pair.ball, 1U);
    EXPECT_EQ(found.pair.socket, 1U);
  }
  const TurnContact met = pairs.first_contact({.axis = Vec3::UnitZ()}, {0.0, kPi}).value();
  EXPECT_NEAR(met.angle, 0.6 - 2.0 * std::asin(2.5 / kFar.head<2>().norm()), 0.01);
  EXPECT_EQ(met.body, (std::array<std::size_t, 2>{1, 1}));
}

// Surfaces alone are in contact where they meet, and hold nothing.
TEST(BodyPairs, OfSurfacesHoldNothing) {
  const BodyPairs pairs = BodyPairs::of_surfaces({icosphere(5.0, 1), icosphere(9.0, 1)});
  EXPECT_FALSE(pairs.has_inside());
  EXPECT_EQ(verdict(pairs).contact, Contact::no);
  EXPECT_EQ(pairs.verdict({Eigen::Matrix3d::Identity(), Vec3(6, 0, 0)}).rule, ContactRule::surfaces);
  const BodyPairs bones({icosphere(5.0, 1), test::moved(icosphere(9.0, 1), {0, 0, 12})}, {});
  for (const BodyPairs::Vertex& vertex : bones.near({}, {}, {0, 0, 5}, 1.0)) {
    EXPECT_EQ(bones.is_inside_by(vertex, {}, 0.5), vertex.of_ball);
    EXPECT_FALSE(pairs.is_inside_by(vertex, {}, 0.5));
  }
}

// Where the caller decides about the main surfaces by radii, these may meet: faces of a whole bone that are
// of its main surface are left out against those of the other one, and no others.
TEST(BodyPairs, AreAskedBesideTheMainSurfacesAlone) {
  TriangleMesh femur = icosphere(20.0, 1);  // with a bump 0.5 mm below the cup
  Vec3& top = *std::ranges::max_element(femur.vertices, {}, [](const Vec3& x) { return x.z(); });
  top = 24.5 * Vec3::UnitZ();
  const TriangleMesh inner = cup(25.0, 60.0, 100);
  const BallSocketPair main{femur, inner};
  const auto at = [](double degrees, double far) {
    return Vec3(0, far * std::sin(degrees * kDegree), -far * std::cos(degrees * kDegree));
  };
  BoneParts whole;  // a pelvis with a wall, and on the femur a bone below it
  whole.whole_ball = test::joined(femur, test::moved(icosphere(1.5, 1), at(0.0, 27.5)));
  whole.whole_socket = test::with_back(inner, cup(30.0, 60.0, 100));
  ASSERT_TRUE(boundary_edges(*whole.whole_socket).empty());
  BodyPairs pairs(main, whole);
  const NearPoses shifted{.turn = 1e-3, .shift_mm = 1.0};
  EXPECT_TRUE(pairs.may_meet(shifted, true)) << "the main surfaces are not known yet";
  pairs.find_inner_balls(main, true);
  EXPECT_TRUE(pairs.may_meet(shifted));
  EXPECT_FALSE(pairs.may_meet(shifted, true));
  const NearPoses turned{.turn = 0.05, .shift_mm = 0.4};
  const auto close = [&](bool by_radii) {
    std::size_t count = 0;
    EXPECT_TRUE(pairs.each_close(turned, by_radii, [&](const ClosePair&) { return ++count > 0; }));
    return count;
  };
  EXPECT_GT(close(false), 0U);
  EXPECT_EQ(close(true), 0U);
  EXPECT_TRUE(pairs.may_meet({.turn = 1e-3, .shift_mm = 6.0}, true)) << "the rim is no main surface";
  // The bone below turns into the wall, 25 to 30 mm from the centre.
  const auto pose = [](double degrees) {
    return NearPoses{.rotation = Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitX()).toRotationMatrix(),
                     .turn = 1e-3};
  };
  for (const double degrees : {0.0, 60.0, 100.0}) {
    EXPECT_FALSE(pairs.may_meet(pose(degrees), true)) << degrees;
    EXPECT_FALSE(pairs.overlap(pose(degrees), true)) << degrees;
  }
  for (const double degrees : {140.0, 160.0}) {
    EXPECT_TRUE(pairs.may_meet(pose(degrees), true)) << degrees;
    EXPECT_TRUE(pairs.overlap(pose(degrees), true)) << degrees;
  }
}

// A ball and a socket of few faces, and what is beside them.
BodyPairs with_inner_balls(const TriangleMesh& ball, const TriangleMesh& socket) {
  const Vec3 away(0.0, 0.0, -60.0);
  const BallSocketPair main{test::moved(octahedron(5.0), away), test::moved(cup(8.0, 60.0, 20), away)};
  BodyPairs pairs(main, {{ball}, {socket}});
  pairs.find_inner_balls(main);
  return pairs;
}

// A part that is a sheet holds nothing; points of it are found inside another body, and within a gap.
TEST(BodyPairs, ASheetIsInsideABodyWithItsPoints) {
  const TriangleMesh sheet = test::moved(cup(5.0, 60.0, 100), kFar);
  const TriangleMesh round = sphere_at(8.0, 1, kFar);
  const BodyPairs in_round = with_inner_balls(sheet, round);
  const BodyPairs round_it = with_inner_balls(round, sheet);
  const BodyPairs above = with_inner_balls(sheet, sphere_at(2.0, 2, kFar + Vec3(0, 0, 10)));  // by 3 mm
  const BodyPairs below = with_inner_balls(sphere_at(2.0, 2, kFar + Vec3(0, 0, 1)), sheet);   // by 2 mm
  for (const double shift : {0.0, 0.5}) {
    const NearPoses poses{.turn = 1e-4, .shift_mm = shift};
    EXPECT_TRUE(in_round.overlap(poses));
    EXPECT_TRUE(round_it.overlap(poses));
    EXPECT_FALSE(above.overlap(poses));
    EXPECT_FALSE(below.overlap(poses));
  }
  EXPECT_TRUE(above.overlap({.turn = 1e-4, .gap_mm = 3.3}));
  EXPECT_FALSE(above.overlap({.turn = 1e-4, .gap_mm = 2.9}));
  EXPECT_TRUE(below.overlap({.turn = 1e-4, .gap_mm = 2.5}));
  EXPECT_FALSE(below.overlap({.turn = 1e-4, .gap_mm = 1.9}));
}

// A speck at x, as far from the body's surface and its openings as `depth`, and outside if that is 0, stays
// inside in all poses that are shifted by a share of that, and in no poses of a larger shift.
void expect_stays_inside(const TriangleMesh& body, const Vec3& x, double depth, double share = 0.7) {
  for (const bool of_ball : {true, false}) {
    const BodyPairs pairs = of_ball ? with_inner_balls(speck(x), body) : with_inner_balls(body, speck(x));
    EXPECT_EQ(pairs.overlap({.turn = 1e-6, .shift_mm = share * depth}), depth > 0.0);
    for (const double shift : {depth + 0.01, 40.0})
      EXPECT_FALSE(pairs.overlap({.turn = 1e-6, .shift_mm = shift})) << shift;
    const std::vector<WithinReach> found = pairs.deepest({.turn = 1e-6}, false, 1);
    ASSERT_EQ(found.size(), depth > 0.0 ? 1U : 0U);
    if (found.empty()) continue;
    const double deepest = found[0].reach - (found[0].of_ball - found[0].of_socket).norm();
    EXPECT_GT(deepest, share * depth);
    EXPECT_LT(deepest, depth + 0.01);
  }
}

TEST(BodyPairs, ASpeckStaysInsideAsLongAsItIsDeep) {
  const TriangleMesh cube = octahedron(10.0);
  const auto part = [](const TriangleMesh& mesh) { return test::moved(mesh, kFar); };
  const double deep = 10.0 / std::sqrt(3.0);
  for (const TriangleMesh& body : {part(cube), part(test::inside_out(cube))}) {
    expect_stays_inside(body, kFar, deep);
    expect_stays_inside(body, kFar + Vec3(4, 4, 4), 0.0);
  }
}

// A face so thin that doubles give it no normal, and no speck less depth: a body is closed only with it.
TEST(BodyPairs, AFaceWithoutANormalClosesABody) {
  const Vec3 end(3, 3, 3);
  double x = 1.5;
  const auto middle = [&] { return Vec3(x, std::nextafter(x, 2.0), x); };
  while (turn_face(end, Vec3::Zero(), middle()).normal.norm() > 0.0) x = std::nextafter(x, 2.0);
  const TriangleMesh body{{Vec3::Zero(), end, middle(), {9, 0, 0}, {0, 9, 0}},
                          {{0, 1, 3}, {1, 0, 2}, {2, 0, 4}, {1, 2, 4}, {0, 3, 4}, {3, 1, 4}}};
  ASSERT_TRUE(boundary_edges(body).empty());
  ASSERT_FALSE(collinear(end, Vec3::Zero(), middle()));
  const double volume = 40.5;
  const double area = 27.0 * std::sqrt(2.0) + 40.5 + 13.5 * std::sqrt(3.0);
  expect_stays_inside(body, {2.87, 2.87, 1.19}, 3.0 * volume / area);
}

// The centre is inside by less than counts.
TEST(BodyPairs, ACentreNextToADiscIsNoInnerBall) {
  for (const double at : {-1e-3, -5.0}) {
    TriangleMesh half = test::inside_out(cup(20.0, 90.0, 100));
    const std::vector<Edge> rim = boundary_edges(half);
    half.vertices.emplace_back(0, 0, 0);
    for (const auto& [a, b] : rim)
      half.faces.push_back({b, a, static_cast<VertexIndex>(half.vertices.size() - 1)});
    half = test::moved(half, {0, 0, at});
    for (const double z : {at + 4.0, at - 4.0}) {
      const BallSocketPair main{half, cup(40.0, 60.0, 20)};
      BodyPairs pairs(main, {{}, {speck({0.0, 0.0, z})}});
      pairs.find_inner_balls(main);
      EXPECT_EQ(pairs.overlap({.turn = 1e-6, .shift_mm = 2.0}), z > at) << at;
      EXPECT_FALSE(pairs.overlap({.turn = 1e-6, .shift_mm = 4.5}));
      EXPECT_EQ(pairs.overlap({.turn = 3.0}), z > at && at < -1.0) << "in the ball about the centre";
    }
  }
}

// A plate that is thinner than a thousandth of its size has points of its surface, and may be inside too.
TEST(BodyPairs, AThinPlateIsInsideABodyWithItsPoints) {
  TriangleMesh plate = octahedron(1.0);
  for (Vec3& x : plate.vertices) x = kFar + Vec3(4.0 * x.x(), 4.0 * x.y(), 0.0045 * x.z());
  const BodyPairs within = with_inner_balls(plate, sphere_at(8.0, 1, kFar));
  EXPECT_TRUE(within.overlap({.turn = 1e-6, .shift_mm = 1.0}));
  EXPECT_FALSE(within.overlap({.turn = 1e-6, .shift_mm = 9.0}));
  const BodyPairs above = with_inner_balls(plate, sphere_at(2.0, 2, kFar + Vec3(0, 0, 5)));
  EXPECT_FALSE(above.overlap({.turn = 1e-6, .gap_mm = 2.9}));
  EXPECT_TRUE(above.overlap({.turn = 1e-6, .gap_mm = 3.8}));
}

// A shaft of 5 mm that is cut at z = 0, its last faces as low as a thousandth of it: a speck on its axis is
// inside by its distance from the cut or the wall.
TEST(BodyPairs, AShaftIsInsideUpToWhereItIsCut) {
  TriangleMesh shaft;
  constexpr VertexIndex kSides = 12;
  constexpr std::array<double, 5> kRings{0.0, -0.02, -3.0, -10.0, -50.0};
  for (const double z : kRings) {
    for (VertexIndex k = 0; k < kSides; ++k) {
      const double at = 2.0 * kPi * k / kSides;
      shaft.vertices.push_back(kFar + Vec3(5.0 * std::cos(at), 5.0 * std::sin(at), z));
    }
  }
  shaft.vertices.push_back(kFar + Vec3(0, 0, -50));
  for (VertexIndex k = 0; k < kSides; ++k) {
    const VertexIndex l = (k + 1) % kSides;
    for (VertexIndex ring = 0; ring < 4 * kSides; ring += kSides) {
      shaft.faces.push_back({ring + k, ring + kSides + k, ring + kSides + l});
      shaft.faces.push_back({ring + k, ring + kSides + l, ring + l});
    }
    shaft.faces.push_back({4 * kSides + k, 5 * kSides, 4 * kSides + l});
  }
  ASSERT_EQ(boundary_edges(shaft).size(), kSides);
  expect_stays_inside(shaft, kFar + Vec3(0, 0, -7.7), 5.0 * std::cos(kPi / kSides), 0.2);
  expect_stays_inside(shaft, kFar + Vec3(0, 0, -2), 2.0, 0.2);
  expect_stays_inside(shaft, kFar + Vec3(0, 0, 1), 0.0);
}

// The rays that tell what is inside, as limits/body_pairs.cpp casts them from x through a body.
std::vector<Vec3> ends_of_rays(const TriangleMesh& body, const Vec3& x) {
  constexpr int kRays = 16;
  const SweptParts parts(turn_faces(body));
  const SweptParts::Node& all = parts.nodes()[0];
  const double away = (x - all.centre).norm();
  std::vector<Vec3> ends;
  for (int k = 0; k < kRays; ++k) {
    const double z = 0.9973 - 2.0 * (k + 0.5) / kRays * 0.9973;
    const double azimuth = 2.39996 * k + 0.7;
    const double rho = std::sqrt(1.0 - z * z);
    ends.push_back(x + 2.0 * (away + all.radius) * Vec3(rho * std::cos(azimuth), rho * std::sin(azimuth), z));
  }
  return ends;
}

// A closed socket round the centre, and in it pieces of bone with an edge, or a corner, exactly on rays.
// These do not count: where one is there is another, and if all meet one nothing is known.
TEST(BodyPairs, RaysThroughEdgesAreNotCounted) {
  const TriangleMesh room = octahedron(32.0);
  const auto told = [&](const TriangleMesh& socket, const Vec3& x) {
    const BodyPairs pairs({octahedron(1.0), socket}, {});
    return pairs.is_inside_by({{}, true, x}, {}, 0.0);
  };
  const Vec3 end = ends_of_rays(room, Vec3::Zero())[0];
  const Vec3 p = end / 4.0;
  const Vec3 aside = p.unitOrthogonal();
  const Vec3 over = p.cross(aside);
  // The ray of the centre passes a corner, or the middle of the side between the first two corners.
  const std::vector<TriangleMesh> pieces{
      {{p, p + aside, p + aside + 0.1 * over, p + 1.5 * aside + 0.2 * p},
       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}},
      {{p, p + aside, p + aside + 0.1 * over, p + 1.5 * aside + 0.2 * p},
       {{2, 1, 0}, {1, 3, 0}, {3, 2, 0}, {1, 2, 3}}},
      {{{p.x(), p.y(), 0.0}, {0.0, 0.0, p.z()}, p + 0.2 * over, p - 0.2 * over},
       {{1, 2, 0}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}}};
  for (const TriangleMesh& piece : pieces) {
    ASSERT_TRUE(boundary_edges(piece).empty());
    const TriangleMesh socket = test::joined(room, piece);
    ASSERT_EQ(ends_of_rays(socket, Vec3::Zero())[0], end);
    EXPECT_EQ(verdict(BodyPairs({octahedron(1.0), socket}, {})).contact, Contact::no);
    EXPECT_FALSE(told(socket, {0.3, 0.1, 0.2}));
    EXPECT_TRUE(told(socket, {30.0, 30.0, 2.0}));
  }
  // Every ray from x passes an edge along +z: of the hollow, which is not inside, that is not known either.
  const Vec3 x(0.0, 0.0, 3.0);
  TriangleMesh socket = room;
  for (const Vec3& to : ends_of_rays(room, x)) {
    const Vec3 on = to / 16.0;
    const double z = x.z() + (to.z() - x.z()) / 16.0;
    const Vec3 out = 0.05 * Vec3(on.x(), on.y(), 0.0);
    const Vec3 across(-out.y(), out.x(), 0.0);
    const TriangleMesh piece{{{on.x(), on.y(), z - 0.1},
                              {on.x(), on.y(), z + 0.1},
                              Vec3(on.x(), on.y(), z) + out + across,
                              Vec3(on.x(), on.y(), z) + out - across},
                             {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 2}}};
    socket = test::joined(socket, piece);
  }
  ASSERT_EQ(ends_of_rays(socket, x), ends_of_rays(room, x));
  EXPECT_FALSE(told(socket, x));
  EXPECT_TRUE(told(room, {30.0, 30.0, 2.0}));
}

// Two faces across +z, 3 mm apart, whose middles are on it: no turn of a few degrees lets the gap or a shift
// be much less than that before they may meet.
TEST(NearBodies, FacesAboveEachOtherAreApartUntilTheyAreNear) {
  const auto face_at = [](double z) { return SweptParts({turn_face({3, 0, z}, {-1, 2, z}, {-2, -2, z})}); };
  const SweptParts ball = face_at(10.0);
  for (const double z : {13.0, 7.0}) {
    const SweptParts socket = face_at(z);
    for (const double turn : {0.0, 0.05}) {
      const double nearer = std::abs(z - 10.0) - (std::hypot(10.0, 3.0) * turn);  // at least as far as that
      for (const auto& [shift, gap] :
           {std::pair{0.99 * nearer, 0.0}, {0.0, 0.99 * nearer}, {0.5 * nearer, 0.49 * nearer}}) {
        const NearPoses poses{.turn = turn, .shift_mm = shift};
        EXPECT_FALSE(NearBodies(poses, gap).may_meet({ball, socket, {}, {{0, 0}}})) << z;
        EXPECT_FALSE(NearBodies(poses, gap).may_meet({socket, ball, {}, {{0, 0}}})) << z;
      }
      const NearPoses poses{.turn = turn, .shift_mm = 3.01};
      EXPECT_TRUE(NearBodies(poses, 0.0).may_meet({ball, socket, {}, {{0, 0}}})) << z;
      EXPECT_TRUE(NearBodies({.turn = turn}, 3.01).may_meet({ball, socket, {}, {{0, 0}}})) << z;
    }
  }
}

// The middle of the ball's face is the centre, so that no direction leads out of it.
TEST(NearBodies, AFaceRoundTheCentreIsApartUntilItIsNear) {
  const SweptParts ball({turn_face({3, 0, 0}, {-1, 2, 0}, {-2, -2, 0})});
  const SweptParts socket({turn_face({30, 0, 2}, {-10, 20, 2}, {-20, -20, 2})});
  for (const double turn : {0.0, 0.05, 0.5}) {
    const double nearer = 2.0 - 3.0 * std::sin(turn);  // of the farthest corner
    EXPECT_FALSE(NearBodies({.turn = turn}, 0.99 * nearer).may_meet({ball, socket, {}, {{0, 0}}})) << turn;
    EXPECT_TRUE(NearBodies({.turn = turn}, 2.01).may_meet({ball, socket, {}, {{0, 0}}})) << turn;
  }
}

// A turn by 18 degrees puts a corner of the ball's face on +z, 9.49 mm from the centre, beyond a socket
// at 9.3.
TEST(NearBodies, ACornerThatTurnsTowardsAPlaneMayMeetIt) {
  const SweptParts ball({turn_face({3, 0, 9}, {-2, 2, 9}, {-2, -2, 9})});
  const SweptParts socket({turn_face({-9, -9, 9.3}, {9, -9, 9.3}, {0, 9, 9.3})});
  EXPECT_FALSE(NearBodies({.turn = 0.02}, 0.0).may_meet({ball, socket, {}, {{0, 0}}}));
  for (const double turn : {0.33, 0.6, 0.9, 1.2, 1.5}) {
    EXPECT_TRUE(NearBodies({.turn = turn}, 0.0).may_meet({ball, socket, {}, {{0, 0}}})) << turn;
    EXPECT_TRUE(NearBodies({.turn = turn}, 0.0).may_meet({socket, ball, {}, {{0, 0}}})) << turn;
  }
}

}  // namespace
}  // namespace impinge
