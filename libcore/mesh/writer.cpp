// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <string>

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>

#include "files/file_bytes.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_format.hpp"
#include "mesh/ply_writer.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

void require_writable(const fs::path& file, const TriangleMesh& mesh) {
  const char* reason = nullptr;
  if (mesh.faces.empty()) reason = "the mesh has no faces";
  if (!std::ranges::all_of(mesh.vertices, [](const Vec3& v) { return v.allFinite(); })) {
    reason = "the mesh has coordinates that are NaN or infinite";
  }
  for (const Face& face : mesh.faces) {
    if (std::ranges::max(face) >= mesh.vertices.size()) reason = "a face names a vertex that is not there";
  }
  if (reason != nullptr)
    throw FileError(file, std::string("is not written, ") + reason, "repair the mesh first");
}

// A scene of one mesh. assimp's destructors release what is allocated here.
std::unique_ptr<aiScene> to_scene(const TriangleMesh& mesh) {
  auto part = std::make_unique<aiMesh>();
  part->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  part->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
  part->mVertices = new aiVector3D[mesh.vertices.size()];
  std::ranges::transform(mesh.vertices, part->mVertices, [](const Vec3& v) {
    return aiVector3D(static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()));
  });
  part->mNumFaces = static_cast<unsigned>(mesh.faces.size());
  part->mFaces = new aiFace[mesh.faces.size()];
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    part->mFaces[f].mNumIndices = 3;
    part->mFaces[f].mIndices = new unsigned[3]{mesh.faces[f][0], mesh.faces[f][1], mesh.faces[f][2]};
  }
  auto scene = std::make_unique<aiScene>();
  scene->mNumMeshes = 1;
  scene->mMeshes = new aiMesh* [1] { part.release() };
  scene->mNumMaterials = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mRootNode = new aiNode;
  scene->mRootNode->mNumMeshes = 1;
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  return scene;
}

// objnomtl: plain "obj" comes with a material library.
void write_with_assimp(const fs::path& file, const TriangleMesh& mesh, const char* assimp_format) {
  const std::unique_ptr<aiScene> scene = to_scene(mesh);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), assimp_format);
  if (blob == nullptr) {
    throw FileError(file, std::string("cannot be written, ") + exporter.GetErrorString(), "use .ply");
  }
  write_bytes(file, {static_cast<const char*>(blob->data), blob->size});
}

// assimp 5.2 reads OFF but does not write it. Shortest numbers that read back as the same doubles.
void write_off(const fs::path& file, const TriangleMesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.faces.size()) + " 0\n";
  std::array<char, 32> digits{};
  for (const Vec3& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) {
      text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), v[k]).ptr);
      text += k < 2 ? ' ' : '\n';
    }
  }
  for (const auto& [a, b, c] : mesh.faces) {
    text += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  }
  write_bytes(file, text);
}

}  // namespace

void write_mesh(const fs::path& file, const TriangleMesh& mesh) {
  const MeshFormat format = mesh_format(file);
  require_writable(file, mesh);
  switch (format) {
    case MeshFormat::ply:
      return write_ply(file, mesh);
    case MeshFormat::off:
      return write_off(file, mesh);
    case MeshFormat::stl:
      return write_with_assimp(file, mesh, "stlb");
    case MeshFormat::obj:
      return write_with_assimp(file, mesh, "objnomtl");
  }
}

}  // namespace impinge
