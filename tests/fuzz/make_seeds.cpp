// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_seeds DIR: writes DIR/mesh (small meshes in every format), DIR/options (command lines) and DIR/poses,
// in place of what is there, and DIR/mesh.list and so on, their names with commas between.
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "files/file_bytes.hpp"
#include "fuzz/mesh_input.hpp"
#include "mesh/bodies.hpp"
#include "mesh/io.hpp"
#include "sphere/scheme_choice.hpp"
#include "support/mesh_files.hpp"

namespace {

using namespace impinge;
namespace fs = std::filesystem;

// Seeds of one kind, numbered.
class Seeds {
 public:
  explicit Seeds(fs::path folder) : folder_(std::move(folder)) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  const fs::path& folder() const { return folder_; }
  void add(const std::string& bytes) {
    const fs::path file = folder_ / std::to_string(count_++);
    write_bytes(file, bytes);
    list_ += (list_.empty() ? "" : ",") + file.string();
  }
  void write_list() const { write_bytes(folder_.string() + ".list", list_); }

 private:
  fs::path folder_;
  std::string list_;
  int count_ = 0;
};

void add_mesh(Seeds& seeds, const TriangleMesh& mesh) {
  for (std::size_t k = 0; k < test::kFormats.size(); ++k) {
    const fs::path file = seeds.folder() / test::kFormats[k];
    write_mesh(file, mesh);
    seeds.add(std::to_string(k) + read_bytes(file));
    fs::remove(file);
  }
  seeds.add('0' + test::ascii_ply(mesh));
  seeds.add('0' + test::binary_ply(mesh));
  seeds.add('0' + test::binary_ply(mesh, /*big_endian=*/true));
  seeds.add('1' + test::ascii_stl(mesh));
  seeds.add('2' + test::obj(mesh));
  seeds.add('3' + test::off(mesh));
  seeds.add('4' + test::vtp(mesh));
  seeds.add('5' + test::vtk(mesh));
}

// A triangle: compressed in base64, and raw behind a strip.
void add_vtk_meshes(Seeds& seeds) {
  const auto array = [](const std::string& name, const std::string& type, const std::string& offset) {
    return "<DataArray type='" + type + "' Name='" + name +
           "' NumberOfComponents='3' format='appended' offset='" + offset + "'/>";
  };
  const std::string piece = "<PolyData><Piece NumberOfPoints='3' NumberOfPolys='1'><Points>";
  const std::string end = "</Polys></Piece></PolyData><AppendedData encoding='";
  seeds.add("4<VTKFile type='PolyData' compressor='vtkZLibDataCompressor'>" + piece +
            array("Points", "Float32", "0") + "</Points><Polys>" + array("connectivity", "Int32", "48") +
            array("offsets", "Int32", "96") + end +
            "base64'>_AQAAACQAAAAAAAAAEAAAAA==eNpjYEAGDfYMWPgAFIoBfw==AQAAAAwAAAAAAAAAEQAAAA=="
            "eNpjYGBgYARiJiAGAAAcAAQ="
            "AQAAAAQAAAAAAAAADAAAAA==eNpjZmBgAAAAEAAE</AppendedData></VTKFile>");
  std::string raw("\x09\0\0\0\0\0\0\1\0\0\0\1\0\3\0\0\0\0\1\2\1\0\0\0\3", 25);
  seeds.add("4<VTKFile type='PolyData' byte_order='LittleEndian' header_type='UInt32'>" + piece +
            array("Points", "UInt8", "0") + "</Points><Polys>" + array("connectivity", "Int8", "13") +
            array("offsets", "UInt8", "20") + end + "raw'>_" + raw + "</AppendedData></VTKFile>");
  seeds.add(
      "5# vtk DataFile Version 5.1\na\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nTimeValue 1 1 "
      "double\n0.5\n"
      "METADATA\nINFORMATION 0\n\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0\n1 1 0\nVERTICES 2 1\nOFFSETS "
      "vtktypeint64\n0 "
      "1\nCONNECTIVITY vtktypeint64\n3\nPOLYGONS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n"
      "0 1 3 2\nPOINT_DATA 4\n");
  seeds.add(
      "5# vtk DataFile Version 2.0\na\nASCII\nDATASET POLYDATA\nPOINTS 4 int\n0 0 0 1 0 0 0 1 0\n1 1 0\n"
      "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n");
}

void add_unusual_meshes(Seeds& seeds) {
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  seeds.add("3COFF # a square\n4 1 4\n" + points + "4 0 1 2 3 255 0 0\n");
  seeds.add(
      "2o square\nv 0 0 0 1 .5 .5\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nf 1/1/1 2//1 \\\n 3/1 -1\n");
  seeds.add(
      "0ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty double x\nproperty double y\n"
      "property double z\nproperty uchar red\nelement face 1\nproperty list uchar uint vertex_index\n"
      "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
      "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n4 0 1 2 3\n0 1\n");
  seeds.add(
      "1solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\n"
      "endsolid a\nsolid b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 -1e-3 0\n"
      "endloop\nendfacet\nendsolid b\n");
}

std::string joined(const std::string& words) {
  std::string text = words;
  for (char& c : text) c = c == ' ' ? '\0' : c;
  return text;
}

void add_options(Seeds& seeds) {
  const std::string files = " b.ply s.stl --out o";
  for (const char* question : {"gaps", "touch", "limits", "measure", "volume", "certify", "check f"})
    seeds.add(joined(question + files));
  seeds.add(joined("gaps" + files +
                   " --centre 1,-2.5,3e2 --precision 0.25 --side left --pose "
                   "flexion=90,internal_rotation=10"));
  seeds.add(joined("gaps" + files + " --max-error 0.05 --axes LPS --cartilage 2.5 --keep largest"));
  seeds.add(joined("gaps" + files + " --precision=1 --pose=adduction=-20 --side=right --centre=fit"));
  seeds.add(joined("gaps" + files + " --surfaces ball --outputs gaps --overlap 1"));
  seeds.add(joined("touch --joints d --out o --json --quiet --threads 2"));
  seeds.add(joined("poses" + files + " --path flexion=0..90/10,abduction=-5..5/5 --outputs touch,areas"));
  seeds.add(joined("poses" + files + " --poses walk.mot --ball-part c.ply --socket-part d.ply"));
  seeds.add(joined("limits" + files + " --motions abduction,fadir --largest 90 --translation 0,1,-2"));
  seeds.add(joined("limits" + files + " --pose flexion=-20 --side left --landmarks l.csv"));
  seeds.add(joined("resect" + files + " --require flexion=90 --require extension=20 --clearance 1 --neck 9"));
  seeds.add(joined("resect" + files + " --require flexion=90 --cut socket --rim 2 --least"));
  seeds.add(joined("orient" + files + " --side left --require flexion=90,abduction=5 --tilt -10"));
  seeds.add(joined("volume" + files + " --width 0.1 --gap 2 --centre-within 1"));
  seeds.add(joined("hip cam --set cam_height=3 --faces 500 --out o"));
  seeds.add(joined("gaps --schema"));
  for_each_scheme([&]<class S>() {
    seeds.add(joined("gaps" + files + " --scheme " + std::string(S::name) + " --precision 2"));
  });
  seeds.add("--help");
}

// A digit first: 1 for a file of OpenSim.
void add_poses(Seeds& seeds) {
  const std::string unit = "1,0,0,0,0,1,0,0,0,0,1,7";
  seeds.add("0\xEF\xBB\xBF\"Flexion\";abduction;Frame\n10,5;5;1\n;nan;2\n");
  seeds.add("0plane_of_elevation\televation\taxial_rotation\ttx\n30\t80\t-20\t1\n");
  seeds.add("0rot_x,rot_y,rot_z,trans_x,trans_y,trans_z,Valid_pose\n10,20,30,1,2,3,1\n");
  seeds.add("0qw,qx,qy,qz,tx,ty,tz\n0.5,0.5,-0.5,0.5,1,2,3\n");
  seeds.add("0ball_qw,ball_qx,ball_qy,ball_qz,socket_qw,socket_qx,socket_qy,socket_qz\n1,0,0,0,0,1,0,0\n");
  seeds.add("0" + unit + "\n,,,,,,,,,,,\n" + unit + ",0,0,0,1\n");
  const std::string labels = "time\thip_flexion_r\thip_adduction_r\thip_rotation_r\n0\t10\t20\t30\n";
  seeds.add("1walk\ninDegrees=yes\nendheader\n" + labels);
  seeds.add(
      "1DataType=Quaternion\nendheader\ntime\tpelvis_imu\tfemur_r_imu\n0\t1,0,0,0\t0,1,0,0\n"
      "1\t0,0,1,0\t0,0,0,1\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const fs::path folder = argv[1];
  Seeds meshes(folder / "mesh");
  add_mesh(meshes, octahedron(2.5));
  add_mesh(meshes, sphere(10.0, 20));
  add_unusual_meshes(meshes);
  add_vtk_meshes(meshes);
  meshes.write_list();
  Seeds options(folder / "options");
  add_options(options);
  Seeds poses(folder / "poses");
  add_poses(poses);
  poses.write_list();
  options.write_list();
}
