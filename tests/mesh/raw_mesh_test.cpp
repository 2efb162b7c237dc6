// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/raw_mesh.hpp"

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "files/file_error.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

// A tetrahedron.
const std::vector<double> kPoints{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<std::uint32_t> kCorners{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

std::string refusal(const std::vector<double>& points, const std::vector<std::uint32_t>& corners) {
  return test::thrown<FileError>([&] { mesh_of("bone.stl", {points, corners}); });
}

TEST(RawMesh, KeepsPointsAndFacesInTheirOrder) {
  const TriangleMesh mesh = mesh_of("bone.stl", {kPoints, kCorners});
  ASSERT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.vertices[3], Vec3(0, 0, 1));
  ASSERT_EQ(mesh.faces.size(), 4U);
  EXPECT_EQ(mesh.faces[1], (Face{0, 1, 3}));
}

// Faces without shared points become the same mesh, its points in the order of their first use.
TEST(RawMesh, WeldsASoup) {
  std::vector<double> soup;
  for (const std::uint32_t v : kCorners)
    for (std::size_t k = 0; k < 3; ++k) soup.push_back(kPoints[3 * v + k]);
  const TriangleMesh mesh = mesh_of("bone.stl", {soup, {}});
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.vertices[1], Vec3(0, 1, 0));
  EXPECT_EQ(mesh.faces.size(), 4U);
}

TEST(RawMesh, SaysWhatCannotBeUsed) {
  EXPECT_EQ(refusal({}, {}), "bone.stl: has no faces, only points; triangulate the surface first");
  EXPECT_NE(refusal({0, 0}, {}).find("ends within a point or a face"), std::string::npos);
  EXPECT_NE(refusal(kPoints, {0, 1}).find("ends within a point or a face"), std::string::npos);
  EXPECT_NE(refusal(kPoints, {0, 1, 4}).find("names a vertex that is not there"), std::string::npos);
  EXPECT_NE(refusal(kPoints, {0, 1, 1}).find("none of its faces has an area"), std::string::npos);
  std::vector<double> lost = kPoints;
  lost[4] = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(lost, kCorners).find("1 vertex has coordinates that are NaN"), std::string::npos);
}

}  // namespace
}  // namespace impinge
