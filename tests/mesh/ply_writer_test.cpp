// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: the bytes of the file are the header below and the doubles of the mesh and its values, bit for
// bit.
#include "mesh/ply_writer.hpp"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/io.hpp"

namespace impinge {
namespace {

// This machine is little-endian, as the file.
template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(WritePly, HeaderAndRecordsOfAValueWithColours) {
  const TriangleMesh mesh{{{0.1, -2.0, 3e300}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::vector<double> gaps{-0.25, kNan, 1.0 / 3.0};
  const std::vector<Rgb> colours{{255, 0, 7}, {1, 2, 3}, {4, 5, 6}};
  const std::string bytes = ply_bytes(mesh, {"LPS", {{"gap", gaps}, {"other", gaps}}, colours});
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment lengths in millimetres\ncomment SPACE=LPS\n"
      "element vertex 3\nproperty double x\n"
      "property double y\nproperty double z\nproperty double gap\nproperty float quality\nproperty float u\n"
      "property float v\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  constexpr std::size_t kRecord = 4 * 8 + 3 * 4 + 3;
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  ASSERT_EQ(bytes.size(), header.size() + 3 * kRecord + 13);
  const std::size_t body = header.size();
  EXPECT_EQ(value_at<double>(bytes, body), 0.1);
  EXPECT_EQ(value_at<double>(bytes, body + 16), 3e300);
  EXPECT_EQ(value_at<double>(bytes, body + 24), -0.25);
  EXPECT_EQ(value_at<float>(bytes, body + 32), -0.25F);
  EXPECT_EQ(value_at<float>(bytes, body + 36), -0.25F);
  EXPECT_EQ(value_at<float>(bytes, body + 40), 0.0F);
  EXPECT_EQ(bytes.substr(body + 44, 3), std::string("\xff\0\x07", 3));
  EXPECT_TRUE(std::isnan(value_at<double>(bytes, body + kRecord + 24)));
  EXPECT_TRUE(std::isnan(value_at<float>(bytes, body + kRecord + 32)));
  EXPECT_EQ(value_at<double>(bytes, body + 2 * kRecord + 24), 1.0 / 3.0);
  EXPECT_EQ(bytes.substr(body + 3 * kRecord), std::string("\x03\0\0\0\0\x01\0\0\0\x02\0\0\0", 13));
}

TEST(WritePly, ReadsBackAsTheSameMesh) {
  const TriangleMesh mesh = octahedron(25.0);
  const std::vector<double> none(6, kNan);
  for (const MeshNotes& notes :
       {MeshNotes{.values = {{"gap", none}}},
        MeshNotes{.values = {{"gap", none}}, .colours = std::vector<Rgb>(6)}, MeshNotes{}}) {
    const TriangleMesh read = parse_mesh("a.ply", ply_bytes(mesh, notes));
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.faces, mesh.faces);
  }
}

TEST(WritePly, AnEmptyMeshHasAHeader) {
  EXPECT_NE(ply_bytes({}).find("element vertex 0\n"), std::string::npos);
}

TEST(WritePly, RefusesWrongArguments) {
  TriangleMesh mesh = octahedron(1.0);
  const std::vector<double> six(6, 0.0);
  EXPECT_THROW(ply_bytes(mesh, {"", {{"gap", std::span(six).first(5)}}, {}}), std::invalid_argument);
  EXPECT_THROW(ply_bytes(mesh, {"", {}, std::vector<Rgb>(7)}), std::invalid_argument);
  for (const char* name : {"", "x", "quality", "red", "two words", "line\nend", "a<b"}) {
    EXPECT_THROW(ply_bytes(mesh, {"", {{name, six}}, {}}), std::invalid_argument) << name;
  }
  mesh.faces[0][0] = 6;
  EXPECT_THROW(ply_bytes(mesh), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
