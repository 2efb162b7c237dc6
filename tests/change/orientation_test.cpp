// SPDX-License-Identifier: GPL-3.0-or-later
// The map of orientations beside a cone neck in a round rim, which has a closed form, and beside sockets that
// are really turned.
#include "change/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "limits/turn_limit.hpp"
#include "phantoms/phantom.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

constexpr double kOpeningHere = 87.0;  // degrees, from the pole of the cup to its rim
constexpr double kConeHere = 25.0;     // degrees, of the neck

// The axis that has these angles, written down from Murray's definitions.
Vec3 axis_with(const CupAngles& angles, double lateral) {
  const double inclination = angles.inclination_deg * kDegree;
  const double version = angles.anteversion_deg * kDegree;
  return {lateral * std::cos(version) * std::sin(inclination), std::sin(version),
          -std::cos(version) * std::cos(inclination)};
}

BallSocketPair cone_in_a_cup(const Vec3& neck, const Vec3& opening) {
  std::vector<LatheRing> ball = sphere_rings(22.0, kPi - kConeHere * kDegree, 10.0 * kDegree);
  ball.push_back({kPi - kConeHere * kDegree, 60.0});
  ball.push_back({kPi, 60.0 * std::cos(kConeHere * kDegree)});
  std::vector<LatheRing> cup = sphere_rings(26.0, kOpeningHere * kDegree, 10.0 * kDegree);
  cup.insert(cup.end() - 1, LatheRing{(kOpeningHere - 0.1) * kDegree, 26.0});
  return {revolve({ball, -neck, Vec3::Zero(), 60}),
          test::inside_out(revolve({cup, -opening, Vec3::Zero(), 60}))};
}

// The largest angle between neck and opening on the way; the joint is free where it is below that of the
// cone.
double widest(const std::vector<RequiredLeg>& legs, const Vec3& neck, const Vec3& opening) {
  double least = 1.0;
  for (const RequiredLeg& leg : legs) {
    for (int k = 0; k <= 100; ++k) {
      const Eigen::AngleAxisd turn(leg.largest_deg * kDegree * k / 100.0, leg.turn.axis);
      least = std::min(least, opening.dot(leg.turn.outer * (turn * (leg.turn.inner * neck))));
    }
  }
  return std::acos(least) / kDegree;
}

// How much may stay open is asked of all cells: the sides of the cone, which are seen edge-on, widen it.
void expect_closed_form(Side side, double tilt_deg) {
  const double lateral = side == Side::left ? -1.0 : 1.0;
  const CupAngles at_rest{48.0, 17.0};
  const Vec3 neck = axis_with({52.0, 8.0}, lateral);
  const CellTest joint(cone_in_a_cup(neck, axis_with(at_rest, lateral)));
  OrientationQuestion question;
  question.legs = required_legs(parse_motion("flexion=80,internal_rotation=20"), side);
  for (const RequiredLeg& leg : required_legs(parse_motion("extension=15"), side))
    question.legs.push_back(leg);
  question.side = side;
  question.at_rest = at_rest;
  question.tilt_deg = tilt_deg;
  question.least = {20.0, -10.0};
  question.width_deg = 60.0;
  question.resolution_deg = 2.0;
  const double limit = 180.0 - kOpeningHere - kConeHere;
  const Eigen::AngleAxisd tilt(tilt_deg * kDegree, Vec3::UnitX());
  std::map<CellState, double> area;
  for (const OrientationCell& cell : orientation_map(joint, question)) {
    area[cell.state] += 4.0 * cell.half_deg * cell.half_deg;
    ASSERT_EQ(cell.leg.has_value(), cell.state != CellState::free);
    const std::vector<RequiredLeg> stops =
        cell.leg ? std::vector{question.legs.at(*cell.leg)} : std::vector<RequiredLeg>{};
    for (const double a : {-1.0, 0.0, 1.0}) {
      for (const double b : {-1.0, 0.0, 1.0}) {
        const CupAngles angles{cell.middle.inclination_deg + a * cell.half_deg,
                               cell.middle.anteversion_deg + b * cell.half_deg};
        const double tilted = widest(question.legs, neck, tilt * axis_with(angles, lateral));
        ASSERT_TRUE(cell.state != CellState::free || tilted < limit + 0.02) << tilted;
        const double stopped = widest(stops, neck, tilt * axis_with(angles, lateral));
        ASSERT_TRUE(cell.state != CellState::blocked || stopped > limit - 0.02)
            << stopped << " of " << tilted;
      }
    }
  }
  EXPECT_GT(area[CellState::free], 300.0);
  EXPECT_GT(area[CellState::blocked], 500.0);
  EXPECT_EQ(area[CellState::unknown], 0.0);
  EXPECT_LT(area[CellState::open], 1300.0);
  EXPECT_NEAR(area[CellState::free] + area[CellState::blocked] + area[CellState::open], 3600.0, 1e-6);
}

TEST(TheoremOrientation, OfAConeInACupIsItsClosedForm) {
  expect_closed_form(Side::right, 0.0);
  expect_closed_form(Side::left, -12.0);
}

// Sockets that are turned, mesh and all, and asked of the exact overlay.
TEST(TheoremOrientation, AgreesWithSocketsThatAreTurned) {
  const Hip hip = make_hip(hip_preset("cam"), 800);
  const CellTest joint({hip.ball, hip.socket});
  OrientationQuestion question;
  question.legs = required_legs(parse_motion("flexion=100,internal_rotation=20"), Side::right);
  question.at_rest = {51.0, 17.0};
  question.tilt_deg = 6.0;
  question.resolution_deg = 3.0;
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  std::map<CellState, std::size_t> tried;
  const std::vector<OrientationCell> cells = orientation_map(joint, question);
  for (std::size_t k = 0; k < std::min<std::size_t>(random_cases(), 10'000) / 40; ++k) {
    const OrientationCell& cell = cells[engine() % cells.size()];
    const CupAngles angles{cell.middle.inclination_deg + share(engine) * cell.half_deg,
                           cell.middle.anteversion_deg + share(engine) * cell.half_deg};
    const Eigen::Matrix3d turned = pelvic_tilt(question.tilt_deg) * cup_rotation(angles, Side::right) *
                                   cup_rotation(question.at_rest, Side::right).transpose();
    const TurnLimits limits({hip.ball, test::turned(hip.socket, turned)});
    bool free = true;
    for (const RequiredLeg& leg : question.legs) {
      for (int i = 0; i <= 20; ++i) {
        const double angle = leg.largest_deg * i / 20.0;
        free = free && limits.verdict(leg.turn, angle).contact == Contact::no;
      }
    }
    ++tried[cell.state];
    EXPECT_TRUE(cell.state != CellState::free || free);
    // Of a blocked cell some pose touches: on this path it is held for more than a step, but at its edge.
    if (cell.state == CellState::blocked && free) {
      for (const RequiredLeg& leg : question.legs)
        free = free && limits.first_contact(leg.turn, leg.largest_deg).state == LimitState::free;
      EXPECT_FALSE(free);
    }
  }
  EXPECT_GT(tried[CellState::free], 3U);
  EXPECT_GT(tried[CellState::blocked], 3U);
}

// A dense grid over all orientations of a made-up map, each asked of the rotation matrices.
TEST(NearestOrientation, IsThatOfAGridOfRotations) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> inclination(-10.0, 100.0);
  std::uniform_real_distribution<double> anteversion(-40.0, 70.0);
  constexpr double kGrid = 0.5;  // degrees
  for (int k = 0; k < 60; ++k) {
    const Side side = k % 2 == 0 ? Side::left : Side::right;
    const CupAngles from{inclination(engine), anteversion(engine)};
    std::vector<OrientationCell> cells;
    for (double a = 4.5; a < 90.0; a += 9.0)
      for (double b = -25.5; b < 60.0; b += 9.0)
        cells.push_back({{a, b}, 4.5, engine() % 12 == 0 ? CellState::free : CellState::blocked, {}});
    double least = 360.0;
    for (const OrientationCell& cell : cells) {
      if (cell.state != CellState::free) continue;
      for (double a = -4.5; a <= 4.5; a += kGrid)
        for (double b = -4.5; b <= 4.5; b += kGrid) {
          const Eigen::Matrix3d turn =
              cup_rotation({cell.middle.inclination_deg + a, cell.middle.anteversion_deg + b}, side) *
              cup_rotation(from, side).transpose();
          least = std::min(least, Eigen::AngleAxisd(turn).angle() / kDegree);
        }
    }
    const auto found = nearest_orientation(cells, from, {CellState::free});
    ASSERT_EQ(found.has_value(), least < 360.0);
    if (!found) continue;
    const Eigen::Matrix3d turn = cup_rotation(found->angles, side) * cup_rotation(from, side).transpose();
    EXPECT_NEAR(Eigen::AngleAxisd(turn).angle() / kDegree, found->turn_deg, 1e-6);
    EXPECT_LE(found->turn_deg, least + 1e-6);
    EXPECT_GE(found->turn_deg, least - kGrid) << "a place beside the grid is no farther from it";
    EXPECT_NEAR(from.inclination_deg + found->change.inclination_deg, found->angles.inclination_deg, 1e-12);
    const bool in_a_free_one = std::any_of(cells.begin(), cells.end(), [&](const OrientationCell& cell) {
      return cell.state == CellState::free &&
             std::abs(cell.middle.inclination_deg - found->angles.inclination_deg) <= 4.5 &&
             std::abs(cell.middle.anteversion_deg - found->angles.anteversion_deg) <= 4.5;
    });
    EXPECT_TRUE(in_a_free_one);
  }
  EXPECT_FALSE(nearest_orientation({}, {45.0, 15.0}, {CellState::free}));
}

TEST(CupAngles, AreThoseOfMurray) {
  for (const Side side : {Side::right, Side::left}) {
    const double lateral = side == Side::left ? -1.0 : 1.0;
    for (const CupAngles angles : {CupAngles{45.0, 15.0}, {30.0, -20.0}, {80.0, 40.0}, {0.0, 0.0}}) {
      const Vec3 axis = axis_with(angles, lateral);
      EXPECT_TRUE((cup_rotation(angles, side) * -Vec3::UnitZ()).isApprox(axis, 1e-12));
      EXPECT_NEAR(cup_angles(axis, side).inclination_deg, angles.inclination_deg, 1e-9);
      EXPECT_NEAR(cup_angles(axis, side).anteversion_deg, angles.anteversion_deg, 1e-9);
    }
  }
  const Vec3 opened = pelvic_tilt(10.0) * axis_with({40.0, 15.0}, 1.0);
  EXPECT_GT(cup_angles(opened, Side::right).anteversion_deg, 18.0)
      << "a pelvis that tilts back opens forward";
}

}  // namespace
}  // namespace impinge
