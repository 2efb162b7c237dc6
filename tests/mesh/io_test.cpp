// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: read_mesh(write_mesh(m)) = m for each format, up to the rounding of coordinates to float32,
//   |x' - x| <= 2^-24 |x| for binary formats, 2e-7 |x| for text, the order of vertices included where io.hpp
//   says so; and every dialect below reads alike.
#include "mesh/io.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/declared_axes.hpp"
#include "mesh/mesh_format.hpp"
#include "mesh/validation.hpp"
#include "sphere/as_floats.hpp"
#include "support/mesh_files.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::TemporaryFolder;

constexpr double kFloatRounding = 0x1p-24;

constexpr double kTextRounding = 2e-7;

void expect_same(const TriangleMesh& read, const TriangleMesh& written, double rounding = kFloatRounding) {
  ASSERT_EQ(read.vertices.size(), written.vertices.size());
  EXPECT_EQ(read.faces, written.faces);
  for (std::size_t i = 0; i < read.vertices.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double x = written.vertices[i][k];
      EXPECT_LE(std::abs(read.vertices[i][k] - x), rounding * std::abs(x)) << "vertex " << i;
    }
  }
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

const TriangleMesh kTriangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

class Format : public testing::TestWithParam<const char*> {};

TEST_P(Format, RoundTrip) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / (std::string("mesh.") + GetParam());
  const bool text = GetParam() == std::string("obj") || GetParam() == std::string("off");
  // The sphere's vertices are first used in their own order, so STL and OBJ keep it too.
  for (const TriangleMesh& mesh : {sphere(22.123456789, 300, {312.5, -47.1, 1007.0}), sphere(1e-6, 300),
                                   sphere(3e7, 300), octahedron(25.0)}) {
    write_mesh(file, mesh);
    const TriangleMesh read = read_mesh(file);
    if (mesh.faces.size() == 8) {
      EXPECT_EQ(validate(read).volume, 4.0 / 3.0 * 25.0 * 25.0 * 25.0);
    } else {
      expect_same(read, mesh, text ? kTextRounding : kFloatRounding);
    }
  }
}

TEST_P(Format, WritesOneFileAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / (std::string("mesh.") + GetParam());
  write_mesh(file, sphere(10.0, 40));
  write_mesh(file, octahedron(5.0));  // replaces
  EXPECT_EQ(read_mesh(file).faces.size(), 8U);
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST_P(Format, SameMeshSameBytes) {
  const TemporaryFolder folder;
  const fs::path a = folder.path() / (std::string("a.") + GetParam());
  const fs::path b = folder.path() / (std::string("b.") + GetParam());
  write_mesh(a, sphere(10.0, 40));
  write_mesh(b, sphere(10.0, 40));
  EXPECT_EQ(contents(a), contents(b));
}

TEST_P(Format, RefusesWhatItCannotWrite) {
  const TemporaryFolder folder;
  const std::string name = std::string("mesh.") + GetParam();
  TriangleMesh bad_index = octahedron(1.0);
  bad_index.faces[3][2] = 6;
  TriangleMesh not_finite = octahedron(1.0);
  not_finite.vertices[3].z() = std::nan("");
  EXPECT_THROW(write_mesh(folder.path() / name, {}), FileError);
  EXPECT_THROW(write_mesh(folder.path() / name, bad_index), FileError);
  EXPECT_THROW(write_mesh(folder.path() / name, not_finite), FileError);
  EXPECT_THROW(write_mesh(folder.path() / "missing" / name, octahedron(1.0)), FileError);
  EXPECT_EQ(files_in(folder.path()), 0U);
  fs::create_directory(folder.path() / name);
  EXPECT_THROW(write_mesh(folder.path() / name, octahedron(1.0)), FileError);
  EXPECT_EQ(files_in(folder.path()), 1U);
}

INSTANTIATE_TEST_SUITE_P(All, Format,
                         testing::Values("ply", "stl", "obj", "off", "vtp", "vtk", "PLY", "Stl", "Vtp"));

TEST(WriteMesh, UnknownExtension) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_mesh(folder.path() / "mesh.xyz", octahedron(1.0)), FileError);
  EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(ReadMesh, IndependentlyWrittenFiles) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = sphere(25.0, 100);
  expect_same(read_mesh(folder.write("l.ply", test::binary_ply(mesh))), mesh);
  expect_same(read_mesh(folder.write("b.ply", test::binary_ply(mesh, true))), mesh);
  // Text of nine digits is a little off the doubles; as floats they are the same.
  TriangleMesh single = mesh;
  for (Vec3& v : single.vertices) v = as_floats(v);
  expect_same(read_mesh(folder.write("a.ply", test::ascii_ply(single))), single);
  expect_same(read_mesh(folder.write("a.off", test::off(single))), single);
  expect_same(read_mesh(folder.write("a.obj", test::obj(single))), single);
  expect_same(read_mesh(folder.write("a.stl", test::ascii_stl(single))), single);
  expect_same(read_mesh(folder.write("b.stl", test::binary_stl(single))), single);
  expect_same(read_mesh(folder.write("a.vtp", test::vtp(single))), single);
  expect_same(read_mesh(folder.write("a.vtk", test::vtk(single))), single);
}

TEST(ReadMesh, StlDialects) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = octahedron(3.0);
  const auto volume = [&](const std::string& bytes) {
    return validate(read_mesh(folder.write("a.stl", bytes))).volume;
  };
  EXPECT_EQ(volume(test::binary_stl(mesh, "solid although binary")), 36.0);
  EXPECT_EQ(volume(test::ascii_stl(mesh, "facet of a name")), 36.0);
  std::string capitals = test::ascii_stl(mesh);
  std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return std::toupper(c); });
  EXPECT_EQ(volume(capitals), 36.0);
  for (const std::size_t more : {1U, 2U, 49U, 51U, 512U})
    EXPECT_EQ(volume(test::binary_stl(mesh) + std::string(more, '\0')), 36.0) << more;
  TriangleMesh far = mesh;
  for (Vec3& v : far.vertices) v.x() += 100.0;
  const TriangleMesh two =
      read_mesh(folder.write("two.stl", test::ascii_stl(mesh, "a") + test::ascii_stl(far, "b")));
  EXPECT_EQ(validate(two).components, 2U);
  EXPECT_EQ(two.faces.size(), 16U);
}

TEST(ReadMesh, PlyDialects) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& bytes) { return read_mesh(folder.write("a.ply", bytes)); };
  expect_same(
      read("ply\r\nformat ascii 1.0\r\ncomment a comment\r\nobj_info none\r\nelement vertex 3\r\n"
           "property double x\r\nproperty double y\r\nproperty double z\r\nelement face 1\r\n"
           "property list uint8 uint32 vertex_index\r\nend_header\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n"),
      kTriangle);
  expect_same(read("ply\nformat ascii 1.0\nelement vertex 3\nproperty uchar red\nproperty float32 "
                   "x\nproperty float y\n"
                   "property float z\nproperty float quality\nproperty list uchar float weights\n"
                   "element face 1\nproperty uchar flags\nproperty list uchar short vertex_indices\n"
                   "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
                   "9 0 0 0 7 2 5 5\n9 1 0 0 7 0\n9 0 1 0 7 1 5\n1 3 0 1 2\n0 1"),
              kTriangle);
}

TEST(ReadMesh, OffDialects) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& bytes) { return read_mesh(folder.write("a.off", bytes)); };
  expect_same(read("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"), kTriangle);
  expect_same(read("# first\nOFF # keyword\n# counts\n3 1 3\n\n0 0 0 # origin\n# second\n1 0 0\n0 1 0\n\n3 0 "
                   "1 2 # face\n"),
              kTriangle);
  expect_same(read("COFF\r\n3 1 0\r\n0 0 0 255 0 0 255\r\n1 0 0 255 0 0 255\r\n0 1 0 255 0 0 255\r\n3 0 1 2 "
                   "0.5 0.5 0.5\r\n"),
              kTriangle);
}

TEST(ReadMesh, ObjDialects) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& bytes) { return read_mesh(folder.write("a.obj", bytes)); };
  const std::string points = "v 0 0 0\nv 1 0 0 1.0\nv 0 1 0\n";
  expect_same(read("# comment\r\nmtllib none.mtl\r\no thing\r\n" + points +
                   "vt 0 0\nvn 0 0 1\ng part\nusemtl red\ns off\n"
                   "f 1/1/1 2/1/1 3/1/1 # face\n"),
              kTriangle);
  expect_same(read(points + "f -3 -2 -1\n"), kTriangle);
  expect_same(read(points + "f 1//9 2//9 3//9\n"), kTriangle);  // normals that are not there do not matter
  expect_same(read(points + "f 1 \\\n2 3"), kTriangle);
  expect_same(read(points + "l 1 2\np 1\nf 1 2 3\n"), kTriangle);
  EXPECT_EQ(read("v .5 -.5 +.25\nv 1. 0 0\nv 0 1e0 0\nf 1 2 3\n").vertices,
            (std::vector<Vec3>{{0.5, -0.5, 0.25}, {1, 0, 0}, {0, 1, 0}}));
  const TriangleMesh two = read(points + "g a\nf 1 2 3\nusemtl b\ng b\nv 0 0 9\nf 1 2 4\n");
  EXPECT_EQ(two.faces, (std::vector<Face>{{0, 1, 2}, {0, 1, 3}}));
}

// A square as a strip, as a quad and as two pieces, with lines and points beside it.
TEST(ReadMesh, VtkDialects) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& head, const std::string& rest) {
    return read_mesh(folder.write(
        "a.vtk", "# vtk DataFile Version " + head + "\na title\nASCII\nDATASET POLYDATA\n" + rest));
  };
  const std::string points = "POINTS 4 double\n0 0 0 1 0 0 0 1 0\n1 1 0\n";
  const std::vector<Face> halves{{0, 1, 2}, {2, 1, 3}};
  EXPECT_EQ(read("3.0", points + "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n").faces, halves);
  EXPECT_EQ(read("2.0", "FIELD FieldData 2\nnames 1 2 string\na%20b\nc\ntime 1 1 double\n0.5\n" + points +
                            "METADATA\nINFORMATION 0\n\nVERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\n"
                            "polygons 2 8 3 0 1 2\n3 2 1 3\nPOINT_DATA 4\nSCALARS a float\n")
                .faces,
            halves);
  EXPECT_EQ(read("5.1", points + "LINES 2 2\nOFFSETS vtktypeint64\n0 2\nCONNECTIVITY vtktypeint64\n0 1\n"
                                 "POLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 6\nCONNECTIVITY vtktypeint64\n"
                                 "0 1 2 2 1 3\n")
                .faces,
            halves);
  EXPECT_EQ(read("4.2", points + "POLYGONS 1 5\n4 0 1 3 2\n").faces.size(), 2U);
}

TEST(ReadMesh, VtpDialects) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& attributes, const std::string& pieces) {
    return read_mesh(folder.write("a.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"" +
                                               attributes + "><PolyData>" + pieces +
                                               "</PolyData></VTKFile>\n\n"));
  };
  const auto array = [](const std::string& name, const std::string& numbers) {
    return "<DataArray type='Int32' Name='" + name + "' format='ascii'> " + numbers +
           "<InformationKey name='L2_NORM_RANGE'>7</InformationKey></DataArray>";
  };
  const auto piece = [&](const std::string& points, const std::string& cells) {
    return "<Piece NumberOfPoints='3' NumberOfStrips='1' NumberOfPolys='0'><Points>" +
           array("Points", points) + "</Points><Polys/><Strips>" + array("offsets", cells) +
           array("connectivity", "0 1 2") + "</Strips></Piece>";
  };
  const std::string first = piece("0 0 0 1 0 0 0 1 0", "3");
  EXPECT_EQ(read("", first + "<Piece NumberOfPoints='0'/>" + piece("0 1 0 1 0 0 1 1 0", "3")).faces,
            (std::vector<Face>{{0, 1, 2}, {2, 1, 3}}));
  const auto refused = [&](const std::string& attributes, const std::string& pieces) {
    return test::thrown<FileError>([&] { read(attributes, pieces); });
  };
  EXPECT_NE(
      refused(" compressor='vtkLZ4DataCompressor'", first).find("vtkLZ4DataCompressor; save it with ZLib"),
      std::string::npos);
  EXPECT_NE(refused("", piece("0 0 0 1 0 0 0 1", "3")).find("not all of its 3 points are there"),
            std::string::npos);
  EXPECT_NE(refused("", piece("0 0 0 1 0 0 0 1 0", "2")).find("not all of its 1 Strips are there"),
            std::string::npos);
}

TEST(DeclaredAxes, EveryFormatThatSaysThemIsReadSo) {
  const TemporaryFolder folder;
  for (const std::string_view format : words_of<MeshFormat>) {
    const fs::path file = folder.path() / ("a." + std::string(format));
    for (const char* code : {"RAS", "LPS", "LAI"}) {
      write_mesh(file, octahedron(1.0), {.axes = code});
      const bool said = format != "off" && code != std::string("LAI");
      EXPECT_EQ(declared_axes(file), said ? std::optional<std::string>(code) : std::nullopt) << file;
    }
  }
}

// A square and an L of six corners: areas 4 and 3.
TEST(ReadMesh, PolygonsAreTriangulated) {
  const TemporaryFolder folder;
  const auto area = [](const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const Face& face : mesh.faces) sum += 0.5 * area_vector(mesh, face).z();
    return sum;
  };
  const TriangleMesh square =
      read_mesh(folder.write("a.off", "OFF\n4 1 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n"));
  EXPECT_EQ(square.faces.size(), 2U);
  EXPECT_EQ(area(square), 4.0);
  const TriangleMesh ell = read_mesh(
      folder.write("a.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n"));
  EXPECT_EQ(ell.faces.size(), 4U);
  EXPECT_EQ(area(ell), 3.0);
}

// Beside a triangle alone, a face without corners would make assimp abort.
TEST(ReadMesh, FacesOfFewerThanThreeCornersAreNone) {
  const TemporaryFolder folder;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  for (const char* small : {"0\n", "1 2\n", "2 0 1\n"}) {
    expect_same(
        read_mesh(folder.write("a.ply", test::ply_header("ascii", 3, 2) + points + "3 0 1 2\n" + small)),
        kTriangle);
  }
  expect_same(read_mesh(folder.write("a.off", "OFF\n3 2 0\n" + points + "2 0 1\n3 0 1 2\n")), kTriangle);
}

TEST(ReadMesh, EqualVerticesAreWeldedAndOthersKept) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read_mesh(folder.write(
      "a.off", "OFF\n7 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n-0 1 0\n1 1 0\n5 5 5\n3 0 1 2\n3 3 5 4\n"));
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(mesh.vertices.size(), 5U);  // the lone point at 5 5 5 too
}

}  // namespace
}  // namespace impinge
