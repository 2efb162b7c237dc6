// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of bones against CGAL's exact intersection of all faces, in random poses; insides by the solid
// angle that a closed mesh fills, and of meshes with openings by what they were made from.
#include "limits/body_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <CGAL/intersections.h>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/bodies.hpp"
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
  const Vec3 across = 0.1 * out.unitOrthogonal();
  const Vec3 aside = out.cross(across);
  bone.faces.erase(bone.faces.begin());
  for (const double depth : {4.0, -1.0, -20.0}) {
    for (std::size_t first = 0; first < 4; ++first) {
      TriangleMesh needle{
          {middle - depth * out, middle + (8.0 - depth) * out + across,
           middle + (8.0 - depth) * out - across + aside, middle + (8.0 - depth) * out - across - aside},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
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
    EXPECT_EQ(found.touch, pairs.meet(pose));
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

}  // namespace
}  // namespace impinge
