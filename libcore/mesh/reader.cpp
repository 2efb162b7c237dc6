// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "mesh/collinear.hpp"
#include "mesh/file_bytes.hpp"
#include "mesh/file_checks.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_format.hpp"
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
  }
  return {};
}

const char* assimp_hint(MeshFormat format) {
  switch (format) {
    case MeshFormat::ply:
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

// Did assimp find what is there? Before any of its processing touches an index.
void check_scene(const fs::path& file, const aiScene& scene, const MeshFileContent& content) {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const aiMesh* part : parts(scene)) {
    vertices += part->mNumVertices;
    for (const aiFace& face : polygons(*part)) {
      if (face.mNumIndices >= 3) ++faces;
      if (!std::ranges::all_of(corners(face), [part](unsigned v) { return v < part->mNumVertices; })) {
        throw MeshFileError(file, "a face names a vertex that is not there, it is damaged",
                            "export it again");
      }
    }
  }
  if (faces != content.polygons || (content.vertices && vertices != *content.vertices)) {
    throw MeshFileError(file,
                        "only " + std::to_string(faces) + " of its " + std::to_string(content.polygons) +
                            " faces could be read",
                        "triangulate it and export it as binary PLY or STL");
  }
}

// None of the four formats has node transforms: the parts stand side by side.
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

void check_shape(const fs::path& file, const TriangleMesh& mesh) {
  const auto lost = std::ranges::count_if(mesh.vertices, [](const Vec3& v) { return !v.allFinite(); });
  if (lost > 0) {
    throw MeshFileError(
        file, std::to_string(lost) + " vertices have coordinates that are NaN, infinite or beyond 3e38",
        "remove them or export the mesh again");
  }
  const auto flat = [&mesh](const Face& f) {
    return collinear(corner(mesh, f, 0), corner(mesh, f, 1), corner(mesh, f, 2));
  };
  if (std::ranges::all_of(mesh.faces, flat)) {
    throw MeshFileError(file, "none of its faces has an area", "export the surface again");
  }
}

}  // namespace

TriangleMesh read_mesh(const fs::path& file) {
  const MeshFormat format = mesh_format(file);
  std::string bytes = read_bytes(file);
  const MeshFileContent content = check(file, format, bytes);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, assimp_hint(format));
  if (scene == nullptr) {
    throw MeshFileError(file, std::string("cannot be read, ") + importer.GetErrorString(), "export it again");
  }
  check_scene(file, *scene, content);
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene == nullptr)
    throw MeshFileError(file, "cannot be triangulated", "triangulate it and export it again");
  TriangleMesh mesh = weld(gather(*scene)).mesh;
  check_shape(file, mesh);
  return mesh;
}

}  // namespace impinge
