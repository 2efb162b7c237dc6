// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: measured from the meshes alone, a generated hip has its parameters: angles to 0.5 degrees,
// lengths to 0.05 mm; over all presets, both sides, and hips drawn at random.
#include "hip/hip_measures.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/hip_surface.hpp"
#include "hip/measure_list.hpp"
#include "mesh/bodies.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

constexpr double kAngle = 0.5;              // degrees
constexpr double kAngleOfOneContour = 0.8;  // the same, where no median evens out the triangles
constexpr double kLength = 0.05;            // mm
const Vec3 kFarAway(40.0, -70.0, 900.0);

// Over the time that a measured alpha is the median of: on top of a narrow cam it is up to a degree below
// alpha at that place.
double median_alpha(const HipSurface& surface, double hours) {
  constexpr int kBeside = 50;
  std::vector<double> alpha;
  for (int k = -kBeside; k <= kBeside; ++k)
    alpha.push_back(alpha_angle_deg(surface, hours + MeasureChoices{}.alpha_window * k / kBeside));
  std::ranges::sort(alpha);
  return alpha[kBeside];
}

void expect_measures(const HipParameters& p, const Hip& hip) {
  HipParameters right = p;
  right.side = Side::right;
  const HipSurface surface = hip_surface(right);
  const FemurMeasures femur = measure_femur(test::moved(hip.ball, kFarAway), p.side);
  EXPECT_LT((femur.head.centre - kFarAway).norm(), kLength);
  EXPECT_NEAR(femur.head.radius, p.head_radius, kLength);
  EXPECT_NEAR(femur.head_neck_offset, p.head_neck_offset, kLength);
  EXPECT_NEAR(femur.neck_shaft_angle.value(), p.neck_shaft_angle, kAngle);
  EXPECT_NEAR(femur.femoral_torsion.value(), p.femoral_torsion, kAngle);
  for (std::size_t h = 0; h < kClockHours; ++h)
    EXPECT_NEAR(femur.alpha[h], alpha_angle_deg(surface, static_cast<double>(h)), kAngle) << h << " o'clock";
  EXPECT_NEAR(femur.alpha_at_1_30, median_alpha(surface, 1.5), kAngle);
  EXPECT_NEAR(femur.alpha_notzli, alpha_angle_deg(surface, 3.0), kAngleOfOneContour);  // heads are spheres

  const AcetabulumMeasures socket = measure_acetabulum(test::moved(hip.socket, kFarAway), femur.head, p.side);
  EXPECT_NEAR(socket.socket.radius - femur.head.radius, p.joint_space, kLength);
  Vec3 shift = socket.socket.centre - femur.head.centre;
  if (p.side == Side::left) shift.x() = -shift.x();
  EXPECT_LT((shift - surface.socket_centre).norm(), kLength);
  EXPECT_NEAR(socket.inclination, p.inclination, kAngle);
  EXPECT_NEAR(socket.version, p.version, kAngle);
  EXPECT_NEAR(socket.half_opening, p.half_opening, kAngle);
  EXPECT_NEAR(socket.lateral_centre_edge.value(), p.lateral_centre_edge, kAngle);
}

class HipMeasure : public testing::TestWithParam<std::string_view> {};

TEST_P(HipMeasure, PresetsHaveTheirParameters) {
  for (const Side side : {Side::left, Side::right}) {
    SCOPED_TRACE(side == Side::left ? "left" : "right");
    HipParameters p = hip_preset(GetParam());
    p.side = side;
    expect_measures(p, make_hip(p));
  }
}

INSTANTIATE_TEST_SUITE_P(Every, HipMeasure, testing::ValuesIn(hip_preset_names()),
                         [](const auto& name) { return std::string(name.param); });

// Each of these is drawn evenly from its range; the rest is the normal hip.
struct Range {
  double HipParameters::*value;
  double from;
  double to;
};

constexpr std::array kRanges{Range{&HipParameters::head_radius, 20.0, 28.0},
                             Range{&HipParameters::cam_height, 0.0, 4.0},
                             Range{&HipParameters::cam_half_width, 20.0, 40.0},
                             Range{&HipParameters::cam_polar, 45.0, 70.0},
                             Range{&HipParameters::cam_clock, 0.0, 4.0},
                             Range{&HipParameters::head_neck_offset, 6.5, 10.0},
                             Range{&HipParameters::neck_fillet, 3.0, 6.5},
                             Range{&HipParameters::neck_length, 50.0, 65.0},
                             Range{&HipParameters::neck_shaft_angle, 110.0, 145.0},
                             Range{&HipParameters::femoral_torsion, -20.0, 40.0},
                             Range{&HipParameters::shaft_length, 25.0, 80.0},
                             Range{&HipParameters::shaft_radius, 11.0, 17.0},
                             Range{&HipParameters::joint_space, 2.5, 6.0},
                             Range{&HipParameters::inclination, 40.0, 65.0},
                             Range{&HipParameters::version, -10.0, 35.0},
                             Range{&HipParameters::half_opening, 75.0, 95.0},
                             Range{&HipParameters::lateral_centre_edge, 15.0, 45.0},
                             Range{&HipParameters::pincer_height, 0.0, 5.0},
                             Range{&HipParameters::pincer_clock, 0.5, 5.0},
                             Range{&HipParameters::pincer_half_width, 0.7, 1.5},
                             Range{&HipParameters::fossa_depth, 0.0, 4.0},
                             Range{&HipParameters::shift_lateral, -1.0, 1.0},
                             Range{&HipParameters::shift_anterior, -1.0, 1.0},
                             Range{&HipParameters::shift_superior, -1.0, 1.0}};

class RandomHip : public testing::TestWithParam<unsigned> {};

// Drawn again where the parameters make no hip.
TEST_P(RandomHip, HasItsParameters) {
  constexpr int kMostDraws = 50;
  std::mt19937_64 random(GetParam());
  for (int k = 0; k < kMostDraws; ++k) {
    HipParameters p;
    p.side = GetParam() % 2 == 0 ? Side::right : Side::left;
    for (const Range& range : kRanges)
      p.*range.value = std::uniform_real_distribution<double>(range.from, range.to)(random);
    try {
      const Hip hip = make_hip(p);
      expect_measures(p, hip);
      return;
    } catch (const std::invalid_argument& impossible) {
      EXPECT_EQ(std::string(impossible.what()).substr(0, 9), "parameter");
    }
  }
  FAIL() << "no hip in " << kMostDraws;
}

INSTANTIATE_TEST_SUITE_P(Eight, RandomHip, testing::Range(1U, 9U));

// The rim in closed form, summed over the clock; a cap where it is round.
TEST(HipMeasures, CoverageIsThatWithinTheRim) {
  for (const double half_opening : {75.0, 82.0, 87.0, 94.0}) {
    HipParameters p = hip_preset("normal");
    p.half_opening = half_opening;
    const Hip hip = make_hip(p, 20000);
    const HipSurface surface = hip_surface(p);
    constexpr int kSteps = 1200;
    double covered = 0.0;
    for (int k = 0; k < kSteps; ++k)
      covered += (1.0 - std::cos(rim_polar(surface, 12.0 * k / kSteps))) / (2.0 * kSteps);
    const AcetabulumMeasures socket =
        measure_acetabulum(hip.socket, measure_femur(hip.ball, p.side).head, p.side);
    EXPECT_NEAR(socket.coverage, covered, 0.003) << half_opening;
  }
}

TEST(HipMeasures, TheWallChangesNothing) {
  HipParameters p = hip_preset("pincer");
  p.wall_thickness = 5.0;
  expect_measures(p, make_hip(p, 20000));
}

// 0.3 mm of noise: a single crossing of the contour would move twice as far.
TEST(HipMeasures, NoiseOfTheSurfaceMovesAlphaByAFewDegrees) {
  MeasureChoices single;
  single.alpha_window = 0.0;
  double most = 0.0;
  double most_of_single = 0.0;
  for (const char* preset : {"normal", "cam"}) {
    const HipParameters p = hip_preset(preset);
    const HipSurface surface = hip_surface(p);
    const Hip hip = make_hip(p);
    for (unsigned seed = 0; seed < 20; ++seed) {
      std::mt19937_64 random(seed);
      std::normal_distribution<double> error(0.0, 0.3);
      TriangleMesh noisy = hip.ball;
      for (Vec3& v : noisy.vertices) v += error(random) * v.normalized();
      const FemurMeasures femur = measure_femur(noisy, p.side);
      const FemurMeasures otherwise = measure_femur(noisy, p.side, single);
      for (std::size_t h = 0; h < kClockHours; ++h) {
        const double truth = alpha_angle_deg(surface, static_cast<double>(h));
        EXPECT_NEAR(femur.alpha[h], truth, 7.0) << preset << " " << seed << " at " << h << " o'clock";
        most = std::max(most, std::abs(femur.alpha[h] - truth));
        if (!std::isnan(otherwise.alpha[h]))
          most_of_single = std::max(most_of_single, std::abs(otherwise.alpha[h] - truth));
      }
    }
  }
  EXPECT_GT(most_of_single, 2.0 * most);
}

// The head of a hip, wider by 6 % across the plane of the neck and anterior: that plane sees the same
// contour.
TEST(HipMeasures, NotzlisAlphaIsThatOfItsPlaneAlone) {
  const HipParameters p = hip_preset("normal");
  Hip hip = make_hip(p, 40000);
  const FemurMeasures round = measure_femur(hip.ball, p.side);
  const Vec3 neck = round.neck_axis;
  const Vec3 across = neck.cross(Vec3::UnitY()).normalized();  // +y is posterior or anterior
  for (Vec3& v : hip.ball.vertices) v += 0.06 * v.dot(across) * across;
  const FemurMeasures wide = measure_femur(hip.ball, p.side);
  EXPECT_NEAR(wide.alpha_notzli, round.alpha_notzli, 2.0);
  EXPECT_GT(std::abs(wide.alpha[3] - round.alpha[3]), 5.0);
}

// A head that is off its sphere by a few tenths of a millimetre all over, and by 0.85 mm about 2 o'clock far
// beyond the neck: no edge of a cam ends there.
TEST(HipMeasures, AlphaIsNotThatOfABearingSurfaceOffItsSphere) {
  const HipParameters p = hip_preset("normal");
  Hip hip = make_hip(p);
  const Vec3 axis = measure_femur(hip.ball, p.side).neck_axis;
  const Vec3 outward = clock_direction(axis, *clock_about(axis), 0.5 * kPi, 2.0);
  for (Vec3& v : hip.ball.vertices) {
    const Vec3 u = v.normalized();
    const double polar = angle_between(v, axis) / kDegree;
    const double aside = angle_between(Vec3(v - v.dot(axis) * axis), outward) / kDegree;
    if (v.norm() > 1.1 * p.head_radius || polar < 30.0) continue;
    v += (0.3 * std::sin(9.0 * u.x()) * std::cos(8.0 * u.y()) +
          0.85 * std::clamp((108.0 - polar) / 6.0, 0.0, 1.0) * std::clamp((40.0 - aside) / 10.0, 0.0, 1.0)) *
         u;
  }
  EXPECT_GT(measure_femur(hip.ball, p.side).alpha[2], 95.0);  // taken at its word
  const std::vector<Measure> measures = measure_hip({hip.ball, hip.socket}, p.side);
  const auto at_2 =
      std::ranges::find_if(measures, [](const Measure& one) { return one.name == "alpha_at_2"; });
  ASSERT_NE(at_2, measures.end());
  EXPECT_TRUE(at_2->state.ends_with("deg, depending on how far off its sphere the head ends")) << at_2->state;
}

TEST(HipMeasures, ABallWithoutAShaftHasNoShaftAngle) {
  const FemurMeasures femur = measure_femur(make_hip({.shaft_length = 0.0}).ball, Side::right);
  EXPECT_FALSE(femur.neck_shaft_angle);
  EXPECT_FALSE(femur.femoral_torsion);
  EXPECT_NEAR(femur.head_neck_offset, 9.1, kLength);
}

TEST(HipMeasures, WhatIsNoHipIsRefused) {
  EXPECT_THROW(measure_femur(sphere(24.0, 1000), Side::right), std::invalid_argument);
  EXPECT_THROW(measure_acetabulum(sphere(24.0, 1000), {Vec3::Zero(), 24.0}, Side::right),
               std::invalid_argument);
}

}  // namespace
}  // namespace impinge
