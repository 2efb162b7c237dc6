// SPDX-License-Identifier: GPL-3.0-or-later
// What a joint says of bone beside it.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"
#include "joint/document.hpp"
#include "joint/gaps.hpp"
#include "joint/limits.hpp"
#include "joint/orient.hpp"
#include "joint/poses.hpp"
#include "joint/proof.hpp"
#include "joint/resect.hpp"
#include "joint/touch.hpp"
#include "joint/volume.hpp"
#include "mesh/bodies.hpp"
#include "mesh/edges.hpp"
#include "support/hip_with_parts.hpp"
#include "support/joined.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

Session session_of(Hip hip, const std::optional<Vec3>& centre = {}) {
  JointInput input;
  input.centre = centre;
  input.ball = {"ball", std::move(hip.ball), std::move(hip.ball_parts)};
  input.socket = {"socket", std::move(hip.socket), std::move(hip.socket_parts)};
  input.side = Side::right;
  return {assemble_joint(std::move(input)), Side::right, "RAS"};
}

bool touches(Session& session, const Motion& motion) {
  return answer(session, TouchRequest{.pose = motion}).contact.state == Contact::yes;
}

// Which part stops a motion is said, and the main surfaces give centre, dial and warnings as without parts.
TEST(Parts, AreNamedByALimit) {
  Session session = session_of(make_hip(test::hip_with_parts(), 2000));
  const Session without = session_of(make_hip({}, 2000));
  const auto parts_of = [&](double flexion, const char* motion) {
    const auto found = answer_limits(session, {.start = {.flexion = flexion}, .growing = motion});
    EXPECT_EQ(found[1].centre, "socket");
    EXPECT_EQ(found[0].ball_part, found[1].ball_part);
    EXPECT_EQ(found[0].socket_part, found[1].socket_part);
    return found[0].ball_part.value() + "/" + found[0].socket_part.value();
  };
  EXPECT_EQ(parts_of(70.0, "internal_rotation"), "neck/AIIS");
  EXPECT_EQ(parts_of(0.0, "adduction"), "neck/rim");
  const Joint& with = session.joint->joint;
  EXPECT_EQ(with.centre, without.joint->joint.centre);
  EXPECT_EQ(with.warnings, without.joint->joint.warnings);
  EXPECT_EQ(session.joint->dial.value().twelve, without.joint->dial.value().twelve);
}

// The spine is above the shadow of a shaft at 120 degrees, nowhere near it: how much of the shaft there is
// changes nothing.
TEST(Parts, StopNothingThatPassesThemAtADistance) {
  double least = 360.0;
  double most = 0.0;
  for (const double length : {15.0, 40.0}) {
    HipParameters parameters = test::hip_with_parts();
    parameters.shaft_length = length;
    Session session = session_of(make_hip(parameters, 2000));
    const double low = answer_limits(session, {.start = {}, .growing = "flexion"}).front().told.limit.low_deg;
    least = std::min(least, low);
    most = std::max(most, low);
    for (const double flexion : {120.0, low - 0.1}) {
      EXPECT_FALSE(touches(session, {.flexion = flexion})) << length << " " << flexion;
    }
  }
  EXPECT_LT(most - least, 0.5);
}

// Touch of one pose, of a list of poses and a limit say the same of the spine.
TEST(Parts, TouchInPosesBehindTheLimit) {
  Session session = session_of(make_hip(test::hip_with_parts(), 2000));
  const LimitRequest request{.start = {.flexion = 70.0}, .growing = "internal_rotation"};
  const TurnLimit limit = answer_limits(session, request).front().told.limit;
  PoseSeries series(*session.joint, {.outputs = {PosesOutput::touch}});
  for (const double beyond : {-0.01, 0.01}) {
    const Motion motion{.flexion = 70.0, .internal_rotation = limit.high_deg + beyond};
    EXPECT_EQ(touches(session, motion), beyond > 0.0);
    EXPECT_EQ(series.answer(pose_of(*session.joint, motion)).verdict->contact == Contact::yes, beyond > 0.0);
  }
}

// A volume names the part that stops a motion, and the map is smaller than without parts.
TEST(Parts, AreInVolumeAndOrientation) {
  Session session = session_of(make_hip(test::hip_with_parts(), 1000));
  Session without = session_of(make_hip({}, 1000));
  const VolumeAnswer found = answer(session, VolumeRequest{.width = 0.08});
  const VolumeAnswer alone = answer(without, VolumeRequest{.width = 0.08});
  EXPECT_LT(found.shares().high(), alone.shares().high());
  std::size_t by_spine = 0;
  for (std::size_t k = 0; k < found.motions.size(); ++k) {
    const NamedMotion& motion = named_motions()[k];
    const VolumeMotion& stop = found.motions[k];
    const LimitRequest asked{.start = motion.start, .growing = std::string(motion.growing)};
    const TurnLimit limit = answer_limits(session, asked).front().told.limit;
    EXPECT_EQ(stop.motion, motion.name);
    EXPECT_LE(stop.low_deg, limit.high_deg + 1e-6) << motion.name;
    if (stop.high_deg) {
      EXPECT_GE(*stop.high_deg, limit.low_deg - 1e-6) << motion.name << " " << limit.high_deg;
    }
    EXPECT_FALSE(alone.motions[k].socket_part);
    by_spine += stop.socket_part == "AIIS" ? 1U : 0U;
  }
  EXPECT_GE(by_spine, 1U);
  OrientRequest turned{.require = {{.flexion = 90.0, .internal_rotation = 25.0}}, .resolution_deg = 2.0};
  EXPECT_LT(answer(session, turned).area_deg2.free, answer(without, turned).area_deg2.free);
}

// Gaps are those without parts, vertices of parts have none, and distances are to the nearest bone.
TEST(Parts, LeaveGapsAsTheyAre) {
  Session session = session_of(make_hip(test::hip_with_parts(), 1000));
  Session alone = session_of(make_hip({}, 1000));
  const PosesRequest gap_and_areas{.outputs = {PosesOutput::gap, PosesOutput::areas}};
  PoseSeries series(*session.joint, gap_and_areas);
  PoseSeries series_alone(*alone.joint, gap_and_areas);
  for (const auto precision : {std::optional<double>(), std::optional<double>(2.0)}) {
    GapsRequest asked;
    asked.precision_deg = precision;
    asked.pose = {.flexion = 70.0, .internal_rotation = 20.0};
    const GapsAnswer found = answer(session, asked);
    const GapsAnswer expected = answer(alone, asked);
    bool nearer = false;
    for (const Surface of : kSurfaces) {
      const std::size_t vertices = expected.of(of).gap.size();
      ASSERT_GT(session.joint->mesh(of).vertices.size(), vertices);
      ASSERT_EQ(found.of(of).gap.size(), session.joint->mesh(of).vertices.size());
      for (std::size_t i = 0; i < found.of(of).gap.size(); ++i) {
        const double gap = i < vertices ? expected.of(of).gap[i] : kNoSurface;
        const double bound = i < vertices ? expected.of(of).bound[i] : kNoSurface;
        EXPECT_TRUE(found.of(of).gap[i] == gap || (std::isnan(found.of(of).gap[i]) && std::isnan(gap))) << i;
        EXPECT_TRUE(found.of(of).bound[i] == bound ||
                    (std::isnan(found.of(of).bound[i]) && std::isnan(bound)));
        if (i >= vertices) continue;
        EXPECT_LE(found.of(of).distance[i].lower_mm, expected.of(of).distance[i].upper_mm);
        nearer = nearer || found.of(of).distance[i].upper_mm < expected.of(of).distance[i].lower_mm;
      }
      EXPECT_EQ(found.of(of).bone.area_mm2, expected.of(of).bone.area_mm2);
      EXPECT_EQ(found.of(of).histogram.without, expected.of(of).histogram.without);
    }
    EXPECT_TRUE(nearer) << "a part is nearer to some vertex";
    EXPECT_EQ(found.smallest_gap.value().gap_mm, expected.smallest_gap.value().gap_mm);
    EXPECT_EQ(found.radial_overlap.value().surfaces_impinged,
              expected.radial_overlap.value().surfaces_impinged);
    EXPECT_FALSE(expected.nearest_part);
    // Of all vertices to all bone that they may be a part's nearest of: no pair of bodies is nearer.
    double least = HUGE_VAL;
    for (const Surface of : kSurfaces) {
      for (std::size_t i = expected.of(of).gap.size(); i < found.of(of).distance.size(); ++i)
        least = std::min(least, found.of(of).distance[i].upper_mm);
    }
    EXPECT_FALSE(found.nearest_part.value().touch.value());
    EXPECT_GT(found.nearest_part->distance_mm, 0.0);
    EXPECT_LE(found.nearest_part->distance_mm, least + 1e-9);
    asked.outputs = {Output::gaps};
    EXPECT_FALSE(answer(session, asked).nearest_part) << "nobody asked";
    const TouchRequest touch{.pose = asked.pose};
    EXPECT_EQ(answer(session, touch).smallest_gap.value().gap_mm,
              answer(alone, touch).smallest_gap.value().gap_mm);
    const Pose pose = pose_of(*session.joint, asked.pose);
    const PoseRow of_series = series.answer(pose);
    EXPECT_EQ(of_series.smallest.value().gap_mm, series_alone.answer(pose).smallest.value().gap_mm);
    EXPECT_EQ(of_series.areas.value().cartilage_ball_mm2,
              series_alone.answer(pose).areas.value().cartilage_ball_mm2);
  }
}

std::vector<Pose> many_poses(const SessionJoint& joint) {
  std::vector<Pose> poses;
  for (const double flexion : {-20.0, 0.0, 70.0, 110.0, 130.0}) {
    for (const double abduction : {0.0, 45.0}) {
      for (const double rotation : {-40.0, 0.0, 50.0, 55.0}) {
        poses.push_back(pose_of(joint, {flexion, abduction, rotation}));
        poses.push_back(pose_of(joint, {flexion, abduction, rotation}, Vec3(0.0, 0.4, -0.4)));
      }
    }
  }
  return poses;
}

// Touch decides exactly, and knows nothing of certificates.
TEST(Parts, HaveCertificatesThatAgreeWithTouch) {
  const Session session = session_of(make_hip(test::hip_with_parts(), 1000));
  PoseSeries series(*session.joint, {.outputs = {PosesOutput::touch}});
  std::map<bool, int> touched;
  for (const Pose& pose : many_poses(*session.joint)) {
    const ClearanceProof proof = answer_proof(*session.joint, pose);
    EXPECT_EQ(proof.files, (std::array<std::size_t, 2>{3, 2}));
    const BodyPairs::Verdict touch = series.answer(pose).verdict.value();
    const bool touches = touch.contact == Contact::yes && touch.rule != ContactRule::radii;
    EXPECT_EQ(touches, proof.says != ClearanceProof::Says::clear);
    ++touched[touches];
  }
  EXPECT_GT(std::min(touched[true], touched[false]), 10);
}

// The spine stops it before the rim does.
TEST(Parts, EndAMotionThatHasACertificate) {
  Session session = session_of(make_hip(test::hip_with_parts(), 2000));
  const LimitRequest request{.start = {.flexion = 70.0}, .growing = "internal_rotation"};
  const double limit = answer_limits(session, request).front().told.limit.low_deg;
  const ClearanceProof proof = answer_proof(session, request);
  EXPECT_EQ(proof.says, ClearanceProof::Says::clear);
  EXPECT_NEAR(degrees_of(proof.last), limit - kProofEndsBefore[0], 1e-6);
  const Pose beyond = pose_of(*session.joint, {70.0, 0.0, limit + 0.2});
  EXPECT_EQ(answer_proof(*session.joint, beyond).says, ClearanceProof::Says::crossing);
}

void expect_inside(Hip hip) {
  Session session = session_of(std::move(hip));
  EXPECT_EQ(answer_proof(*session.joint, {}).says, ClearanceProof::Says::inside);
  const auto motion = [&] { answer_proof(session, {.start = {}, .growing = "flexion"}); };
  EXPECT_EQ(test::thrown<std::runtime_error>(motion),
            "the motion ends within 0.01 degrees of its start; begin at another pose");
}

TEST(Parts, InsideOtherBoneTouchIt) {
  Hip shell = make_hip({}, 1000);
  append_part(shell.socket, shell.socket_parts, "shell", sphere(400.0, 100));
  expect_inside(shell);
  Hip screw = make_hip({}, 1000);
  append_part(screw.socket, screw.socket_parts, "screw", sphere(2.0, 100));
  expect_inside(screw);
}

// A screw behind the faces of a part that is a sheet: what is nearest is told, and not that it does not
// touch.
TEST(Parts, OfWhichItIsNotKnownThatTheyTouch) {
  Hip hip = make_hip({}, 1000);
  const auto far = [](TriangleMesh mesh) {
    for (Vec3& x : mesh.vertices) x += Vec3(500, 0, 0);
    return mesh;
  };
  append_part(hip.ball, hip.ball_parts, "screw", far(sphere(0.5, 100, Vec3(0, 0, 7))));
  append_part(hip.socket, hip.socket_parts, "sheet", far(test::inside_out(cup(10.0, 60.0, 400))));
  Session session = session_of(std::move(hip), std::optional(Vec3(0.0, 0.0, 0.0)));
  const TouchAnswer found = answer(session, TouchRequest{});
  EXPECT_EQ(found.contact.state, Contact::unknown);
  EXPECT_EQ(found.nearest_part.value().ball_part, "screw");
  EXPECT_EQ(found.nearest_part->socket_part, "sheet");
  EXPECT_FALSE(found.nearest_part->touch);
  EXPECT_EQ(json_of(found)["nearest_part"]["touch"], nullptr);
  EXPECT_NE(describe(found.nearest_part).find("whether one is inside is not known"), std::string::npos);
}

// The wall about a head, closed, as two files: its inner side, and all else. Neither holds the head.
TEST(Parts, ThatGoOnFromASocketAreOneBoneWithIt) {
  const TriangleMesh inner = cup(26.0, 60.0, 400);
  TriangleMesh outer = test::inside_out(cup(30.0, 60.0, 400));
  for (const auto& [a, b] : boundary_edges(inner)) {
    const auto next = static_cast<VertexIndex>(outer.vertices.size());
    outer.vertices.insert(outer.vertices.end(), {inner.vertices[a], inner.vertices[b]});
    outer.faces.push_back({next + 1, next, a});
    outer.faces.push_back({next + 1, a, b});
  }
  Hip hip;
  hip.ball = sphere(20.0, 400);
  hip.socket = inner;
  append_part(hip.socket, hip.socket_parts, "outer side", outer);
  Session session = session_of(std::move(hip));
  EXPECT_EQ(session.joint->bodies().verdict({}).contact, Contact::no);
  EXPECT_EQ(session.joint->bodies().verdict({Eigen::Matrix3d::Identity(), Vec3(0, 0, 100)}).contact,
            Contact::no);
  const TurnLimit limit = answer_limits(session, {.start = {}, .growing = "flexion"}).front().told.limit;
  EXPECT_EQ(limit.state, LimitState::free);
}

ResectRequest requiring(const std::string& motion, bool least = false) {
  ResectRequest request;
  request.require = {parse_motion(motion)};
  request.least = least;
  return request;
}

TEST(Parts, AreNamedWhereTheyTouchBeforeACut) {
  Hip hip = make_hip({}, 2000);
  TriangleMesh shifted = hip.ball;
  for (Vec3& x : shifted.vertices) x.x() += 1.0;
  append_part(hip.socket, hip.socket_parts, "plate", shifted);
  Session session = session_of(std::move(hip));
  EXPECT_EQ(test::thrown<std::runtime_error>([&] { answer(session, requiring("flexion=10")); }),
            "the ball meets plate in the pose of the scan, before any required motion; check the meshes and "
            "the centre");
}

// A cam is cut so that the path is clear, parts and all, pose by pose by the exact test; what only a part
// stops is no matter of a cut.
TEST(Parts, AreLookedAtAfterACut) {
  Session session = session_of(make_hip(test::hip_with_parts(hip_preset("cam")), 2000));
  const auto low = [&](Session& of) {
    return answer_limits(of, {.start = {.flexion = 70.0}, .growing = "internal_rotation"})
        .front()
        .told.limit.low_deg;
  };
  const double before = low(session);
  ASSERT_LT(before, 34.0);
  const ResectAnswer cut = answer(session, requiring("flexion=70,internal_rotation=35"));
  EXPECT_GT(cut.volume_mm3.low, 0.0);
  Hip hip = make_hip(test::hip_with_parts(hip_preset("cam")), 2000);
  const std::vector<MeshPart> names = std::exchange(hip.ball_parts, {});
  const std::vector<TriangleMesh> parts = part_surfaces(std::exchange(hip.ball, cut.mesh), names);
  for (std::size_t k = 0; k < parts.size(); ++k)
    append_part(hip.ball, hip.ball_parts, names[k].name, parts[k]);
  Session after = session_of(std::move(hip), session.joint->joint.centre);
  for (const double rotation : {0.0, before, 0.5 * (before + 35.0), 34.9}) {
    EXPECT_FALSE(touches(after, {.flexion = 70.0, .internal_rotation = rotation})) << rotation;
  }
  const std::string refusal = test::thrown<std::runtime_error>(
      [&] { answer(session, requiring("flexion=70,internal_rotation=55")); });
  EXPECT_EQ(refusal.rfind("the ball meets AIIS ", 0), 0U) << refusal;
  EXPECT_NE(
      refusal.find(" degrees into internal_rotation from 0 to 55 degrees at flexion 70, and bone beside "
                   "the joint is not cut; require less"),
      std::string::npos)
      << refusal;
}

// What does not look at parts says so, and leaves them out of nothing in silence.
TEST(Parts, AreRefusedWhereTheyAreNotLookedAt) {
  Session session = session_of(make_hip(test::hip_with_parts(), 2000));
  const std::string cure =
      ": bone beside the joint, such as greater trochanter, is not taken into account here; leave it out";
  EXPECT_EQ(
      test::thrown<std::runtime_error>([&] { answer(session, requiring("flexion=60", /*least=*/true)); }),
      "the least cut of all" + cure);
}

}  // namespace
}  // namespace impinge
