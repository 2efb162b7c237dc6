// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: two reaches of which all of one is more than five times all of the other are in different units,
// and so are two whose radii differ by as much where they face each other; a ball with a radius of less than
// 5 mm or more than 50 is doubtful.
#include "hip/length_unit.hpp"

#include <cmath>

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
  EXPECT_EQ(different_units({24.0, 25.0}, {25.5, 40.0}, NAN), "");
  EXPECT_EQ(different_units({20.0, 450.0}, {25.0, 40.0}, NAN), "");  // a whole femur
  EXPECT_EQ(different_units({24.0, 25.0}, {24.0, 180.0}, NAN), "");  // a whole pelvis
  EXPECT_EQ(different_units({1.0, 10.0}, {50.0, 60.0}, NAN), "");    // five times, and not more
  EXPECT_EQ(different_units({50.0, 60.0}, {1.0, 10.0}, NAN), "");
}

TEST(LengthUnit, FactorsBetweenUnitsDoNot) {
  for (const double factor : {1e-6, 1e-3, 0.1, 10.0, 1e3, 1e6}) {
    const std::string found = different_units({24.0 * factor, 25.0 * factor}, {25.5, 40.0}, NAN);
    EXPECT_NE(found.find("check that both meshes are in mm"), std::string::npos) << factor << found;
  }
}

TEST(LengthUnit, RadiiThatDifferWhereTheyFaceEachOtherDoNot) {
  const Reach femur{2.2, 45.0};
  const Reach pelvis{25.5, 180.0};
  for (const double ratio : {0.21, 1.1, 4.9}) EXPECT_EQ(different_units(femur, pelvis, ratio), "") << ratio;
  for (const double ratio : {0.1, 10.0}) EXPECT_NE(different_units(femur, pelvis, ratio), "") << ratio;
}

TEST(LengthUnit, SizesThatNoJointHasAreDoubtful) {
  for (const double radius : {5.0, 8.0, 25.0, 50.0, std::nan("")})
    EXPECT_EQ(doubtful_unit(radius), "") << radius;
  for (const double radius : {0.025, 2.5, 4.99, 50.1, 25000.0})
    EXPECT_NE(doubtful_unit(radius).find("lengths are read as mm"), std::string::npos) << radius;
}

}  // namespace
}  // namespace impinge
