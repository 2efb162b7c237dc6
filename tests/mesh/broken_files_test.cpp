// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: no proper prefix of a file is taken for the file: read_mesh throws FileError with one line "FILE:
// reason; advice". (What is said of which fault: tests/e2e/bad_meshes.py; any damage:
// tests/fuzz/read_mesh.cpp.)
#include <algorithm>

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
  return {{"binary.ply", test::binary_ply(mesh)},  {"ascii.ply", test::ascii_ply(mesh)},
          {"binary.stl", test::binary_stl(mesh)},  {"ascii.stl", test::ascii_stl(mesh)},
          {"mesh.off", test::off(mesh)},           {"mesh.obj", test::obj(mesh)},
          {"ascii.vtp", test::vtp(mesh)},          {"ascii.vtk", test::vtk(mesh)},
          {"mesh.vtp", mesh_bytes("a.vtp", mesh)}, {"mesh.vtk", mesh_bytes("a.vtk", mesh)}};
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
    for (const char* kind : {"ascii.ply", "mesh.off", "ascii.vtk", "mesh.vtk", "ascii.vtp", "mesh.vtp"})
      if (name == std::string(kind)) whole = all.size() - 1;
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

}  // namespace
}  // namespace impinge
