// SPDX-License-Identifier: GPL-3.0-or-later
// The stand-ins for the thesis' patients: at the ends of the motions of Table 11 the zones with less than 2
// mm between the bones ("red", Section 5.2) lie where Tables 12 and 13 report them, and the motions that the
// text names have the smallest gaps.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hip/clock.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/hip_surface.hpp"
#include "hip/motion.hpp"

namespace impinge {
namespace {

constexpr double kRed = 2.0;  // mm

struct Extreme {
  double smallest = 1e9;
  double hours = 0.0;             // where
  std::vector<double> red_hours;  // of the socket's vertices with less than 2 mm
};

// Radial gaps of the socket's vertices against the smooth ball.
Extreme extreme(const char* preset, const std::string& motion) {
  HipParameters p = hip_preset(preset);
  const Eigen::Matrix3d turn = joint_rotation(parse_motion(motion), p.side).transpose();
  const Hip hip = make_hip(p, 3000);
  const ClockFace dial = clock_face(hip.socket).value();
  const Eigen::DiagonalMatrix<double, 3> to_right(p.side == Side::left ? -1.0 : 1.0, 1.0, 1.0);
  const HipSurface surface = hip_surface(p);
  Extreme found;
  for (const Vec3& x : hip.socket.vertices) {
    const Vec3 direction = to_right * (turn * x.normalized());
    const double gap = x.norm() - head_neck_radius(surface, direction);
    if (gap < kRed) found.red_hours.push_back(dial.hours(x));
    if (gap < found.smallest) found = {gap, dial.hours(x), std::move(found.red_hours)};
  }
  return found;
}

using Extremes = std::map<std::string, Extreme>;

Extremes extremes(const char* preset, const std::map<std::string, std::string>& table_11) {
  Extremes all;
  for (const auto& [motion, degrees] : table_11) all[motion] = extreme(preset, motion + "=" + degrees);
  return all;
}

bool lies(double hours, double from, double to) { return hours >= from && hours <= to; }

TEST(PatientA, RedZonesAtOneToTwo) {
  const Extremes at = extremes("patient_a", {{"abduction", "48.7"},
                                             {"adduction", "26.4"},
                                             {"external_rotation", "39.9"},
                                             {"internal_rotation", "5.6"},
                                             {"extension", "5.2"},
                                             {"flexion", "103.1"}});
  for (const auto& [motion, found] : at) {
    EXPECT_GT(found.smallest, 0.0) << motion;
    const bool named = motion == "abduction" || motion == "internal_rotation" || motion == "flexion";
    EXPECT_EQ(found.smallest < 1.5, named) << motion << " " << found.smallest;
    EXPECT_EQ(!found.red_hours.empty(), named) << motion;
    for (const double hours : found.red_hours) EXPECT_TRUE(lies(hours, 0.5, 2.5)) << motion << " " << hours;
    EXPECT_TRUE(!named || lies(found.hours, 1.0, 2.0)) << motion << " " << found.hours;
  }
}

TEST(PatientB, RedZonesAtOneToThreeAndSeven) {
  const Extremes at = extremes("patient_b", {{"abduction", "30.3"},
                                             {"adduction", "22.7"},
                                             {"external_rotation", "21.0"},
                                             {"internal_rotation", "12.2"},
                                             {"extension", "14.5"},
                                             {"flexion", "115.8"}});
  for (const auto& [motion, found] : at) {
    EXPECT_GT(found.smallest, 0.0) << motion;
    const bool named = motion != "external_rotation" && motion != "extension";
    EXPECT_EQ(found.smallest < 1.5, named) << motion << " " << found.smallest;
    EXPECT_EQ(!found.red_hours.empty(), named) << motion;
    const bool seven = motion == "adduction";
    EXPECT_TRUE(!named || lies(found.hours, seven ? 6.5 : 1.0, seven ? 7.5 : 3.0)) << motion << found.hours;
  }
}

}  // namespace
}  // namespace impinge
