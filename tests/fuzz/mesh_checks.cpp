// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: for any bytes, a check finds at least one face or throws FileError with one line
// "FILE: reason; advice". The plain text that it makes of a text file passes the same check with the same
// counts, and is then no longer changed; of a file of VTK it makes a PLY file.
#include "files/file_error.hpp"
#include "fuzz/mesh_input.hpp"
#include "fuzz/require.hpp"
#include "mesh/file_checks.hpp"
#include "mesh/mesh_format.hpp"

namespace {

using namespace impinge;
using test::require;

MeshFileContent check(const std::filesystem::path& file, std::string& bytes) {
  switch (mesh_format(file)) {
    case MeshFormat::ply:
      return check_ply(file, bytes);
    case MeshFormat::stl:
      return check_stl(file, bytes);
    case MeshFormat::obj:
      return check_obj(file, bytes);
    case MeshFormat::vtp:
      return check_vtp(file, bytes);
    case MeshFormat::vtk:
      return check_vtk(file, bytes);
    case MeshFormat::off:
      break;
  }
  return check_off(file, bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;  // parse_mesh() refuses empty files itself
  auto [file, bytes] = test::mesh_input(data, size);
  try {
    const MeshFileContent content = check(file, bytes);
    require(content.polygons > 0, "a mesh has faces");
    require(!content.sums || (content.sums->coordinates >= 0.0 && content.sums->corners >= 0.0) ||
                content.sums->coordinates != content.sums->coordinates,
            "sums are of magnitudes");
    std::string plain = bytes;
    const bool ply = file.extension() == ".vtp" || file.extension() == ".vtk";
    const MeshFileContent again = check(ply ? "mesh.ply" : file, plain);
    require(plain == bytes, "plain text stays as it is", plain);
    require(again.polygons == content.polygons && again.vertices == content.vertices, "counts stay");
  } catch (const FileError& error) {
    test::require_message(error.what(), file.string() + ": ");
  }
  return 0;
}
