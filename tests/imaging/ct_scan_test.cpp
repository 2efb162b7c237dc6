// SPDX-License-Identifier: GPL-3.0-or-later
// Contract:
//   value of a voxel = share of it inside of the body; along x exact, so that the sum over a row of voxels is
//   the length inside, and that over all of them the volume, to the spacing of the lines
#include "imaging/ct_scan.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/validation.hpp"
#include "support/joined.hpp"

namespace impinge {
namespace {

// A box with outward normals.
TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

double volume_of(const VoxelImage& image) {
  return std::accumulate(image.values.begin(), image.values.end(), 0.0) * image.spacing.prod();
}

TEST(BoneShares, OfABoxAreProductsOfLengths) {
  const TriangleMesh body = box(Vec3(0.13, -1.0, -2.0), Vec3(2.71, 1.0, 2.0));
  ASSERT_TRUE(validate(body).closed());
  ASSERT_GT(*validate(body).volume, 0.0);
  const VoxelImage image = bone_shares(body, {0.5, 1.0, 1.0});
  for (std::size_t k = 0; k < image.count[2]; ++k) {
    for (std::size_t j = 0; j < image.count[1]; ++j) {
      for (std::size_t i = 0; i < image.count[0]; ++i) {
        const Vec3 middle =
            image.origin + Vec3(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k))
                               .cwiseProduct(image.spacing);
        const auto covered = [&](int axis, double low, double high) {
          const double half = 0.5 * image.spacing[axis];
          return std::max(0.0, std::min(high, middle[axis] + half) - std::max(low, middle[axis] - half)) /
                 (2 * half);
        };
        const double across = covered(1, -1.0, 1.0) * covered(2, -2.0, 2.0);
        const double share = image.values[image.index(i, j, k)];
        const bool cut = across > 0.0 && across < 1.0;  // by lines, to half of their spacing
        EXPECT_NEAR(share, covered(0, 0.13, 2.71) * across, cut ? 0.3 : 1e-6) << middle.transpose();
      }
    }
  }
}

TEST(BoneShares, SumUpToTheVolume) {
  for (const double slice : {0.5, 1.25, 5.0}) {
    const TriangleMesh body = sphere(6.0, 400, Vec3(0.2, -0.4, 0.7));
    const VoxelImage image = bone_shares(body, {0.7, slice, 2.0});
    EXPECT_NEAR(volume_of(image) / *validate(body).volume, 1.0, 0.002) << slice;
    for (const float share : image.values) ASSERT_TRUE(share >= 0.0F && share <= 1.0F + 1e-5F);
    EXPECT_EQ(image.values.front(), 0.0F);
  }
}

// Lines through vertices and along edges: the corners of an octahedron stand on the middle lines of its
// image.
TEST(BoneShares, MeetEdgesAndVerticesOnce) {
  const TriangleMesh body = octahedron(3.0);
  EXPECT_NEAR(volume_of(bone_shares(body, {0.75, 0.75, 0.0})) / 36.0, 1.0, 0.02);
  EXPECT_NEAR(volume_of(bone_shares(body, {0.5, 0.5, 1.0})) / 36.0, 1.0, 0.02);
}

TEST(BoneShares, OfTwoWallsLeaveTheCavityOut) {
  const TriangleMesh shell = test::joined(sphere(6.0, 400), test::inside_out(sphere(4.0, 400)));
  const VoxelImage image = bone_shares(shell, {0.5, 0.5, 1.0});
  EXPECT_NEAR(volume_of(image) / *validate(shell).volume, 1.0, 0.005);
}

TEST(BoneShares, RefuseWhatCannotBeScanned) {
  EXPECT_THROW(bone_shares(cup(6.0, 80.0, 100), {}), std::invalid_argument) << "an open surface";
  EXPECT_THROW(bone_shares(octahedron(3.0), {0.0, 1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(bone_shares(octahedron(3.0), {0.001, 0.001, 1.0}), std::invalid_argument) << "too many voxels";
  EXPECT_THROW(bone_shares({}, {}), std::invalid_argument);
}

TEST(Hounsfield, HasTheLevelsAndTheNoise) {
  const VoxelImage shares = bone_shares(sphere(6.0, 400), {0.5, 0.5, 2.0});
  ScanLevels levels;
  levels.noise = 0.0;
  const VoxelImage clean = hounsfield(shares, levels);
  EXPECT_EQ(clean.values.front(), 50.0F);
  EXPECT_NEAR(clean.values[clean.index(clean.count[0] / 2, clean.count[1] / 2, clean.count[2] / 2)], 850.0,
              1e-3);
  levels.noise = 25.0;
  levels.seed = 3;
  const VoxelImage noisy = hounsfield(shares, levels);
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < noisy.values.size(); ++i) {
    const double off = static_cast<double>(noisy.values[i]) - static_cast<double>(clean.values[i]);
    sum += off;
    squares += off * off;
  }
  const auto n = static_cast<double>(noisy.values.size());
  EXPECT_NEAR(sum / n, 0.0, 5.0 * 25.0 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 25.0, 0.5);
  EXPECT_EQ(hounsfield(shares, levels).values, noisy.values);
  levels.seed = 4;
  EXPECT_NE(hounsfield(shares, levels).values, noisy.values);
}

}  // namespace
}  // namespace impinge
