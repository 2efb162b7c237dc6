// SPDX-License-Identifier: GPL-3.0-or-later
// 2^-100 mm <= largest coordinate of a face <= 2^100 mm, or 0; else one line that says which face.
#include "mesh/lengths.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

std::string refusal(const TriangleMesh& mesh) {
  return test::thrown<std::invalid_argument>([&] { require_lengths(mesh); });
}

TEST(Lengths, FromTheLeastToTheMostAreTaken) {
  for (const double radius : {kLeastLength, 1e-20, 1.0, 26.0, 1e20, kMostLength})
    EXPECT_EQ(refusal(octahedron(radius)), "") << radius;
}

TEST(Lengths, BeyondAreRefusedInOneLine) {
  for (const double radius : {0.5 * kLeastLength, 1e-300, 2.0 * kMostLength, 1e300}) {
    const std::string text = refusal(octahedron(radius));
    EXPECT_NE(text.find("face 0 reaches"), std::string::npos) << radius << ": " << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
  }
}

// The sum of three coordinates may be long enough where none of them is.
TEST(Lengths, CornersThatAreLongInSumAloneAreRefused) {
  TriangleMesh mesh;
  const double share = 0.9 * kLeastLength;
  mesh.vertices = {{share, share, share}, {-share, share, share}, {share, -share, share}};
  mesh.faces = {{0, 1, 2}};
  EXPECT_NE(refusal(mesh).find("face 0 reaches"), std::string::npos) << refusal(mesh);
}

TEST(Lengths, EveryCoordinateOfEveryCornerCounts) {
  for (std::size_t k = 0; k < 9; ++k) {
    TriangleMesh mesh{{{20, 1, 2}, {1, 20, 2}, {1, 2, 20}}, {{0, 1, 2}}};
    mesh.vertices[k / 3][static_cast<Eigen::Index>(k % 3)] = -2.0 * kMostLength;
    EXPECT_NE(refusal(mesh).find("face 0 reaches"), std::string::npos) << k << ": " << refusal(mesh);
  }
}

// In floats fewer lengths are taken, and they are named.
TEST(Lengths, OfFloatsAreFewer) {
  for (const double radius : {kLeastFloatLength, 26.0, kMostFloatLength})
    EXPECT_NO_THROW(require_float_lengths(octahedron(radius))) << radius;
  for (const double radius : {0.5 * kLeastFloatLength, 2.0 * kMostFloatLength}) {
    EXPECT_EQ(refusal(octahedron(radius)), "") << radius;
    EXPECT_THROW(require_float_lengths(octahedron(radius)), std::invalid_argument) << radius;
  }
}

TEST(Lengths, NumbersThatAreNoneAreRefused) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = octahedron(26.0);
    mesh.vertices[3].y() = bad;
    EXPECT_NE(refusal(mesh).find("face 2 has a corner"), std::string::npos) << refusal(mesh);
  }
}

TEST(Lengths, OfVerticesWithoutFacesAndOfTheCentreAreLeftAlone) {
  TriangleMesh mesh = octahedron(26.0);
  mesh.vertices.emplace_back(std::nan(""), 0.0, 0.0);
  EXPECT_EQ(refusal(mesh), "");
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.faces.push_back({7, 7, 7});
  EXPECT_EQ(refusal(mesh), "");
}

}  // namespace
}  // namespace impinge
