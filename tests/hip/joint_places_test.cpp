// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: places of a generated hip have the names that its smooth surfaces give them. Limits and their
// names: tests/joint/parts_test.cpp, real bones: tests/command/real_bones_test.cpp.
#include "hip/joint_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/hip_surface.hpp"
#include "mesh/icosphere.hpp"

namespace impinge {
namespace {

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
      const auto [hip, places] = made(preset, wall);
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

TEST(JointPlaces, AreNotToldWithoutHeadOrRim) {
  const TriangleMesh face{{{30, 0, 1}, {30, 2, 4}, {30, -2, 4}}, {{0, 1, 2}}};
  const JointPlaces none = joint_places({face, face});
  EXPECT_EQ(place_on_ball(none, {30, 0, 1}), "ball");
  EXPECT_EQ(place_on_socket(none, {30, 0, 1}), "socket");
  const TriangleMesh round = icosphere(20.0, 3);  // a head without a neck, in a shell without an opening
  const JointPlaces closed = joint_places({round, icosphere(24.0, 3)});
  EXPECT_EQ(place_on_ball(closed, {0, 0, 21}), "head") << "a bump";
  EXPECT_EQ(place_on_socket(closed, {0, 0, 24}), "socket");
}

TEST(JointPlaces, MakeWords) {
  EXPECT_EQ(meeting_words("neck", "rim"), "rim and neck");
  EXPECT_EQ(meeting_words("head", "inside of the socket"), "head within the socket");
  EXPECT_EQ(meeting_words("greater trochanter", "AIIS"), "AIIS and greater trochanter");
}

}  // namespace
}  // namespace impinge
