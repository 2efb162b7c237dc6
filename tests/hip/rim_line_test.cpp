// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/rim_line.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "hip/gap_files.hpp"
#include "hip/hip.hpp"
#include "hip/hip_surface.hpp"

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

}  // namespace
}  // namespace impinge
