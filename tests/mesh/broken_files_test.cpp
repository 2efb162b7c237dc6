// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: for any bytes, read_mesh returns a mesh whose indices exist and whose coordinates are finite, or
// throws FileError with one line "FILE: reason; advice". No proper prefix of a file is taken for the
// file.
#include <algorithm>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/io.hpp"
#include "mesh/validation.hpp"
#include "support/mesh_files.hpp"
#include "support/temporary_folder.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

// The message behind "FILE: ", or nothing when the file was read. Checks the form of the message.
std::optional<std::string> refusal(const fs::path& file) {
  try {
    read_mesh(file);
    return std::nullopt;
  } catch (const FileError& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with(file.string() + ": ")) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_NE(what.find("; "), std::string::npos) << what;
    return what.substr(file.string().size() + 2);
  }
}

void expect_refused(const fs::path& file, const std::string& reason) {
  const std::optional<std::string> message = refusal(file);
  ASSERT_TRUE(message) << file << " was read";
  EXPECT_NE(message->find(reason), std::string::npos) << *message;
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

TEST(BrokenFile, MissingFolderAndDevice) {
  const TemporaryFolder folder;
  expect_refused(folder.path() / "none.ply", "there is no such file");
  expect_refused(folder.path() / "none" / "none.ply", "there is no such file");
  fs::create_directory(folder.path() / "folder.ply");
  expect_refused(folder.path() / "folder.ply", "is a folder");
  fs::create_symlink("/dev/zero", folder.path() / "zero.stl");
  expect_refused(folder.path() / "zero.stl", "is not a regular file");
}

TEST(BrokenFile, UnknownExtension) {
  const TemporaryFolder folder;
  expect_refused(folder.write("mesh.xyz", "1 2 3\n"), "unknown extension '.xyz'");
  expect_refused(folder.write("mesh", "1 2 3\n"), "has no extension");
}

TEST(BrokenFile, EmptyTextAndPicture) {
  const TemporaryFolder folder;
  const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x10\0\0\0\x10\x08\x02\0\0\0", 29);
  for (const char* name : {"e.ply", "e.stl", "e.obj", "e.off"}) {
    expect_refused(folder.write(name, ""), "is empty");
    EXPECT_TRUE(refusal(folder.write(name, "\n"))) << name;
    EXPECT_TRUE(refusal(folder.write(name, "Dear reader,\nthis is no mesh.\nYours, v f 1 2 3\n"))) << name;
    EXPECT_TRUE(refusal(folder.write(name, png))) << name;
    EXPECT_TRUE(refusal(folder.write(name, png + std::string(500, 'x')))) << name;
  }
}

TEST(BrokenFile, MessageStaysOneLineWhateverTheNameAndTheHeader) {
  const TemporaryFolder folder;
  try {
    read_mesh(folder.write("a\nb.ply", "ply\nformat\tmorse 1.0\x1b[2J\n"));
    FAIL() << "was read";
  } catch (const FileError& error) {
    EXPECT_TRUE(std::ranges::none_of(std::string(error.what()), [](unsigned char c) { return c < 0x20; }));
  }
}

const TriangleMesh kTetrahedron{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};

// Cut at every byte: the last number has one digit, so only the final line end may go.
TEST(BrokenFile, EveryPrefixOfASmallFileIsRefused) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : samples(kTetrahedron)) {
    const std::string_view all = bytes;
    ASSERT_FALSE(refusal(folder.write(name, all))) << name;
    if (name == std::string("mesh.obj")) continue;  // see the next test
    std::size_t whole = all.size();
    if (name == std::string("ascii.stl")) whole = all.rfind("endsolid") + 8;
    if (name == std::string("ascii.ply") || name == std::string("mesh.off")) whole = all.size() - 1;
    for (std::size_t size = 0; size < whole; ++size) {
      EXPECT_TRUE(refusal(folder.write(name, all.substr(0, size)))) << name << " cut at " << size;
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
    if (refusal(file)) {
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
    if (name == std::string("mesh.obj")) continue;
    for (std::size_t k = 1; k < 100; ++k) {
      for (std::size_t size = bytes.size() * k / 100 - 1, end = size + 3; size < end; ++size) {
        EXPECT_THROW(parse_mesh(name, bytes.substr(0, size)), FileError) << name << ' ' << size;
      }
    }
  }
}

TEST(BrokenFile, AFileBeyondTheLimitIsRefusedBeforeItIsRead) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("sparse.stl", "solid");
  fs::resize_file(file, kMostMeshBytes + 1);
  expect_refused(file, "has 4294967297 bytes, more than the 4294967296 that are read");
}

TEST(BrokenFile, NoBytesAreNoMesh) {
  for (const char* name : {"e.ply", "e.stl", "e.obj", "e.off"})
    EXPECT_THROW(parse_mesh(name, ""), FileError) << name;
}

// A cut leaves the header's promise: the message names what is missing.
TEST(BrokenFile, SaysWhereItEnds) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = octahedron(1.0);
  const std::string ply = test::binary_ply(mesh);
  expect_refused(folder.write("a.ply", ply.substr(0, ply.size() - 1)), "face 7 of the 8 declared");
  const std::string text = test::off(mesh);
  expect_refused(folder.write("a.off", text.substr(0, 20)), "vertex 1 of the 6 declared");
  const std::string stl = test::binary_stl(mesh);
  expect_refused(folder.write("a.stl", stl.substr(0, 484 - 50)),
                 "it has 434 bytes, its header declares 8 triangles");
}

TEST(BrokenFile, HugeDeclaredCountsAreRefusedBeforeAnythingIsAllocated) {
  const TemporaryFolder folder;
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    expect_refused(folder.write("v.ply", test::ply_header(format, 4000000000U, 1) + std::string(100, '1')),
                   "vertex");
    expect_refused(
        folder.write("w.ply", test::ply_header(format, 9000000000000000000U, 1) + std::string(24, '1')),
        "vertex");
    expect_refused(folder.write("x.ply", test::ply_header(format, 18446744073709551615U, 1)),
                   "header has the line");
  }
  expect_refused(
      folder.write("f.ply", test::ply_header("ascii", 3, 4000000000U) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
      "face 1 of");
  std::string stl = test::binary_stl(octahedron(1.0));
  for (std::size_t k = 80; k < 84; ++k) stl[k] = '\xff';
  expect_refused(folder.write("n.stl", stl), "declares 4294967295 triangles");
  expect_refused(folder.write("v.off", "OFF\n4000000000 1 0\n0 0 0\n"), "vertex 1 of");
  expect_refused(folder.write("f.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "face 1 of");
  // A list of 4e9 corners.
  std::string list =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uint uint vertex_indices\nend_header\n";
  expect_refused(
      folder.write("l.ply", list + std::string(12, '\0') + "\xff\xff\xff\xff" + std::string(40, '\0')),
      "face 0 of");
}

TEST(BrokenFile, PointsAloneAreNoSurface) {
  const TemporaryFolder folder;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  expect_refused(folder.write("a.ply", vertices + "end_header\n" + points), "has no faces");
  expect_refused(folder.write("b.ply", test::ply_header("ascii", 3, 0) + points), "has no faces");
  expect_refused(folder.write("c.ply", test::ply_header("ascii", 3, 1) + points + "2 0 1\n"), "has no faces");
  expect_refused(folder.write("a.off", "OFF\n3 0 0\n" + points), "has no faces");
  expect_refused(folder.write("b.off", "OFF\n3 1 0\n" + points + "2 0 1\n"), "has no faces");
  expect_refused(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "has no faces");
  expect_refused(folder.write("a.stl", test::binary_stl({})), "has no faces");
  expect_refused(folder.write("b.stl", "solid nothing\nendsolid nothing\n"), "has no faces");
}

TEST(BrokenFile, CoordinatesMustBeFinite) {
  const TemporaryFolder folder;
  for (const char* bad : {"nan", "NaN", "inf", "-inf", "1e39", "-1e400"}) {
    std::string body = "0 0 ";
    body.append(bad).append("\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_TRUE(refusal(folder.write("a.ply", test::ply_header("ascii", 3, 1) + body))) << bad;
    EXPECT_TRUE(refusal(folder.write("a.off", "OFF\n3 1 0\n" + body))) << bad;
    std::string text = "v 1 0 0\nv 0 1 0\nv 0 0 ";
    text.append(bad).append("\nf 1 2 3\n");
    EXPECT_TRUE(refusal(folder.write("a.obj", text))) << bad;
  }
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    TriangleMesh mesh = octahedron(1.0);
    mesh.vertices[3].y() = bad;
    expect_refused(folder.write("b.ply", test::binary_ply(mesh)), "NaN, infinite");
    expect_refused(folder.write("b.stl", test::binary_stl(mesh)), "NaN, infinite");
  }
}

TEST(BrokenFile, CoordinatesMustBeNumbers) {
  const TemporaryFolder folder;
  expect_refused(folder.write("a.ply", test::ply_header("ascii", 3, 1) + "0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n"),
                 "vertex 0");
  expect_refused(folder.write("a.off", "OFF\n3 1 0\n0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n"), "vertex 0");
  expect_refused(folder.write("a.obj", "v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "line 1");
  expect_refused(folder.write("a.stl",
                              "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\nvertex 1 0 0\n"
                              "vertex 0 1 0\nendloop\nendfacet\nendsolid\n"),
                 "facet 0");
}

TEST(BrokenFile, IndicesMustExist) {
  const TemporaryFolder folder;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  for (const char* bad : {"3 0 1 3", "3 0 1 -1", "3 0 1 4294967296", "3 0 1 1.5", "4 0 1 2 3", "-3 0 1 2"}) {
    EXPECT_TRUE(refusal(folder.write("a.ply", test::ply_header("ascii", 3, 1) + points + bad + '\n'))) << bad;
    EXPECT_TRUE(refusal(folder.write("a.off", "OFF\n3 1 0\n" + points + bad + '\n'))) << bad;
  }
  for (const char* bad :
       {"f 1 2 4", "f 1 2 0", "f 1 2 -4", "f 1 2", "f 1 2 x", "f 1 2 99999999999999999999"}) {
    const std::string text = std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + bad + '\n';
    EXPECT_TRUE(refusal(folder.write("a.obj", text))) << bad;
  }
  TriangleMesh mesh = octahedron(1.0);
  mesh.faces[5][1] = 6;
  expect_refused(folder.write("b.ply", test::binary_ply(mesh)), "face 5 names a vertex that is not there");
}

TEST(BrokenFile, OnlyDegenerateFaces) {
  const TemporaryFolder folder;
  TriangleMesh line{{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {4, 4, 4}}, {{0, 1, 2}, {1, 2, 3}, {2, 2, 3}}};
  for (const auto& [name, bytes] : samples(line)) expect_refused(folder.write(name, bytes), "has an area");
  const TriangleMesh one_point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}};
  for (const auto& [name, bytes] : samples(one_point))
    expect_refused(folder.write(name, bytes), "has an area");
}

TEST(BrokenFile, HeadersThatMakeNoSense) {
  const TemporaryFolder folder;
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string list = "property list uchar int vertex_indices\n";
  const std::string body = "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string begin = "ply\nformat ascii 1.0\n";
  const auto expect = [&](const std::string& header, const std::string& reason) {
    expect_refused(folder.write("h.ply", header + body), reason);
  };
  expect(begin + "element vertex 3\n" + xyz + "element vertex 3\n" + xyz + "element face 1\n" + list,
         "'element vertex 3'");
  expect(begin + "element vertex 3\nelement face 1\n" + list, "no properties");
  expect(begin + "element vertex 3\nproperty float x\nproperty float y\nelement face 1\n" + list,
         "x, y and z");
  expect(begin + "element face 1\n" + list + "element vertex 3\n" + xyz, "before the vertices");
  expect(begin + "element vertex 3\n" + xyz + "element face 1\nproperty int vertex_indices\n", "no list");
  expect(begin + "element vertex -3\n" + xyz + "element face 1\n" + list, "'element vertex -3'");
  expect(begin + "element vertex 3\nproperty quad x\n", "'property quad x'");
  expect(begin + xyz, "'property float x'");
  expect("ply\nelement vertex 3\n" + xyz + "element face 1\n" + list, "no format");
  expect_refused(folder.write("b.off", "OFF BINARY\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "binary OFF");
  expect_refused(folder.write("c.off", "4OFF\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n"),
                 "does not begin with OFF");
}

// What assimp cannot read is refused, not left out.
TEST(BrokenFile, WhatAssimpLeavesOut) {
  const TemporaryFolder folder;
  const std::string camera =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element camera 1\nproperty float angle\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0\n1 0 0\n0 1 0\n30\n3 0 1 2\n";
  expect_refused(folder.write("a.ply", camera), "could not be read right");
  std::string decagon = "OFF\n10 1 0\n";
  for (const double t : {0.0, 0.6, 1.2, 1.8, 2.5, 3.1, 3.7, 4.3, 5.0, 5.6}) {
    decagon += std::to_string(std::cos(t)) + ' ' + std::to_string(std::sin(t)) + " 0\n";
  }
  expect_refused(folder.write("a.off", decagon + "10 0 1 2 3 4 5 6 7 8 9\n"), "only 0 of its 1 faces");
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
