// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: two reaches of which all of one is more than five times all of the other are in different units;
// a ball of less than 0.1 mm or more than 1 m is doubtful.
#include "joint/length_unit.hpp"

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge {
namespace {

TEST(LengthUnit, ReachIsThatOfCornersOfFaces) {
  TriangleMesh mesh = octahedron(2.0);
  for (Vec3& v : mesh.vertices) v.z() += 1.0;
  mesh.vertices.emplace_back(100.0, 0.0, 0.0);  // of no face
  const Reach reach = reach_of(mesh);
  EXPECT_DOUBLE_EQ(reach.nearest, 1.0);
  EXPECT_DOUBLE_EQ(reach.farthest, 3.0);
}

TEST(LengthUnit, JointsOfOneUnitPass) {
  EXPECT_EQ(different_units({24.0, 25.0}, {25.5, 40.0}), "");
  EXPECT_EQ(different_units({20.0, 450.0}, {25.0, 40.0}), "");  // a whole femur
  EXPECT_EQ(different_units({24.0, 25.0}, {24.0, 180.0}), "");  // a whole pelvis
  EXPECT_EQ(different_units({1.0, 10.0}, {50.0, 60.0}), "");    // five times, and not more
  EXPECT_EQ(different_units({50.0, 60.0}, {1.0, 10.0}), "");
}

TEST(LengthUnit, FactorsBetweenUnitsDoNot) {
  for (const double factor : {1e-6, 1e-3, 0.1, 10.0, 1e3, 1e6}) {
    const std::string found = different_units({24.0 * factor, 25.0 * factor}, {25.5, 40.0});
    EXPECT_NE(found.find("check that both meshes are in mm"), std::string::npos) << factor << found;
  }
}

TEST(LengthUnit, SizesThatNoJointHasAreDoubtful) {
  for (const double radius : {0.1, 0.6, 25.0, 1000.0})
    EXPECT_EQ(doubtful_unit({radius, radius}), "") << radius;
  for (const double radius : {0.025, 0.0999, 1000.1, 25000.0})
    EXPECT_NE(doubtful_unit({radius, radius}).find("lengths are read as mm"), std::string::npos) << radius;
}

}  // namespace
}  // namespace impinge
