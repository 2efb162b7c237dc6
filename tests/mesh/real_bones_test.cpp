// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: the counts of real meshes are those that their subject.json states. The bones are not part of the
// project: the environment variable IMPINGE_BONES names their folder (one folder a subject, each with PLY
// files and a subject.json that holds "files": { NAME: { "vertices": .., "triangles": .., ...} }). Without it
// there is nothing to compare, and the test returns at once.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "mesh/io.hpp"
#include "mesh/validation.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

// The number behind "key": within text, if it is one. Enough for the flat entries of these files.
std::optional<double> number(const std::string& text, const std::string& key) {
  const std::size_t at = text.find('"' + key + "\":");
  if (at == std::string::npos) return std::nullopt;
  std::istringstream stream(text.substr(at + key.size() + 3, 40));
  double value = 0.0;
  return stream >> value ? std::optional(value) : std::nullopt;
}

// The entry of one file, up to its first array or end.
std::string entry(const std::string& json, const std::string& name) {
  const std::size_t begin = json.find('"' + name + "\": {");
  return begin == std::string::npos ? "" : json.substr(begin, json.find('}', begin) - begin);
}

void compare(const fs::path& file, const std::string& stated) {
  const MeshReport report = validate(read_mesh(file));
  const auto expect = [&](const char* key, std::size_t counted) {
    const std::optional<double> value = number(stated, key);
    ASSERT_TRUE(value) << file << ' ' << key;
    EXPECT_EQ(static_cast<double>(counted), *value) << file << ' ' << key;
  };
  expect("vertices", report.vertices);
  expect("triangles", report.faces);
  expect("boundary_edges", report.boundary_edges);
  expect("nonmanifold_edges", report.non_manifold_edges);
  expect("components", report.components);
  expect("degenerate_triangles", report.degenerate_faces);
  const std::optional<double> volume = number(stated, "signed_volume_mm3");
  EXPECT_EQ(report.volume.has_value(), volume.has_value()) << file;
  if (volume && report.volume) {
    EXPECT_NEAR(*report.volume, *volume, 0.1) << file;
  }
  EXPECT_EQ(report.unreferenced_vertices + report.duplicate_faces + report.non_finite_vertices, 0U) << file;
}

TEST(RealBones, CountsAreThoseStated) {
  const char* folder = std::getenv("IMPINGE_BONES");  // NOLINT(concurrency-mt-unsafe)
  if (folder == nullptr) return;
  std::size_t compared = 0;
  for (const fs::directory_entry& subject : fs::directory_iterator(folder)) {
    if (!fs::exists(subject.path() / "subject.json")) continue;
    std::ostringstream json;
    json << std::ifstream(subject.path() / "subject.json").rdbuf();
    for (const fs::directory_entry& file : fs::directory_iterator(subject.path())) {
      if (file.path().extension() != ".ply") continue;
      compare(file.path(), entry(json.str(), file.path().filename().string()));
      ++compared;
    }
  }
  EXPECT_GT(compared, 0U) << folder << " holds no subject.json beside PLY files";
}

}  // namespace
}  // namespace impinge
