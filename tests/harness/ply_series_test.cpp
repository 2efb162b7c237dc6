// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: x y z and the states of each vertex as float32, bit for bit, behind the header below.
#include "harness/ply_series.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/io.hpp"
#include "support/temporary_folder.hpp"

namespace impinge::lab {
namespace {

using test::TemporaryFolder;

const TriangleMesh kTriangle{{{0.5, -2.0, 4.0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

TEST(PlySeries, HoldsEveryStateOfEveryVertexInTheirOrder) {
  const TemporaryFolder folder;
  const float none = std::numeric_limits<float>::quiet_NaN();
  write_ply_series(folder.path() / "a.ply", kTriangle,
                   std::vector<VertexSeries>{{"gap_0", {1.0F, 2.0F, 3.0F}}, {"gap_1", {-1.5F, none, 0.25F}}});
  std::ostringstream text;
  text << std::ifstream(folder.path() / "a.ply", std::ios::binary).rdbuf();
  const std::string bytes = text.str();
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment lengths in millimetres\nelement vertex 3\n"
      "property float x\nproperty float y\nproperty float z\nproperty float gap_0\nproperty float gap_1\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  ASSERT_EQ(bytes.size(), header.size() + 3 * 5 * 4 + 13);
  float first[5];
  float second[5];
  std::memcpy(first, bytes.data() + header.size(), sizeof first);
  std::memcpy(second, bytes.data() + header.size() + sizeof first, sizeof second);
  EXPECT_EQ(first[0], 0.5F);
  EXPECT_EQ(first[2], 4.0F);
  EXPECT_EQ(first[3], 1.0F);
  EXPECT_EQ(first[4], -1.5F);
  EXPECT_EQ(second[3], 2.0F);
  EXPECT_TRUE(std::isnan(second[4]));
}

TEST(PlySeries, IsAMeshForEveryReader) {
  const TemporaryFolder folder;
  write_ply_series(folder.path() / "a.ply", kTriangle, std::vector<VertexSeries>{{"gap_0", {1, 2, 3}}});
  const TriangleMesh read = read_mesh(folder.path() / "a.ply");
  EXPECT_EQ(read.vertices, kTriangle.vertices);
  EXPECT_EQ(read.faces, kTriangle.faces);
}

TEST(PlySeries, RefusesStatesThatDoNotFit) {
  const TemporaryFolder folder;
  const auto refused = [&](std::vector<VertexSeries> states) {
    EXPECT_THROW(write_ply_series(folder.path() / "a.ply", kTriangle, states), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.ply"));
  };
  refused({{"gap_0", {1, 2}}});
  refused({{"", {1, 2, 3}}});
  refused({{"gap 0", {1, 2, 3}}});
  refused({{"x", {1, 2, 3}}});
  refused({{"gap_0", {1, 2, 3}}, {"gap_0", {1, 2, 3}}});
}

}  // namespace
}  // namespace impinge::lab
