// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: of a bone that reaches far beyond the joint the faces of the joint become the main surface, each
// face of the bone is in the joint once and where it was, the two parts close again, and what is cut already
// stays as it is. The bones here are made of bodies whose faces are known. Real bones:
// tests/command/real_bones_test.cpp.
#include "hip/whole_bone.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/joint.hpp"
#include "mesh/bodies.hpp"
#include "mesh/validation.hpp"
#include "support/joined.hpp"
#include "support/thrown.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

const Vec3 kScanned(-86.0, 20.0, 580.0);  // of the centre, in the frame of the files
constexpr double kHead = 24.0;

using FacePlaces = std::array<std::array<double, 3>, 3>;

// Where the corners of the faces are, each from its least corner on; sorted.
std::multiset<FacePlaces> faces_of(const TriangleMesh& mesh) {
  std::multiset<FacePlaces> faces;
  for (const Face& face : mesh.faces) {
    FacePlaces at{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& x = mesh.vertices[face[k]];
      at[k] = {x.x(), x.y(), x.z()};
    }
    std::rotate(at.begin(), std::ranges::min_element(at), at.end());
    faces.insert(at);
  }
  return faces;
}

// Edges by the places of their ends: each is passed as often one way as the other.
bool closes(const std::multiset<FacePlaces>& faces) {
  std::multiset<std::array<std::array<double, 3>, 2>> open;
  for (const FacePlaces& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto back = open.find({face[(k + 1) % 3], face[k]});
      if (back != open.end()) {
        open.erase(back);
      } else {
        open.insert({face[k], face[(k + 1) % 3]});
      }
    }
  }
  return open.empty();
}

// A head with its neck and a shaft of 200 mm.
TriangleMesh femur() { return test::moved(make_hip({.shaft_length = 200.0}, 6000).ball, kScanned); }

// A wall about the centre with an inner side of radius 25 and an outer one, and a wing 120 mm above it that
// looks to the centre, too.
TriangleMesh pelvis() {
  const TriangleMesh inner = cup(25.0, 85.0, 1500);
  const TriangleMesh outer = test::inside_out(cup(29.0, 85.0, 1000));
  const TriangleMesh wing = test::moved(octahedron(40.0), Vec3(0.0, 0.0, 160.0));
  return test::moved(test::joined(test::joined(inner, outer), wing), kScanned);
}

JointInput whole_joint(TriangleMesh ball, TriangleMesh socket) {
  JointInput input;
  input.ball = {"scans/femur.ply", std::move(ball)};
  input.socket = {"scans/pelvis.ply", std::move(socket)};
  return input;
}

TEST(WholeBone, HeadAndNeckAreTheBallAndTheInnerWallIsTheSocket) {
  const Joint joint = assemble_joint(whole_joint(femur(), pelvis()));
  ASSERT_LT((joint.centre - kScanned).norm(), 0.01);
  const TriangleMesh ball = main_surface(joint.ball.mesh, joint.ball.parts);
  EXPECT_EQ(joint.ball.taken.value().faces, ball.faces.size());
  EXPECT_EQ(joint.ball.taken.value().of, femur().faces.size());
  EXPECT_NEAR(joint.ball.taken.value().within_mm, 1.5 * kHead, 0.01);
  const auto near = [](const TriangleMesh& mesh, const Face& face) {
    return (corner(mesh, face, 0) + corner(mesh, face, 1) + corner(mesh, face, 2)).norm() / 3.0 < 1.5 * kHead;
  };
  const TriangleMesh rest = part_surface(joint.ball.mesh, joint.ball.parts, 0);
  for (const Face& face : ball.faces) EXPECT_TRUE(near(ball, face));
  for (const Face& face : rest.faces) EXPECT_FALSE(near(rest, face));
  const TriangleMesh socket = main_surface(joint.socket.mesh, joint.socket.parts);
  EXPECT_EQ(socket.faces.size(), 1500U) << "all of the inner side, none of the outer one or the wing";
  for (const Vec3& x : socket.vertices) EXPECT_NEAR(x.norm(), 25.0, 0.02);
  ASSERT_EQ(joint.ball.parts.size() + joint.socket.parts.size(), 2U);
  EXPECT_EQ(joint.ball.parts[0].name, "rest of femur");
  EXPECT_EQ(joint.socket.parts[0].name, "rest of pelvis");
  EXPECT_TRUE(joint.ball.parts[0].of_main && joint.socket.parts[0].of_main);
}

TEST(WholeBone, EachFaceIsThereOnceAndTheBoneClosesAgain) {
  const Joint joint = assemble_joint(whole_joint(femur(), pelvis()));
  const auto given = faces_of(relative_to(femur(), joint.centre));
  ASSERT_TRUE(closes(given));
  EXPECT_EQ(faces_of(joint.ball.mesh), given);
  EXPECT_EQ(faces_of(whole_main(joint.ball.mesh, joint.ball.parts)), given);
  EXPECT_EQ(whole_main(joint.ball.mesh, joint.ball.parts).vertices.size(), femur().vertices.size());
  EXPECT_FALSE(closes(faces_of(main_surface(joint.ball.mesh, joint.ball.parts))));
  EXPECT_EQ(faces_of(joint.socket.mesh), faces_of(relative_to(pelvis(), joint.centre)));
  EXPECT_TRUE(joint.ball.validation.closed()) << "the bone that was given is, whatever was cut";
  EXPECT_EQ(joint.ball.validation.vertices, femur().vertices.size());
  EXPECT_EQ(joint.socket.validation.vertices, pelvis().vertices.size());
}

TEST(WholeBone, IsTheSameInsideOutAndWithTheCentreGiven) {
  const Joint usual = assemble_joint(whole_joint(femur(), pelvis()));
  JointInput turned = whole_joint(test::inside_out(femur()), test::inside_out(pelvis()));
  turned.centre = usual.centre;
  const Joint joint = assemble_joint(std::move(turned));
  EXPECT_EQ(joint.ball.taken.value().faces, usual.ball.taken.value().faces);
  EXPECT_EQ(joint.socket.taken.value().faces, usual.socket.taken.value().faces);
}

// What a tool cut off is of the bone again; what lies beside it is not.
TEST(WholeBone, PartsThatWereCutFromItGoOnFromIt) {
  const TriangleMesh bone = femur();
  TriangleMesh head = bone;
  TriangleMesh shaft = bone;
  const auto beyond = [&](const Face& face) {
    return (corner(bone, face, 0) - kScanned).norm() > 1.45 * kHead;
  };
  std::erase_if(head.faces, beyond);
  std::erase_if(shaft.faces, std::not_fn(beyond));
  JointInput input = whole_joint(head, pelvis());
  append_part(input.ball.mesh, input.ball.parts, "shaft", shaft);
  append_part(input.ball.mesh, input.ball.parts, "screw", sphere(2.0, 100, kScanned));
  const Joint joint = assemble_joint(std::move(input));
  ASSERT_FALSE(joint.ball.taken);
  EXPECT_TRUE(joint.ball.parts[0].of_main);
  EXPECT_FALSE(joint.ball.parts[1].of_main);
  EXPECT_TRUE(closes(faces_of(whole_main(joint.ball.mesh, joint.ball.parts))));
}

TEST(WholeBone, PartsThatAreGivenStayBehindTheRest) {
  JointInput input = whole_joint(femur(), pelvis());
  const TriangleMesh spine = sphere(5.0, 100, kScanned + Vec3(40.0, 40.0, 0.0));
  append_part(input.socket.mesh, input.socket.parts, "spine", spine);
  const Joint joint = assemble_joint(std::move(input));
  ASSERT_EQ(joint.socket.parts.size(), 2U);
  EXPECT_TRUE(joint.socket.parts[0].of_main);
  EXPECT_FALSE(joint.socket.parts[1].of_main);
  EXPECT_EQ(joint.socket.parts[1].name, "spine");
  EXPECT_EQ(faces_of(part_surface(joint.socket.mesh, joint.socket.parts, 1)),
            faces_of(relative_to(spine, joint.centre)));
  const Joint whole = with_whole_socket(joint);
  EXPECT_EQ(faces_of(main_surface(whole.socket.mesh, whole.socket.parts)),
            faces_of(relative_to(pelvis(), joint.centre)));
  ASSERT_EQ(whole.socket.parts.size(), 1U);
  EXPECT_EQ(whole.socket.parts[0].name, "spine");
  EXPECT_EQ(test::thrown<std::runtime_error>([&] { require_no_parts(joint, "this"); }),
            "this: bone beside the joint, such as spine, is not taken into account here; leave it out");
  EXPECT_NO_THROW(require_no_parts(assemble_joint(whole_joint(femur(), pelvis())), "this"));
}

TEST(WholeBone, TwoThatChangedPlacesAreRefused) {
  EXPECT_NE(test::thrown<std::exception>([] { assemble_joint(whole_joint(pelvis(), femur())); }), "");
}

TEST(WholeBone, WhatIsCutOrGeneratedStaysAsItIs) {
  for (const std::string_view name : hip_preset_names()) {
    const Hip hip = make_hip(hip_preset(name), 3000);
    const Joint joint = assemble_joint(whole_joint(hip.ball, hip.socket));
    EXPECT_FALSE(joint.ball.taken || joint.socket.taken || joint.has_parts()) << name;
    EXPECT_EQ(joint.ball.mesh.faces, hip.ball.faces);
  }
  const TriangleMesh shell =
      test::joined(cup(kHead - 2.0, 100.0, 1200), test::inside_out(cup(kHead, 100.0, 1200)));
  const Joint cartilage = assemble_joint(whole_joint(shell, cup(25.0, 85.0, 1200)));
  EXPECT_FALSE(cartilage.has_parts());
}

TEST(SocketFit, IsThatOfTheInnerWallWhereTheOuterOneIsLarger) {
  const TriangleMesh inner = cup(25.0, 85.0, 3000);
  TriangleMesh outer = test::inside_out(cup(31.0, 110.0, 3000));
  for (Vec3& x : outer.vertices) x += Vec3(0.0, 0.0, 3.0);
  SphereFit head;
  head.radius = kHead;
  const TriangleMesh walls = test::joined(inner, outer);
  ASSERT_GT(fit_ball(walls).radius, 30.0) << "this is what a fit of all faces finds";
  const SphereFit found = fit_socket(walls, head);
  EXPECT_LT(found.centre.norm(), 0.02);
  EXPECT_NEAR(found.radius, 25.0, 0.02);
  head.centre = Vec3(0.0, 0.0, 500.0);
  EXPECT_THROW(fit_socket(walls, head), std::invalid_argument);
}

// As near to the head as the inner wall of a thin one is the outer, which is what looks to the centre.
TEST(SocketFit, OfAWallInsideOutIsTheSame) {
  SphereFit head;
  head.radius = kHead;
  for (const double outside : {27.0, 40.0}) {
    const TriangleMesh wall = test::with_back(cup(25.0, 85.0, 3000), cup(outside, 85.0, 3000));
    ASSERT_GT(validate(wall).volume, 0.0);
    for (const TriangleMesh& socket : {wall, test::inside_out(wall), test::inside_out(cup(25.0, 85.0, 3000))})
      EXPECT_NEAR(fit_socket(socket, head).radius, 25.0, 0.02);
  }
}

TEST(SocketFit, OfOneThatIsTooFlatIsNone) {
  SphereFit head;
  head.radius = kHead;
  const auto behind = [](double apart) {  // a millimetre above the head, and flatter than it
    TriangleMesh flat = cup(kHead + 1.0 + apart, 25.0, 3000);
    for (Vec3& x : flat.vertices) x -= apart * Vec3::UnitZ();
    return flat;
  };
  EXPECT_NEAR(fit_socket(behind(kHead - 1.0), head).radius, 2.0 * kHead, 0.1);
  EXPECT_THROW(fit_socket(behind(kHead + 1.0), head), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
