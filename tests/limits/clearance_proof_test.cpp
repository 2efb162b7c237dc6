// SPDX-License-Identifier: GPL-3.0-or-later
// What a proof says of a pose, held against all pairs of faces, by exact signs, and against the solid angle
// for what is inside; the text is checked by its own checker in e2e.certificate.
#include "limits/clearance_proof.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/meeting_faces.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/poses.hpp"
#include "support/soup.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

using Says = ClearanceProof::Says;

const BallSocketPair& hip() {
  static const BallSocketPair pair = [] {
    const Hip made = make_hip(hip_preset("cam"), 600);
    return BallSocketPair{made.ball, made.socket};
  }();
  return pair;
}

ClearanceProof proof_of(const BallSocketPair& pair, const Pose& pose, const Vec3& centre = Vec3::Zero()) {
  return prove_pose({pair, BodyPairs(pair, {}), centre}, pose);
}

// Rotations and shifts as a proof has rounded them.
Pose rounded(const ClearanceProof& proof) {
  return {rotation_of(proof.outer) * rotation_of(proof.inner), proof.shift};
}

bool boxes_apart(const Triangle& a, const Triangle& b) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto [a_low, a_high] = std::minmax({a[0][k], a[1][k], a[2][k]});
    const auto [b_low, b_high] = std::minmax({b[0][k], b[1][k], b[2][k]});
    if (a_low > b_high || b_low > a_high) return true;
  }
  return false;
}

bool surfaces_meet(const BallSocketPair& pair, const Pose& pose) {
  const TriangleMesh ball = test::ball_in_socket_frame(pair.ball, pose);
  return std::ranges::any_of(ball.faces, [&](const Face& f) {
    const Triangle a = corners_of(ball, f);
    return std::ranges::any_of(pair.socket.faces, [&](const Face& g) {
      const Triangle b = corners_of(pair.socket, g);
      return !boxes_apart(a, b) && faces_meet(a, b);
    });
  });
}

// How often a closed mesh goes round a point (van Oosterom and Strackee 1983), rounded.
long winding(const TriangleMesh& mesh, const Vec3& x) {
  double sum = 0.0;
  for (const Face& face : mesh.faces) {
    const auto [p, q, r] = corners_of(mesh, face);
    const Vec3 a = p - x;
    const Vec3 b = q - x;
    const Vec3 c = r - x;
    sum += std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                             b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return std::lround(sum / (2.0 * kPi));
}

TEST(TheoremCertificate, SaysOfRandomPosesWhatAllPairsOfFacesSay) {
  std::map<Says, int> said;
  for (const double shift : {0.0, 5.0}) {
    for (const Pose& pose : test::random_poses(60, 1.8, shift, 5)) {
      const ClearanceProof proof = proof_of(hip(), pose);
      ++said[proof.says];
      EXPECT_LT(proof.rounded_deg, 1e-6);
      EXPECT_EQ(proof.cuts.empty(), proof.says != Says::clear);
      if (proof.says != Says::open) {
        EXPECT_EQ(proof.says == Says::crossing, surfaces_meet(hip(), rounded(proof)));
      }
    }
  }
  EXPECT_GT(said[Says::clear], 25);
  EXPECT_GT(said[Says::crossing], 25);
  EXPECT_LT(said[Says::open], 3);
  EXPECT_EQ(said[Says::inside], 0);  // the socket is open, and the ball outside of it has no part
}

TEST(ClearanceProof, NamesTwoFacesThatCross) {
  std::size_t crossings = 0;
  for (const Pose& pose : test::random_poses(60, 1.6, 3.0, 9)) {
    const ClearanceProof proof = proof_of(hip(), pose);
    if (proof.says != Says::crossing) continue;
    const TriangleMesh ball = test::ball_in_socket_frame(hip().ball, rounded(proof));
    EXPECT_TRUE(faces_meet(corners_of(ball, ball.faces.at(proof.faces[0])),
                           corners_of(hip().socket, hip().socket.faces.at(proof.faces[1]))));
    ++crossings;
  }
  EXPECT_GT(crossings, 10);
}

// Large triangles through each other's boxes: each pair that is apart has a plane.
TEST(TheoremCertificate, IsFoundForEverySoupThatIsClear) {
  std::map<Says, int> said;
  for (unsigned seed = 0; seed < 300; ++seed) {
    TriangleMesh ball = test::soup(3, seed);
    for (Vec3& x : ball.vertices) x *= 0.4;
    const BallSocketPair pair{ball, test::soup(3, seed + 1000)};
    const ClearanceProof proof = proof_of(pair, Pose{});
    ++said[proof.says];
    if (proof.says != Says::open) {
      EXPECT_EQ(proof.says == Says::crossing, surfaces_meet(pair, Pose{})) << seed;
    }
  }
  EXPECT_GT(said[Says::clear], 30);
  EXPECT_GT(said[Says::crossing], 100);
  EXPECT_LT(said[Says::open], 3);
}

// Two spheres beside each other: what is proven from which gap on.
TEST(ClearanceProof, NeedsAClearance) {
  const auto said = [](double gap, const Vec3& centre) {
    const BallSocketPair pair{sphere(20.0, 500, Vec3(0, 0, 20)), sphere(20.0, 500, Vec3(0, 0, -20.0 - gap))};
    return proof_of(pair, Pose{}, centre).says;
  };
  const Vec3 far(2e5, 0.0, 0.0);  // where reading may round by 0.08 mm
  EXPECT_EQ(said(0.0, Vec3::Zero()), Says::open);
  EXPECT_EQ(said(1e-5, Vec3::Zero()), Says::open);  // reading may have closed it
  EXPECT_EQ(said(0.05, Vec3::Zero()), Says::clear);
  EXPECT_EQ(said(-0.5, Vec3::Zero()), Says::crossing);
  EXPECT_EQ(said(0.05, far), Says::open);
  EXPECT_EQ(said(0.5, far), Says::clear);
}

// What a proof and a pose say of one body in another, and the limit of a turn by which nothing moves.
void expect_inside(const BallSocketPair& pair, Contact contact, Says says, const Pose& pose = {}) {
  const BodyPairs bodies(pair, {});
  const BodyPairs::Verdict found = bodies.verdict(pose);
  EXPECT_EQ(found.contact, contact);
  EXPECT_EQ(found.rule, contact == Contact::yes ? ContactRule::inside : found.rule);
  EXPECT_EQ(prove_pose({pair, bodies, Vec3::Zero()}, pose).says, says);
  const LimitState state =
      TurnLimits(pair).first_contact({.outer = pose.rotation, .axis = Vec3::UnitZ()}, 0.5).state;
  if (!pose.translation.isZero()) return;
  EXPECT_EQ(state, contact == Contact::yes  ? LimitState::blocked
                   : contact == Contact::no ? LimitState::free
                                            : LimitState::unknown);
  EXPECT_EQ(prove_turn({pair, bodies, Vec3::Zero()}, {.axis = Vec3::UnitZ()}, 0.5).says, says);
}

// One rule of inside for poses, limits and proofs: between the layers of a shell and not in its hollow; of a
// closed socket round the centre, outside of it; in a body without an opening alone where it is proven.
TEST(ClearanceProof, SaysWhatIsInsideAsPosesAndLimitsDo) {
  const TriangleMesh small = icosphere(5.0, 2);
  const TriangleMesh large = icosphere(24.0, 3);
  const TriangleMesh shell = test::joined(large, icosphere(20.0, 3));
  const auto at = [&](double x, double radius = 1.0) { return sphere(radius, 200, Vec3(x, 2.0, 1.0)); };
  expect_inside({small, large}, Contact::no, Says::clear);
  expect_inside({large, at(10.0, 3.0)}, Contact::yes, Says::inside);
  expect_inside({small, large}, Contact::yes, Says::inside, {Eigen::Matrix3d::Identity(), Vec3(60, 2, 3)});
  expect_inside({shell, at(10.0, 3.0)}, Contact::no, Says::clear);
  expect_inside({small, shell}, Contact::no, Says::clear);
  expect_inside({shell, at(22.0, 0.5)}, Contact::yes, Says::inside);
  expect_inside({at(22.0, 0.5), shell}, Contact::yes, Says::inside);
  expect_inside({shell, at(30.0)}, Contact::no, Says::clear);
  expect_inside({test::joined(shell, at(0.0)), at(0.0, 0.3)}, Contact::yes, Says::inside);
  expect_inside({test::joined(at(0.0), at(60.0)), at(0.0, 4.0)}, Contact::yes, Says::inside);
  expect_inside({test::joined(at(60.0), at(40.0)), at(40.0, 3.0)}, Contact::yes, Says::inside);
  TriangleMesh open = large;
  open.faces.pop_back();
  expect_inside({open, at(10.0, 3.0)}, Contact::yes, Says::unknown);
  expect_inside({open, at(40.0)}, Contact::no, Says::clear);
  const auto [a, b, c] = corners_of(large, large.faces.back());
  expect_inside({open, sphere(0.05, 200, (a + b + c) / 3.0)}, Contact::yes, Says::unknown);
  EXPECT_FALSE(proof_of({open, at(40.0)}, Pose{}).closed);
  EXPECT_TRUE(proof_of({large, at(40.0)}, Pose{}).closed);
  // Files are bodies of their own: in what two of them have in common is inside.
  const BallSocketPair main{small, at(60.0)};
  const BoneParts parts{{}, {at(-40.0, 4.0), at(-42.0, 4.0)}};
  const BallSocketPair all{at(-41.0, 0.5),
                           test::joined(main.socket, test::joined(parts.socket[0], parts.socket[1]))};
  EXPECT_EQ(prove_pose({all, BodyPairs({all.ball, main.socket}, parts), Vec3::Zero()}, {}).says,
            Says::inside);
}

// In the hollow of a sheet that faces away from it, nothing is known.
TEST(ClearanceProof, IsUnknownWhereAnOpeningHidesWhatIsInside) {
  const TriangleMesh speck = test::moved(octahedron(0.1), Vec3(60.3, 0.2, 7.0));
  const TriangleMesh sheet = test::moved(test::inside_out(cup(10.0, 60.0, 400)), Vec3(60, 0, 0));
  const BallSocketPair main{octahedron(5.0), cup(8.0, 60.0, 100)};
  const BodyPairs bodies(main, {{speck}, {sheet}});
  const BallSocketPair all{test::joined(main.ball, speck), test::joined(main.socket, sheet)};
  EXPECT_EQ(bodies.verdict({}).contact, Contact::unknown);
  EXPECT_EQ(prove_pose({all, bodies, Vec3::Zero()}, {}).says, Says::unknown);
}

// A head behind a socket that is a sheet overlaps it by radii alone, which hides no part that is inside other
// bone, or may be, nor a socket inside a closed head.
TEST(ClearanceProof, LooksAtPartsWhereRadiiOverlap) {
  const Pose behind{Eigen::Matrix3d::Identity(), Vec3(0, 0, 20)};
  const TriangleMesh speck = test::moved(octahedron(0.1), Vec3(60.3, 0.2, 7.0) - behind.translation);
  const TriangleMesh sheet = test::moved(test::inside_out(cup(10.0, 60.0, 400)), Vec3(60, 0, 0));
  const auto said = [&](const TriangleMesh& head, const TriangleMesh& part, const Pose& pose) {
    const BallSocketPair main{head, cup(8.0, 60.0, 100)};
    const BodyPairs bodies(main, {{speck}, {part}});
    EXPECT_EQ(bodies.verdict(pose).contact, Contact::yes);
    const BallSocketPair all{test::joined(main.ball, speck), test::joined(main.socket, part)};
    return prove_pose({all, bodies, Vec3::Zero()}, pose).says;
  };
  EXPECT_EQ(said(octahedron(5.0), sphere(2.0, 200, Vec3(90, 0, 0)), behind), Says::clear);
  EXPECT_EQ(said(octahedron(5.0), sheet, behind), Says::unknown);
  EXPECT_EQ(said(octahedron(5.0), sphere(10.0, 200, Vec3(60, 0, 0)), behind), Says::inside);
  EXPECT_EQ(said(icosphere(20.0, 2), sphere(2.0, 200, Vec3(90, 0, 0)), {}), Says::inside);
}

TEST(ClearanceProof, AgreesWithTheSolidAngle) {
  test::Dice random(4);
  const TriangleMesh femur = hip().ball;
  std::map<Says, int> said;
  for (int k = 0; k < 300; ++k) {
    const Vec3 at(random.between(-60, 60), random.between(-60, 60), random.between(-90, 40));
    const TriangleMesh screw = sphere(0.5, 8, at);
    const ClearanceProof proof = proof_of({femur, screw}, Pose{});
    ++said[proof.says];
    if (proof.says == Says::clear || proof.says == Says::inside) {
      EXPECT_EQ(proof.says == Says::inside, winding(femur, at) != 0) << at.transpose();
    }
  }
  EXPECT_GT(said[Says::clear], 30);
  EXPECT_GT(said[Says::inside], 8);
}

// Where internal rotation at 60 degrees of flexion begins to meet, to a thousandth of a degree.
double first_meeting(const JointTurn& turn) {
  const auto meets = [&](double degrees) {
    const Eigen::AngleAxisd grown(degrees * kDegree, turn.axis);
    return surfaces_meet(hip(), {turn.outer * grown.toRotationMatrix() * turn.inner, Vec3::Zero()});
  };
  double low = 0.0;
  while (!meets(low + 0.25)) low += 0.25;
  double high = low + 0.25;
  while (high - low > 1e-3) (meets(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return low;
}

TEST(TheoremCertificate, OfATurnHoldsUpToContactAndNotBeyond) {
  const JointTurn turn = joint_turn({.flexion = 60.0}, motion_name("internal_rotation"), Side::right);
  const double limit = first_meeting(turn);
  ASSERT_GT(limit, 5.0);
  const BodyPairs bodies(hip(), {});
  const ClearanceProof proof = prove_turn({hip(), bodies, Vec3::Zero()}, turn, limit - 0.05);
  EXPECT_EQ(proof.says, Says::clear);
  EXPECT_NEAR(degrees_of(proof.last), limit - 0.05, 1e-6);
  EXPECT_LT(proof.rounded_deg, 1e-6);
  for (const double beyond : {0.1, 20.0})
    EXPECT_EQ(prove_turn({hip(), bodies, Vec3::Zero()}, turn, limit + beyond).says, Says::open);
}

// A part of a sphere turns once round within a ring of a larger one, which no plane separates for long.
TEST(ClearanceProof, OfATurnGoesAllTheWayRound) {
  const auto part_of = [](TriangleMesh mesh, double least_x) {
    std::erase_if(mesh.faces, [&](const Face& f) { return mesh.vertices[f[0]].x() < least_x; });
    return mesh;
  };
  const TriangleMesh ball = part_of(icosphere(20.0, 3), 5.0);
  const auto says = [&](double radius, double degrees) {
    const BallSocketPair pair{ball, part_of(icosphere(radius, 3), -5.0)};
    return prove_turn({pair, BodyPairs(pair, {}), Vec3::Zero()}, {.axis = Vec3::UnitZ()}, degrees).says;
  };
  EXPECT_EQ(says(20.3, 359.0), Says::clear);
  EXPECT_EQ(says(20.0, 359.0), Says::open);
}

// Tetrahedra beside each other, of which the ball's turns about one axis after the other.
TEST(ClearanceProof, OfATurnNamesItsAxis) {
  const TriangleMesh ball{{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}},
                          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  TriangleMesh socket = ball;
  for (Vec3& x : socket.vertices) x += Vec3(20, 20, 20);
  const BallSocketPair pair{ball, socket};
  const BodyPairs bodies(pair, {});
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {1, -1}) {
      const ClearanceProof proof =
          prove_turn({pair, bodies, Vec3::Zero()}, {.axis = sign * Vec3::Unit(k)}, 90.0);
      EXPECT_EQ(proof.says, Says::clear);
      for (int l = 0; l < 3; ++l) EXPECT_EQ(proof.axis[static_cast<std::size_t>(l)], l == k ? sign : 0);
    }
  }
}

// Line by line as experiments/certificate_format.md has it.
TEST(ClearanceProof, IsWrittenAsItsFormatSays) {
  ClearanceProof proof;
  proof.says = Says::clear;
  proof.centre = Vec3(1.5, -2.0, 0.25);
  proof.axis = {0, 0, -1};
  proof.inner = {3, 0, 0, 4};
  proof.last = {5, 1};
  proof.files = {2, 1};
  proof.cuts = {{ClearCut::Kind::turn, {10, 1, 0}, 0},
                {ClearCut::Kind::plane, {1, -2, 3}, -1024},
                {},
                {},
                {ClearCut::Kind::sphere, {}, 20480},
                {},
                {}};
  const std::string start =
      "files 2 1\ncentre 1.500000000 -2.000000000 0.250000000\nshift 0.000000000 0.000000000 0.000000000\n"
      "outer 1 0 0 0\naxis 0 0 -1\ninner 3 0 0 4\nlast 5 1\nunit 1024\n";
  EXPECT_EQ(proof_text(proof), "impinge certificate 2 clear\n" + start +
                                   "turn 10 1\nplane 1 -2 3 -1024\n-\n-\nsphere 20480\n-\n-\nend\n");
  proof.cuts.clear();
  proof.says = Says::inside;
  EXPECT_EQ(proof_text(proof), "impinge certificate 2 contact\n" + start + "inside\nend\n");
  proof.says = Says::crossing;
  proof.faces = {7, 3};
  EXPECT_EQ(proof_text(proof), "impinge certificate 2 contact\n" + start + "cross 7 3\nend\n");
}

}  // namespace
}  // namespace impinge
