// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: for any bytes, read_mesh returns a mesh whose indices exist and whose coordinates are finite, or
// throws FileError with one line "FILE: reason; advice". No proper prefix of a file is taken for the
// file. (What is said of which fault: tests/e2e/bad_meshes.py.)
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/io.hpp"
#include "mesh/validation.hpp"
#include "support/mesh_files.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

// Whether the file is refused. Checks the form of the message.
bool is_refused(const fs::path& file) {
  const std::string what = test::thrown<FileError>([&] { read_mesh(file); });
  if (what.empty()) return false;
  EXPECT_TRUE(what.starts_with(file.string() + ": ")) << what;
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  EXPECT_NE(what.find("; "), std::string::npos) << what;
  return true;
}

struct Sample {
  const char* name;
  std::string bytes;
};

std::vector<Sample> samples(const TriangleMesh& mesh) {
  return {{"binary.ply", test::binary_ply(mesh)}, {"ascii.ply", test::ascii_ply(mesh)},
          {"binary.stl", test::binary_stl(mesh)}, {"ascii.stl", test::ascii_stl(mesh)},
          {"mesh.off", test::off(mesh)},          {"mesh.obj", test::obj(mesh)}};
}

TEST(BrokenFile, MessageStaysOneLineWhateverTheNameAndTheHeader) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a\nb.ply", "ply\nformat\tmorse 1.0\x1b[2J\n");
  const std::string what = test::thrown<FileError>([&] { read_mesh(file); });
  EXPECT_NE(what, "");
  EXPECT_TRUE(std::ranges::none_of(what, [](unsigned char c) { return c < 0x20; }));
}

const TriangleMesh kTetrahedron{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};

// Cut at every byte: the last number has one digit, so only the final line end may go.
TEST(BrokenFile, EveryPrefixOfASmallFileIsRefused) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : samples(kTetrahedron)) {
    const std::string_view all = bytes;
    ASSERT_FALSE(is_refused(folder.write(name, all))) << name;
    if (name == std::string("mesh.obj")) continue;  // see the next test
    std::size_t whole = all.size();
    if (name == std::string("ascii.stl")) whole = all.rfind("endsolid") + 8;
    if (name == std::string("ascii.ply") || name == std::string("mesh.off")) whole = all.size() - 1;
    for (std::size_t size = 0; size < whole; ++size) {
      EXPECT_TRUE(is_refused(folder.write(name, all.substr(0, size)))) << name << " cut at " << size;
    }
  }
}

// OBJ declares no counts. A cut is refused or leaves complete lines only: fewer faces of the same mesh, not
// closed.
TEST(BrokenFile, EveryPrefixOfAnObjFileIsRefusedOrASmallerOpenMesh) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = sphere(10.0, 20);
  const std::string bytes = test::obj(mesh);
  std::size_t refused = 0;
  for (std::size_t size = 0; size + 1 < bytes.size(); ++size) {
    const fs::path file = folder.write("cut.obj", std::string_view(bytes).substr(0, size));
    if (is_refused(file)) {
      ++refused;
      continue;
    }
    const auto lines =
        static_cast<std::size_t>(std::count(bytes.begin(), bytes.begin() + static_cast<long>(size), '\n'));
    const std::size_t complete = lines - mesh.vertices.size() + (bytes[size - 1] == '\n' ? 0 : 1);
    const TriangleMesh part = read_mesh(file);
    EXPECT_EQ(part.faces.size(), complete) << "cut at " << size;
    EXPECT_FALSE(complete < mesh.faces.size() && validate(part).closed()) << "cut at " << size;
  }
  EXPECT_GT(refused, bytes.size() - 80);
}

// OBJ aside: see the test before.
TEST(BrokenFile, LargerFilesAreRefusedAtEveryHundredthAndAByteMoreOrLess) {
  for (const auto& [name, bytes] : samples(sphere(25.0, 300))) {
    EXPECT_THROW(parse_mesh(name, ""), FileError) << name;
    if (name == std::string("mesh.obj")) continue;
    for (std::size_t k = 1; k < 100; ++k) {
      for (std::size_t size = bytes.size() * k / 100 - 1, end = size + 3; size < end; ++size) {
        EXPECT_THROW(parse_mesh(name, bytes.substr(0, size)), FileError) << name << ' ' << size;
      }
    }
  }
}

// Any damage: five hundred seeded changes of a few bytes a format. What is read must still be a mesh.
TEST(BrokenFile, RandomDamageIsRefusedOrReadAsAMesh) {
  const TemporaryFolder folder;
  std::mt19937 random(20240817);
  std::size_t refused = 0;
  for (const auto& [name, bytes] : samples(octahedron(2.0))) {
    for (int round = 0; round < 500; ++round) {
      std::string damaged = bytes;
      for (int k = 0; k < 1 + round % 4; ++k)
        damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      try {
        const MeshReport report = validate(read_mesh(folder.write(name, damaged)));
        EXPECT_EQ(report.invalid_faces, 0U);
        EXPECT_EQ(report.non_finite_vertices, 0U);
        EXPECT_LT(report.degenerate_faces, report.faces);
      } catch (const FileError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 500U);
}

}  // namespace
}  // namespace impinge
