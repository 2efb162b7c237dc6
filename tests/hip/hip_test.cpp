// SPDX-License-Identifier: GPL-3.0-or-later
// Contract of a generated hip: about as many faces as asked for; the ball closed with outward normals, its
// vertices on head and neck at |v| = head_neck_radius(v / |v|); the socket with normals towards the centre,
// its vertices at |v| = socket_radius(v / |v|); star-shaped about the centre (proven) where there is no
// shaft; the left hip the mirror image of the right one; nothing penetrates at rest.
#include "hip/hip.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hip/clock.hpp"
#include "hip/hip_presets.hpp"
#include "hip/hip_surface.hpp"
#include "hip/motion.hpp"
#include "mesh/star_shape.hpp"
#include "mesh/validation.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

class HipPreset : public testing::TestWithParam<std::string_view> {};

TEST_P(HipPreset, MeshesAreSound) {
  const BallSocketPair hip = main_surfaces(make_hip(hip_preset(GetParam())));
  for (const TriangleMesh* mesh : {&hip.ball, &hip.socket}) {
    const MeshReport report = validate(*mesh);
    EXPECT_NEAR(static_cast<double>(report.faces), static_cast<double>(kHipFaces), 0.03 * kHipFaces);
    EXPECT_EQ(report.degenerate_faces + report.flipped_faces + report.non_manifold_edges, 0U);
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.unreferenced_vertices, 0U);
  }
  EXPECT_GT(validate(hip.ball).volume.value(), 0.0);  // closed
  for (const Face& face : hip.socket.faces) {
    EXPECT_LT(area_vector(hip.socket, face).dot(corner(hip.socket, face, 0)), 0.0);
  }
}

TEST_P(HipPreset, VerticesLieOnTheSmoothSurfaces) {
  HipParameters p = hip_preset(GetParam());
  p.side = Side::right;
  const HipSurface surface = hip_surface(p);
  const BallSocketPair hip = main_surfaces(make_hip(p, 3000));
  std::size_t checked = 0;
  for (const Vec3& v : hip.ball.vertices) {
    if (v.dot(surface.neck) > neck_end(surface) - 1e-9) continue;  // the shaft
    ++checked;
    EXPECT_NEAR(v.norm(), head_neck_radius(surface, v.normalized()), 1e-9);
  }
  EXPECT_GT(checked, hip.ball.vertices.size() / 2);
  for (const Vec3& v : hip.socket.vertices)
    EXPECT_NEAR(v.norm(), socket_radius(surface, v.normalized()), 1e-9);
}

TEST_P(HipPreset, IsStarShapedWithoutTheShaft) {
  HipParameters p = hip_preset(GetParam());
  p.shaft_length = 0.0;
  ASSERT_TRUE(make_hip(p, 3000).ball_parts.empty());
  const BallSocketPair hip = main_surfaces(make_hip(p, 3000));
  EXPECT_TRUE(star_shape(hip.ball).star_shaped);
  EXPECT_TRUE(star_shape(hip.socket).star_shaped);
  EXPECT_GT(validate(hip.ball).volume.value(), 0.0);
}

TEST_P(HipPreset, AWallMakesTheSocketAClosedShell) {
  HipParameters p = hip_preset(GetParam());
  p.wall_thickness = 5.0;
  const MeshReport report = validate(main_surfaces(make_hip(p, 3000)).socket);
  EXPECT_EQ(report.degenerate_faces + report.flipped_faces + report.non_manifold_edges, 0U);
  EXPECT_GT(report.volume.value(), 0.0);
}

TEST_P(HipPreset, TheLeftHipIsTheMirrorImage) {
  HipParameters p = hip_preset(GetParam());
  p.side = Side::right;
  const Hip right = make_hip(p, 1000);
  p.side = Side::left;
  const Hip left = make_hip(p, 1000);
  for (TriangleMesh Hip::*of : {&Hip::ball, &Hip::socket}) {
    ASSERT_EQ((left.*of).vertices.size(), (right.*of).vertices.size());
    for (std::size_t i = 0; i < (left.*of).vertices.size(); ++i) {
      const Vec3& v = (right.*of).vertices[i];
      EXPECT_EQ((left.*of).vertices[i], Vec3(-v.x(), v.y(), v.z()));
    }
  }
  EXPECT_DOUBLE_EQ(validate(left.ball).volume.value(), validate(right.ball).volume.value());
}

INSTANTIATE_TEST_SUITE_P(Every, HipPreset, testing::ValuesIn(hip_preset_names()),
                         [](const auto& name) { return std::string(name.param); });

TEST(Hip, TooFewFacesAreRefused) { EXPECT_THROW(make_hip({}, kFewestHipFaces - 1), std::invalid_argument); }

TEST(Hip, UnknownPresetsAreRefused) { EXPECT_THROW(hip_preset("coxa"), std::invalid_argument); }

TEST(Hip, ParametersAreSetByName) {
  HipParameters p;
  set_hip_parameter(p, "cam_height=3.5");
  set_hip_parameter(p, "side=left");
  EXPECT_EQ(p.cam_height, 3.5);
  EXPECT_EQ(p.side, Side::left);
  for (const char* wrong : {"cam_height", "cam_height=", "cam_height=3mm", "cam=3", "side=up", "=3",
                            "cam_height=nan", "cam_height=-1", "half_opening=181", "joint_space=0"}) {
    EXPECT_THROW(set_hip_parameter(p, wrong), std::invalid_argument) << wrong;
  }
  EXPECT_EQ(p.cam_height, 3.5);
}

// Every parameter is in the list: one that is not keeps its value when all of the list are changed.
TEST(Hip, TheListHoldsEveryParameter) {
  static_assert(sizeof(HipParameters) == (kHipParameters + 1) * sizeof(double));
  for (const HipParameter& parameter : hip_parameter_list()) {
    const double standard = HipParameters{}.*parameter.value;
    EXPECT_LE(parameter.least, standard) << parameter.name;
    EXPECT_GE(parameter.most, standard) << parameter.name;
  }
}

// Each impossible hip, and the parameter that the message names.
struct Impossible {
  const char* change;
  const char* named;
};

class ImpossibleHip : public testing::TestWithParam<Impossible> {};

TEST_P(ImpossibleHip, IsRefusedByName) {
  HipParameters p;
  std::string changes = GetParam().change;
  const std::string message = test::thrown<std::invalid_argument>([&] {
    for (std::size_t at = 0; at < changes.size();) {
      const std::size_t end = std::min(changes.find(' ', at), changes.size());
      set_hip_parameter(p, changes.substr(at, end - at));
      at = end + 1;
    }
    make_hip(p, 1000);
  });
  EXPECT_NE(message.find(std::string("parameter ") + GetParam().named), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_NE(message.find(';'), std::string::npos) << message;  // reason; cure
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImpossibleHip,
    testing::Values(
        Impossible{"cam_height=6 cam_polar=115", "cam_height"},
        Impossible{"half_opening=190", "half_opening"}, Impossible{"wall_thickness=-1", "wall_thickness"},
        Impossible{"joint_space=-0.5", "joint_space"},
        Impossible{"joint_space=1 shift_superior=-2", "joint_space"},
        Impossible{"half_opening=120 inclination=15", "joint_space"},
        Impossible{"head_neck_offset=24", "head_neck_offset"},
        Impossible{"head_neck_offset=0", "head_neck_offset"}, Impossible{"neck_fillet=12", "neck_fillet"},
        Impossible{"neck_length=30", "neck_length"}, Impossible{"conchoid_a=20", "conchoid_b"},
        Impossible{"conchoid_a=17 conchoid_b=18", "conchoid_a"}, Impossible{"head_radius=0", "head_radius"},
        Impossible{"half_opening=50 lateral_centre_edge=70 inclination=85", "lateral_centre_edge"},
        Impossible{"half_opening=120 pincer_height=15 pincer_clock=4", "pincer_height"},
        Impossible{"aiis_height=10 aiis_distance=2", "aiis_height"},
        Impossible{"greater_trochanter_width=60 greater_trochanter_tip=20 greater_trochanter_offset=25",
                   "greater_trochanter_width"},
        Impossible{"lesser_trochanter_height=21", "lesser_trochanter_height"}),
    [](const auto& hip) { return "No" + std::to_string(hip.index); });

// The stand-ins for the thesis' patients: at the ends of the motions of Table 11 the zones with less than 2
// mm between the bones ("red", Section 5.2) lie where Tables 12 and 13 report them, and the motions that the
// text names have the smallest gaps.

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
