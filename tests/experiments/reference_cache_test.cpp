// SPDX-License-Identifier: GPL-3.0-or-later
// A cached answer is the measured one, bit for bit, or it is not used at all.
#include "harness/reference_cache.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "mesh/bodies.hpp"
#include "support/directions.hpp"
#include "support/temporary_folder.hpp"

namespace impinge::lab {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> found(values.size());
  std::ranges::transform(values, found.begin(), [](double x) { return std::bit_cast<std::uint64_t>(x); });
  return found;
}

std::vector<fs::path> files(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.push_back(entry.path());
  return found;
}

class ReferenceCache : public ::testing::Test {
 protected:
  // Whether the reference itself was asked shows in its reports of progress.
  std::vector<double> radii(const TriangleMesh& mesh, Layer layer = Layer::nearest) {
    measured_ = false;
    return cached_exact_radii(
        folder(), mesh,
        {.directions = directions_, .layer = layer, .progress = [&](std::size_t) { measured_ = true; }});
  }

  fs::path folder() const { return folder_.path() / "made" / "when missing"; }

  test::TemporaryFolder folder_;
  std::vector<Vec3> directions_ = test::random_directions(50, 1);
  bool measured_ = false;
};

TEST_F(ReferenceCache, SecondAnswerIsTheFirstAndIsNotMeasured) {
  const TriangleMesh mesh = cup(20.0, 60.0, 40);  // most directions meet nothing
  const std::vector<double> first = radii(mesh);
  EXPECT_TRUE(measured_);
  EXPECT_EQ(bits(first), bits(exact_radii(mesh, {.directions = directions_})));
  EXPECT_EQ(bits(radii(mesh)), bits(first));
  EXPECT_FALSE(measured_);
  EXPECT_EQ(files(folder()).size(), 1U);
}

TEST_F(ReferenceCache, AnythingElseInTheQueryIsAnotherAnswer) {
  const TriangleMesh mesh = octahedron(10.0);
  radii(mesh);
  const auto expect_measured = [&](const char* what) { EXPECT_TRUE(measured_) << what; };
  radii(mesh, Layer::farthest);
  expect_measured("layer");
  TriangleMesh moved = mesh;
  moved.vertices[3].y() = std::nextafter(moved.vertices[3].y(), 99.0);
  radii(moved);
  expect_measured("one bit of a vertex");
  TriangleMesh fewer = mesh;
  fewer.faces.pop_back();
  radii(fewer);
  expect_measured("faces");
  std::swap(directions_[0], directions_[1]);
  radii(mesh);
  expect_measured("order of directions");
  const std::vector<double> distances = cached_closest_distances(folder(), mesh, {.points = directions_});
  EXPECT_EQ(bits(distances), bits(closest_distances(mesh, {.points = directions_})));
  EXPECT_EQ(files(folder()).size(), 6U);
  EXPECT_EQ(bits(cached_closest_distances(folder(), mesh, {.points = directions_})), bits(distances));
  EXPECT_EQ(files(folder()).size(), 6U);
}

TEST_F(ReferenceCache, ADamagedFileIsMadeAgain) {
  const TriangleMesh mesh = octahedron(10.0);
  const std::vector<double> whole = radii(mesh);
  const fs::path file = files(folder()).front();
  const std::string bytes = read_bytes(file);
  std::string changed = bytes;
  changed[17] = static_cast<char>(changed[17] ^ 1);
  for (const std::string& damaged :
       {changed, bytes.substr(0, bytes.size() - 8), bytes + "more", std::string("x")}) {
    write_bytes(file, damaged);
    EXPECT_EQ(bits(radii(mesh)), bits(whole));
    EXPECT_TRUE(measured_);
    EXPECT_EQ(read_bytes(file), bytes) << "and repaired";
  }
}

TEST_F(ReferenceCache, NoDirectionsAreNoTrouble) {
  directions_.clear();
  EXPECT_TRUE(radii(octahedron(10.0)).empty());
  EXPECT_TRUE(radii(octahedron(10.0)).empty());
}

}  // namespace
}  // namespace impinge::lab
