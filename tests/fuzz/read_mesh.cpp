// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: for any bytes, parse_mesh() returns a mesh whose indices exist, whose coordinates are finite and
// of which one face has an area, or throws FileError with one line "FILE: reason; advice". A mesh that was
// read is the same after it was written as PLY and read again.
#include "files/file_error.hpp"
#include "fuzz/mesh_input.hpp"
#include "fuzz/require.hpp"
#include "mesh/io.hpp"
#include "mesh/ply_writer.hpp"
#include "mesh/validation.hpp"

namespace {

using namespace impinge;
using test::require;

void require_mesh(const TriangleMesh& mesh) {
  const MeshReport report = validate(mesh);
  require(report.faces > 0 && report.degenerate_faces < report.faces, "a mesh has an area", describe(report));
  require(report.invalid_faces == 0 && report.non_finite_vertices == 0, "a mesh is whole", describe(report));
}

void require_kept(const TriangleMesh& mesh) {
  const std::vector<double> values(mesh.vertices.size(), 0.0);
  const TriangleMesh again = parse_mesh("again.ply", ply_bytes(mesh, {"", {{"value", values}}, {}}));
  require(again.vertices == mesh.vertices && again.faces == mesh.faces, "a mesh is the same when read again");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto [file, bytes] = test::mesh_input(data, size);
  try {
    const TriangleMesh mesh = parse_mesh(file, bytes);
    require_mesh(mesh);
    require_kept(mesh);
  } catch (const FileError& error) {
    test::require_message(error.what(), file.string() + ": ");
  }
  return 0;
}
