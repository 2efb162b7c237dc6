// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: what cannot be a joint is refused in one line that names the mesh; a cap of a ball and a size
// that no human joint has get a warning.
#include "hip/joint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/hip_surface.hpp"
#include "hip/joint_places.hpp"
#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

const Vec3 kPlace(60.0, -20.0, 300.0);  // of the centre, in the frame of the files
constexpr double kRadius = 24.0;

TriangleMesh moved(TriangleMesh mesh, const Vec3& by, double scale = 1.0) {
  for (Vec3& x : mesh.vertices) x = scale * x + by;
  return mesh;
}

// Cartilage of a head: two layers that end at an angle from the pole, as thin as a segmentation has them.
TriangleMesh shell(double half_opening_deg, std::size_t faces = 1200) {
  return test::joined(cup(kRadius - 2.0, half_opening_deg, faces),
                      test::inside_out(cup(kRadius, half_opening_deg, faces)));
}

double share_of(double half_opening_deg) { return 50.0 * (1.0 - std::cos(half_opening_deg * kDegree)); }

JointInput joint_of(TriangleMesh ball, TriangleMesh socket) {
  JointInput input;
  input.ball = {"ball.ply", std::move(ball)};
  input.socket = {"socket.ply", std::move(socket)};
  return input;
}

JointInput capped(double half_opening_deg, std::size_t faces = 1200) {
  return joint_of(moved(shell(half_opening_deg, faces), kPlace), moved(cup(25.0, 85.0, faces), kPlace));
}

// What is said where the joint is refused; empty where it is taken.
std::string refusal(JointInput input) {
  return test::thrown<std::exception>([&] { assemble_joint(std::move(input)); });
}

bool has(const Joint& joint, const std::string& words) {
  for (const std::string& warning : joint.warnings)
    if (warning.find(words) != warning.npos) return true;
  return false;
}

// A rim of radius 25 and half opening 85 degrees that is moved by 60 mm along its axis is 63 mm from the
// centre.
TEST(AssembledJoint, ASocketFarFromTheBallIsTheFirstOfItsWarnings) {
  for (const double away : {0.0, 5.0, 60.0}) {
    JointInput input = joint_of(sphere(kRadius, 3000), moved(cup(25.0, 85.0, 1200), Vec3(0.0, 0.0, away)));
    input.centre = Vec3::Zero();
    const Joint joint = assemble_joint(std::move(input));
    const bool first =
        !joint.warnings.empty() && joint.warnings[0].find("nowhere nearer") != std::string::npos;
    EXPECT_EQ(joint.doubts, away > 50.0 ? 1U : 0U) << away;
    EXPECT_EQ(first, away > 50.0) << away;
  }
}

TEST(AssembledJoint, ASocketThatFacesNoneOfTheBallIsTheFirstOfItsWarnings) {
  JointInput input = joint_of(shell(60.0, 1200), cup(25.0, 60.0, 1200));
  for (Vec3& x : input.socket.mesh.vertices) x = Vec3(-x.x(), x.y(), -x.z());
  input.centre = Vec3::Zero();
  const Joint joint = assemble_joint(std::move(input));
  ASSERT_EQ(joint.doubts, 1U);
  EXPECT_EQ(joint.warnings[0].find("socket.ply: shares no ray from the centre with the ball as scanned"), 0U);
}

TEST(AssembledJoint, ACapOfABallIsTakenWithAWarningThatTellsItsShare) {
  for (const double angle : {30.0, 60.0, 80.0}) {
    for (const bool given : {false, true}) {
      JointInput input = capped(angle);
      if (given) input.centre = kPlace;
      const Joint joint = assemble_joint(std::move(input));
      EXPECT_LT((joint.centre - kPlace).norm(), 1.5) << angle;
      EXPECT_NEAR(100.0 * joint.ball.star_shape.covered, share_of(angle), 2.0);
      EXPECT_TRUE(has(joint, "ball.ply: is a cap, ")) << angle;
      EXPECT_TRUE(has(joint, " % of the view")) << angle;
    }
  }
}

// A fit finds no sphere in it, and needs none.
TEST(AssembledJoint, ASmallCapIsTakenWhereTheCentreIsGiven) {
  JointInput input = capped(15.0, 100);
  input.centre = kPlace + Vec3(1.0, 0.0, 0.0);
  EXPECT_TRUE(has(assemble_joint(std::move(input)), "ball.ply: is a cap, 2 % of the view"));
}

TEST(AssembledJoint, AShellThatFillsMostOfTheViewAndAClosedBallAreNoCaps) {
  EXPECT_FALSE(has(assemble_joint(capped(100.0)), "is a cap"));
  EXPECT_FALSE(has(assemble_joint(joint_of(sphere(kRadius, 1000), cup(25.0, 85.0, 1000))), "is a cap"));
}

TEST(AssembledJoint, ABallBesideItsCentreIsRefused) {
  for (const double aside : {1.3, 2.0, 10.0}) {
    for (const TriangleMesh& ball : {sphere(kRadius, 1000), shell(80.0)}) {
      JointInput input = joint_of(moved(ball, kPlace), moved(cup(25.0, 85.0, 1000), kPlace));
      input.centre = kPlace + Vec3(aside * kRadius, 0.0, 0.0);
      const std::string said = refusal(std::move(input));
      EXPECT_EQ(said.rfind("ball.ply: fills only ", 0), 0U) << said;
      EXPECT_NE(said.find("lies outside of the ball; give a centre inside with --centre"), said.npos) << said;
    }
  }
}

// The socket is out of sight, which is told once the ball is taken. Four milliseconds each, for a raster of
// half a degree: 1,000 cases, and 10,000 where others have 100,000.
TEST(AssembledJoint, CapsOfAnySizeAndCentre) {
  std::mt19937_64 random(18);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const TriangleMesh out_of_sight{{{1e3, 0, 1}, {1e3, 1e-3, 1}, {1e3, 0, 1.001}}, {{0, 1, 2}}};
  const std::size_t cases = std::max<std::size_t>(random_cases() / 10, 1000);
  for (std::size_t k = 0; k < cases; ++k) {
    const double angle = between(25.0, 88.0);
    const Vec3 aside = Vec3(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)).normalized();
    const bool inside = k % 2 == 0;
    JointInput input = joint_of(moved(shell(angle, 30), kPlace), out_of_sight);
    input.centre = kPlace + kRadius * (inside ? between(0.0, 0.5) : between(1.5, 5.0)) * aside;
    const std::string said = refusal(std::move(input));
    const std::string expected = inside ? "meets the socket" : "outside of the ball";
    ASSERT_NE(said.find(expected), said.npos) << angle << ' ' << said;
  }
}

TEST(AssembledJoint, CapsAndSocketsThatChangedPlacesAreRefused) {
  for (const double angle : {40.0, 60.0, 95.0}) {
    JointInput input = capped(angle);
    std::swap(input.ball.mesh, input.socket.mesh);
    EXPECT_NE(refusal(std::move(input)).find("swapped"), std::string::npos) << angle;
  }
}

TEST(AssembledJoint, OneMeshForBothIsRefusedWhateverItsName) {
  EXPECT_EQ(refusal(joint_of(sphere(kRadius, 1000), sphere(kRadius, 1000))),
            "socket.ply: is the mesh of the ball and of the socket; check the files of --ball and --socket");
}

TEST(AssembledJoint, MetresCentimetresAndInchesGetAWarning) {
  const Hip hip = make_hip({}, 2000);
  for (const double unit : {1e-3, 0.1, 1.0 / 25.4, 10.0, 1e3}) {
    const Joint joint =
        assemble_joint(joint_of(moved(hip.ball, Vec3::Zero(), unit), moved(hip.socket, Vec3::Zero(), unit)));
    EXPECT_TRUE(has(joint, "lengths are read as mm, scale both meshes")) << unit;
    if (unit == 1e-3 || unit == 1e3)
      EXPECT_EQ(test::thrown<std::runtime_error>([&] {
                  require_mm(joint, "femur.stl");
                }).find("femur.stl: has a radius of "),
                0U);
    else
      require_mm(joint, "femur.stl");
  }
  EXPECT_TRUE(assemble_joint(joint_of(hip.ball, hip.socket)).warnings.size() < 2);
  EXPECT_FALSE(has(assemble_joint(joint_of(hip.ball, hip.socket)), "lengths"));
}

// Its shaft reaches as far as the socket is away.
TEST(AssembledJoint, AWholeFemurInAnotherUnitThanItsSocketIsRefused) {
  HipParameters parameters;
  parameters.shaft_length = 200.0;
  const Hip hip = make_hip(parameters, 4000);
  for (const double unit : {1e-3, 0.1, 10.0, 1e3}) {
    const std::string said = refusal(joint_of(moved(hip.ball, Vec3::Zero(), unit), hip.socket));
    EXPECT_NE(said.find("check that both meshes are in mm and in one frame"), said.npos) << unit << said;
    EXPECT_NE(refusal(joint_of(hip.ball, moved(hip.socket, Vec3::Zero(), unit))), "") << unit;
  }
}

// Contract: places of a generated hip have the names that its smooth surfaces give them. Limits and their
// names: tests/joint/parts_test.cpp, real bones: tests/command/real_bones_test.cpp.

constexpr double kNearPolar = 1.5 * kDegree;  // of where one name ends and the next begins nothing is asked

struct Made {
  HipSurface surface;
  JointPlaces places;
};

Made made(const char* preset, double wall_thickness = 0.0) {
  HipParameters parameters = hip_preset(preset);
  parameters.side = Side::right;
  parameters.wall_thickness = wall_thickness;
  const Hip hip = make_hip(parameters, 4000);
  return {hip_surface(parameters), joint_places({hip.ball, hip.socket})};
}

// Along meridians about the neck, which the alpha angle divides in neck and head.
TEST(JointPlaces, DivideTheBallByTheAlphaAngle) {
  for (const char* preset : {"normal", "cam"}) {
    const auto [hip, places] = made(preset);
    std::array<int, 3> seen{};
    for (int hours = 0; hours < 12; ++hours) {
      const double alpha = alpha_angle_deg(hip, hours) * kDegree;
      for (double polar = 20.0 * kDegree; polar < kPi; polar += 5.0 * kDegree) {
        if (std::abs(polar - alpha) < kNearPolar) continue;
        const Vec3 u = clock_direction(hip.neck, hip.neck_clock, polar, hours);
        const double radius = head_neck_radius(hip, u);
        if (std::abs(radius - 1.5 * hip.head_radius) < 1.0) continue;
        const bool beyond = radius > 1.5 * hip.head_radius;
        const bool neck = polar < alpha;
        EXPECT_EQ(place_on_ball(places, radius * u), beyond ? "trochanter or shaft"
                                                     : neck ? "neck"
                                                            : "head")
            << preset << " " << hours << " " << polar / kDegree << " " << alpha / kDegree;
        ++seen[beyond ? 0 : neck ? 1 : 2];
      }
    }
    EXPECT_GT(*std::ranges::min_element(seen), 10);
  }
}

// Along meridians of the socket from its pole over the rim and back on the outer side of its wall.
TEST(JointPlaces, DivideTheSocketByItsRim) {
  constexpr double kWall = 8.0;
  for (const char* preset : {"normal", "pincer"}) {
    for (const double wall : {0.0, kWall}) {
      const Made joint = made(preset, wall);
      const HipSurface& hip = joint.surface;  // clang 14 takes no structured binding into a lambda
      const JointPlaces& places = joint.places;
      for (int hours = 0; hours < 12; ++hours) {
        const double rim = rim_polar(hip, hours);
        const auto named = [&](double polar, double out) {
          const Vec3 u = clock_direction(-hip.opening, hip.rim_clock, polar, hours);
          return place_on_socket(places, hip.socket_centre + (inner_radius(hip, u) + out) * u);
        };
        for (double polar = 0.0; polar < rim - 14.0 * kDegree; polar += 5.0 * kDegree)
          EXPECT_EQ(named(polar, 0.0), "inside of the socket") << hours << " " << polar / kDegree;
        for (const double before : {0.0, 3.0, 6.0})
          EXPECT_EQ(named(rim - before * kDegree, 0.0), "rim") << preset << " " << wall << " " << hours;
        EXPECT_EQ(named(rim, 1.5 * kWall), "bone beyond the rim") << hours;
        EXPECT_EQ(named(0.8 * rim, kWall), "bone beyond the rim") << hours;
      }
    }
  }
}

// Of a generated hip: both sides of the wall at the rim, and neck with shaft from where they leave the head.
TEST(JointPlaces, LeaveTheRimAlone) {
  HipParameters parameters = hip_preset("cam");
  parameters.wall_thickness = 4.0;
  const Hip hip = make_hip(parameters, 6000);
  const HipSurface surface = hip_surface(parameters);
  const Vec3 origin(3.0, -2.0, 1.0);  // of the meshes
  const JointPlaces places = joint_places({relative_to(hip.ball, -origin), relative_to(hip.socket, -origin)});
  TriangleMesh rim = hip.socket;
  leave_rim(places, origin, rim);
  TriangleMesh neck = hip.ball;
  leave_off_head(places, origin, neck);
  const auto faces_of = [](const TriangleMesh& mesh) {
    return std::set<Face>(mesh.faces.begin(), mesh.faces.end());
  };
  const auto of_rim = faces_of(rim);
  std::vector<Vec3> on_rim;
  for (int k = 0; k < 720; ++k) {
    const double hours = k / 60.0;
    const Vec3 u = clock_direction(-surface.opening, surface.rim_clock, rim_polar(surface, hours), hours);
    on_rim.emplace_back(surface.socket_centre + inner_radius(surface, u) * u);
  }
  std::array<std::size_t, 2> seen{};
  for (const Face& face : hip.socket.faces) {
    double least = HUGE_VAL;  // from the rim
    for (const VertexIndex v : face)
      for (const Vec3& p : on_rim) least = std::min(least, (hip.socket.vertices[v] - p).norm());
    if (std::abs(least - 0.1 * places.socket->radius) < 0.3) continue;
    EXPECT_EQ(of_rim.contains(face), least < 0.1 * places.socket->radius);
    ++seen[of_rim.contains(face) ? 1 : 0];
  }
  EXPECT_GT(seen[0], 500U);
  EXPECT_GT(seen[1], 500U);
  const auto of_neck = faces_of(neck);
  seen = {};
  for (const Face& face : hip.ball.faces) {
    double farthest = 0.0;
    for (const VertexIndex v : face) farthest = std::max(farthest, hip.ball.vertices[v].norm());
    if (std::abs(farthest - 1.005 * surface.head_radius) < 0.1) continue;
    EXPECT_EQ(of_neck.contains(face), farthest > surface.head_radius + 0.1);
    ++seen[of_neck.contains(face) ? 1 : 0];
  }
  EXPECT_GT(seen[0], 500U);
  EXPECT_GT(seen[1], 500U);
  EXPECT_EQ(rim_in_head(places), std::nullopt);
  JointPlaces deep = places;
  deep.rim->points = {
      Vec3(0.0, 0.0, 40.0), std::nullopt,
      places.head->centre + Vec3(0.0, places.head->radius - 0.5, 0.0) - places.socket->centre};
  EXPECT_NEAR(rim_in_head(deep).value(), 0.5, 1e-9);
}

TEST(JointPlaces, AreNotToldWithoutHeadOrRim) {
  const TriangleMesh face{{{30, 0, 1}, {30, 2, 4}, {30, -2, 4}}, {{0, 1, 2}}};
  const JointPlaces none = joint_places({face, face});
  EXPECT_EQ(place_on_ball(none, {30, 0, 1}), "ball");
  EXPECT_EQ(place_on_socket(none, {30, 0, 1}), "socket");
  const TriangleMesh round = icosphere(20.0, 3);  // a head without a neck, in a shell without an opening
  const JointPlaces closed = joint_places({round, icosphere(24.0, 3)});
  EXPECT_EQ(place_on_ball(closed, {0, 0, 21}), "head") << "a bump";
  EXPECT_EQ(place_on_socket(closed, {0, 0, 24}), "socket");
  for (const JointPlaces& places : {none, closed}) {
    TriangleMesh socket = icosphere(24.0, 3);
    EXPECT_THROW(leave_rim(places, Vec3::Zero(), socket), std::invalid_argument);
  }
  TriangleMesh ball = round;
  EXPECT_THROW(leave_off_head(closed, Vec3::Zero(), ball), std::invalid_argument);
}

TEST(JointPlaces, MakeWords) {
  EXPECT_EQ(meeting_words("neck", "rim"), "rim and neck");
  EXPECT_EQ(meeting_words("head", "inside of the socket"), "head within the socket");
  EXPECT_EQ(meeting_words("greater trochanter", "AIIS"), "AIIS and greater trochanter");
}

}  // namespace
}  // namespace impinge
