// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "hip/cartilage_map.hpp"
#include "hip/close_zones.hpp"
#include "hip/gap_files.hpp"
#include "hip/hip.hpp"
#include "hip/hip_surface.hpp"
#include "hip/rim_line.hpp"
#include "mesh/bodies.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

constexpr std::size_t kSectors = 48;

// A hip's rim is where hip_surface.hpp has it: at rim_polar() from the pole of the socket.
TEST(RimLine, FollowsTheRimOfAHip) {
  for (const Side side : {Side::right, Side::left}) {
    HipParameters parameters;
    parameters.side = side;
    parameters.pincer_height = 4.0;
    const HipSurface surface = hip_surface(parameters);
    const TriangleMesh socket = make_hip(parameters, 3000).socket;
    const auto dial = clock_face(socket);
    ASSERT_TRUE(dial);
    const std::vector<RimPoint> rim = rim_line(socket, *dial, kSectors);
    ASSERT_EQ(rim.size(), kSectors);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      Vec3 x = rim[i].place;
      EXPECT_DOUBLE_EQ(rim[i].hours, dial->hours(x));
      EXPECT_EQ(static_cast<std::size_t>(rim[i].hours * kSectors / 12.0), i);
      if (side == Side::left) x.x() = -x.x();  // hip_surface.hpp is of a right hip
      const Vec3 from_centre = (x - surface.socket_centre).normalized();
      const double polar = std::acos(-surface.opening.dot(from_centre));
      EXPECT_NEAR(polar, rim_polar(surface, surface.rim_clock.hours(from_centre)), 1e-6) << i;
    }
  }
}

TEST(RimLine, LeavesOutWhatIsNotThere) {
  const TriangleMesh face{{{30, 0, 1}, {30, 2, 4}, {30, -2, 4}}, {{0, 1, 2}}};
  const ClockFace dial{Vec3::UnitZ(), Vec3::UnitY()};
  for (const RimPoint& at : rim_line(face, dial, kSectors))
    EXPECT_LT(std::abs(std::remainder(at.hours, 12.0)), 1.0);
}

// surface,vertex,x,y,z,gap_mm: shortest numbers, and no gap where there is none.
TEST(GapFiles, CsvHasALineAVertex) {
  const std::vector<Vec3> places{{1.5, -2.0, 0.1}, {0.0, 3e-7, 1e22}};
  const std::vector<double> gap{-0.25, std::nan("")};
  EXPECT_EQ(gaps_csv({Surface::ball, places, gap}, {Surface::socket, {}, {}}),
            "surface,vertex,x,y,z,gap_mm\nball,0,1.5,-2,0.1,-0.25\nball,1,0,3e-07,1e+22,\n");
}

// Contract: the zones hold the area of the vertices whose gap is at most the threshold, where they stand on
// the dial.

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A point at `hours` of a dial that is looked at along x: 12 up, 3 anterior.
Vec3 at(double hours) {
  const double angle = hours * kPi / 6.0;
  return {-1.0, std::sin(angle), std::cos(angle)};
}

TEST(CloseZones, HoldTheVerticesWithinTheThreshold) {
  const std::vector<Vec3> vertices{at(1.1), at(1.4), at(7.1), at(3.1), at(9.1)};
  const std::vector<double> gap{1.9, 2.0, -0.5, 2.1, kNan};
  const std::vector<double> area{2.0, 3.0, 4.0, 8.0, 16.0};
  const auto zones = close_zones(ClockFace{}, {vertices, gap, area}, 2.0);
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_EQ(zones[0].from, 1.0);
  EXPECT_EQ(zones[0].to, 1.5);
  EXPECT_EQ(zones[0].area, 5.0);
  EXPECT_EQ(zones[1].from, 7.0);
  EXPECT_EQ(zones[1].to, 7.25);
  EXPECT_EQ(zones[1].area, 4.0);
}

TEST(CloseZones, ThereAreNoneWhereNothingIsClose) {
  const std::vector<Vec3> vertices{at(1.0), at(2.0)};
  const std::vector<double> gap{5.0, kNan};
  const std::vector<double> area{1.0, 1.0};
  EXPECT_TRUE(close_zones(ClockFace{}, {vertices, gap, area}, 2.0).empty());
}

// Contract: t(u) is the map's own value at its directions, the mean of the four nearest weighted by 1 / d^2
// elsewhere, so between their smallest and largest; a gap g > 0 becomes g / t(u), a gap g <= 0 stays.

CartilageMap smooth_map(std::size_t faces) {
  CartilageMap map;
  for (const Vec3& v : sphere(1.0, faces).vertices) {
    map.directions.push_back(v.normalized());
    map.thickness.push_back(2.0 + v.z());
  }
  return map;
}

TEST(CartilageMap, GivesItsOwnValuesBack) {
  const CartilageMap map = smooth_map(500);
  for (std::size_t i = 0; i < map.directions.size(); ++i)
    EXPECT_EQ(thickness_at(map, 7.0 * map.directions[i]), thickness_at(map, map.directions[i]));
  EXPECT_EQ(thickness_at(map, map.directions[3]), map.thickness[3]);
}

// Neighbours of a map of 2000 directions are 0.08 apart, and the thickness changes by 1 a radian.
TEST(CartilageMap, IsCloseToASmoothThickness) {
  const CartilageMap map = smooth_map(4000);
  for (const Vec3& u : test::random_directions(500, 3)) EXPECT_NEAR(thickness_at(map, u), 2.0 + u.z(), 0.08);
}

// Four directions at equal distances: their mean; and with 1 / d^2 by hand.
TEST(CartilageMap, WeighsByTheInverseSquare) {
  const CartilageMap cross{{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY()},
                           {1.0, 2.0, 3.0, 6.0}};
  EXPECT_NEAR(thickness_at(cross, Vec3::UnitZ()), 3.0, 1e-15);
  const Vec3 u(0.6, 0.0, 0.8);  // squared distances 0.8, 3.2, 2, 2
  const double weights = 1.0 / 0.8 + 1.0 / 3.2 + 0.5 + 0.5;
  EXPECT_NEAR(thickness_at(cross, u), (1.0 / 0.8 + 2.0 / 3.2 + 1.5 + 3.0) / weights, 1e-14);
}

TEST(CartilageMap, OfFewerThanFourDirectionsWorks) {
  EXPECT_EQ(thickness_at({{Vec3::UnitX()}, {2.5}}, -Vec3::UnitX()), 2.5);
  EXPECT_EQ(thickness_at({{Vec3::UnitX(), Vec3::UnitY()}, {1.0, 3.0}}, Vec3::UnitZ()), 2.0);
}

TEST(CartilageMap, SharesOfTheThickness) {
  const CartilageMap map{{Vec3::UnitX(), -Vec3::UnitX()}, {2.0, 0.0}};
  const std::vector<double> gap{3.0, 0.5, 0.0, -1.5, std::numeric_limits<double>::quiet_NaN(), 1.0};
  const std::vector<Vec3> places{Vec3(9, 0, 0), Vec3(8, 0, 0), Vec3(8, 0, 0),
                                 Vec3(8, 0, 0), Vec3(8, 0, 0), Vec3(-8, 0, 0)};
  const std::vector<double> share = shares_of_cartilage(gap, places, map);
  EXPECT_EQ(share[0], 1.5);
  EXPECT_EQ(share[1], 0.25);
  EXPECT_EQ(share[2], 0.0);
  EXPECT_EQ(share[3], -1.5);
  EXPECT_TRUE(std::isnan(share[4]));
  EXPECT_TRUE(std::isinf(share[5]));
}

}  // namespace
}  // namespace impinge
