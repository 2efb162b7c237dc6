// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "files/file_bytes.hpp"
#include "mesh/file_checks.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_format.hpp"
#include "mesh/raw_mesh.hpp"
#include "mesh/weld.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

MeshFileContent check(const fs::path& file, MeshFormat format, std::string& bytes) {
  switch (format) {
    case MeshFormat::ply:
      return check_ply(file, bytes);
    case MeshFormat::stl:
      return check_stl(file, bytes);
    case MeshFormat::obj:
      return check_obj(file, bytes);
    case MeshFormat::off:
      return check_off(file, bytes);
    case MeshFormat::vtp:
      return check_vtp(file, bytes);
    case MeshFormat::vtk:
      return check_vtk(file, bytes);
  }
  return {};
}

const char* assimp_hint(MeshFormat format) {
  switch (format) {
    case MeshFormat::ply:
    case MeshFormat::vtp:  // has become plain PLY by now
    case MeshFormat::vtk:
      return "ply";
    case MeshFormat::stl:
      return "stl";
    case MeshFormat::obj:
      return "obj";
    case MeshFormat::off:
      return "off";
  }
  return "";
}

std::span<aiMesh* const> parts(const aiScene& scene) { return {scene.mMeshes, scene.mNumMeshes}; }
std::span<const aiFace> polygons(const aiMesh& part) { return {part.mFaces, part.mNumFaces}; }
std::span<const aiVector3D> points(const aiMesh& part) { return {part.mVertices, part.mNumVertices}; }
std::span<const unsigned> corners(const aiFace& face) { return {face.mIndices, face.mNumIndices}; }

// What assimp found. Indices that do not exist are refused before assimp processes them.
MeshFileContent content_of(const fs::path& file, const aiScene& scene) {
  MeshFileContent found{0, 0, MeshFileSums{}};
  for (const aiMesh* part : parts(scene)) {
    *found.vertices += part->mNumVertices;
    for (const aiVector3D& p : points(*part)) {
      found.sums->coordinates += std::abs(double{p.x}) + std::abs(double{p.y}) + std::abs(double{p.z});
    }
    for (const aiFace& face : polygons(*part)) {
      if (face.mNumIndices >= 3) ++found.polygons;
      for (const unsigned v : corners(face)) {
        if (v >= part->mNumVertices) {
          throw FileError(file, "a face names a vertex that is not there, it is damaged", "export it again");
        }
        if (face.mNumIndices >= 3) found.sums->corners += v;
      }
    }
  }
  return found;
}

// Throws unless assimp found what the check found.
void check_scene(const fs::path& file, const aiScene& scene, const MeshFileContent& content) {
  const MeshFileContent found = content_of(file, scene);
  const char* advice = "triangulate it and export it as STL";
  if (found.polygons != content.polygons || (content.vertices && found.vertices != content.vertices)) {
    throw FileError(file,
                    "only " + std::to_string(found.polygons) + " of its " + std::to_string(content.polygons) +
                        " faces could be read",
                    advice);
  }
  if (!content.sums) return;
  const double off = std::abs(found.sums->coordinates - content.sums->coordinates);
  if (off > 1e-6 * content.sums->coordinates || found.sums->corners != content.sums->corners) {
    throw FileError(file, "could not be read right, it has unusual elements", advice);
  }
}

// Puts the parts side by side, as none of the formats has node transforms.
TriangleMesh gather(const aiScene& scene) {
  TriangleMesh mesh;
  for (const aiMesh* part : parts(scene)) {
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    for (const aiVector3D& p : points(*part)) mesh.vertices.emplace_back(p.x, p.y, p.z);
    for (const aiFace& face : polygons(*part)) {
      if (face.mNumIndices != 3) continue;  // points and lines
      mesh.faces.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  return mesh;
}

void check_coordinates(const fs::path& file, const aiScene& scene) {
  std::size_t lost = 0;
  for (const aiMesh* part : parts(scene)) {
    for (const aiVector3D& p : points(*part)) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) ++lost;
    }
  }
  if (lost == 0) return;
  throw FileError(file,
                  std::to_string(lost) + (lost == 1 ? " vertex has" : " vertices have") +
                      " coordinates that are NaN, infinite or beyond 3e38",
                  "remove them or export the mesh again");
}

// Triangulates only if there are polygons: assimp 5.2 aborts the program for a mesh of triangles and a face
// without corners.
void triangulate(const fs::path& file, Assimp::Importer& importer) {
  const auto has_polygon = [](const aiMesh* part) {
    return std::ranges::any_of(polygons(*part), [](const aiFace& face) { return face.mNumIndices > 3; });
  };
  if (!std::ranges::any_of(parts(*importer.GetScene()), has_polygon)) return;
  const auto triangles = [&] {
    std::size_t count = 0;
    for (const aiMesh* part : parts(*importer.GetScene()))
      for (const aiFace& face : polygons(*part)) count += std::max(face.mNumIndices, 2U) - 2U;
    return count;
  };
  // assimp leaves out what it cannot triangulate.
  const std::size_t expected = triangles();
  if (importer.ApplyPostProcessing(aiProcess_Triangulate) == nullptr || triangles() != expected) {
    throw FileError(file, "has polygons that cannot be triangulated", "triangulate it and export it again");
  }
}

// Throws FileError that says why assimp has no scene, or std::bad_alloc if it had too little memory.
[[noreturn]] void fail_reading(const fs::path& file, const Assimp::Importer& importer) {
  try {
    if (importer.GetException()) std::rethrow_exception(importer.GetException());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // its text is in GetErrorString()
  }
  throw FileError(file, std::string("cannot be read, ") + importer.GetErrorString(), "export it again");
}

// A sparse file may declare more than any memory holds.
void require_size(const fs::path& file) {
  std::error_code elsewhere;  // read_bytes() says what is wrong with a file that cannot be looked up
  const std::uintmax_t size = fs::file_size(file, elsewhere);
  if (elsewhere || size <= kMostMeshBytes) return;
  throw FileError(file,
                  "has " + std::to_string(size) + " bytes, more than the " + std::to_string(kMostMeshBytes) +
                      " that are read",
                  "check that it is a mesh, or reduce its triangles");
}

}  // namespace

TriangleMesh read_mesh(const fs::path& file) {
  mesh_format(file);  // so that a wrong name is reported before wrong contents
  require_size(file);
  return parse_mesh(file, read_bytes(file));
}

TriangleMesh parse_mesh(const fs::path& file, std::string bytes) {
  const MeshFormat format = mesh_format(file);
  if (bytes.empty()) throw FileError(file, "is empty", "export or copy it again");
  const MeshFileContent content = check(file, format, bytes);
  Assimp::Importer importer;
  if (importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, assimp_hint(format)) == nullptr)
    fail_reading(file, importer);
  check_coordinates(file, *importer.GetScene());
  check_scene(file, *importer.GetScene(), content);
  triangulate(file, importer);
  TriangleMesh mesh = weld(gather(*importer.GetScene()));
  require_area(file, mesh);
  return mesh;
}

}  // namespace impinge
