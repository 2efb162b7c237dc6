// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: the bytes of the file are the header below and the doubles of the mesh and its values, bit for
// bit.
#include "mesh/ply_writer.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/io.hpp"
#include "support/mesh_files.hpp"
#include "support/temporary_folder.hpp"

namespace impinge {
namespace {

using test::contents;
using test::TemporaryFolder;

// This machine is little-endian, as the file.
template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(WritePly, HeaderAndRecordsOfAValueWithColours) {
  const TemporaryFolder folder;
  const TriangleMesh mesh{{{0.1, -2.0, 3e300}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::vector<double> gaps{-0.25, kNan, 1.0 / 3.0};
  const std::vector<Rgb> colours{{255, 0, 7}, {1, 2, 3}, {4, 5, 6}};
  write_ply(folder.path() / "a.ply", mesh, "gap", gaps, colours);
  const std::string bytes = contents(folder.path() / "a.ply");
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment lengths in millimetres\nelement vertex 3\nproperty "
      "double x\n"
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
  const TemporaryFolder folder;
  const TriangleMesh mesh = octahedron(25.0);
  write_ply(folder.path() / "a.ply", mesh, "gap", std::vector<double>(6, kNan));
  write_ply(folder.path() / "b.ply", mesh, "gap", std::vector<double>(6, 1.0), std::vector<Rgb>(6));
  write_ply(folder.path() / "c.ply", mesh);
  for (const char* name : {"a.ply", "b.ply", "c.ply"}) {
    const TriangleMesh read = read_mesh(folder.path() / name);
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.faces, mesh.faces);
  }
}

TEST(WritePly, AnEmptyMeshHasAHeader) {
  const TemporaryFolder folder;
  write_ply(folder.path() / "a.ply", {}, "gap", {});
  EXPECT_NE(contents(folder.path() / "a.ply").find("element vertex 0\n"), std::string::npos);
}

TEST(WritePly, RefusesWrongArgumentsAndWritesNothing) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.ply";
  TriangleMesh mesh = octahedron(1.0);
  const std::vector<double> six(6, 0.0);
  EXPECT_THROW(write_ply(file, mesh, "gap", std::vector<double>(5)), std::invalid_argument);
  EXPECT_THROW(write_ply(file, mesh, "gap", six, std::vector<Rgb>(7)), std::invalid_argument);
  for (const char* name : {"", "x", "quality", "red", "two words", "line\nend"}) {
    EXPECT_THROW(write_ply(file, mesh, name, six), std::invalid_argument) << name;
  }
  mesh.faces[0][0] = 6;
  EXPECT_THROW(write_ply(file, mesh), FileError);
  EXPECT_THROW(write_ply(folder.path() / "none" / "a.ply", octahedron(1.0)), FileError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace impinge
