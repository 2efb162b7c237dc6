// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change the answer, and how the answer must change with what does. With s = 2^k, P a
// permutation of the axes:
//   r(s M, s x) = s r(M, x)                        bit for bit
//   r(P M, P x) = r(M, x)                          bit for bit in the exact reference, to rounding in tables
//   r(M with its faces or vertices in another order) = r(M)    bit for bit
// and nothing changes with the number of threads.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "mesh/bodies.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/stored_table.hpp"
#include "support/directions.hpp"
#include "support/soup.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

template <class S>
class Metamorphic : public testing::Test {};
using Schemes = testing::Types<CubeGnomonic, IcosahedralGnomonic, Usid>;
TYPED_TEST_SUITE(Metamorphic, Schemes);

constexpr double kPrecision = 4.0;

// Rims, cliffs and layers.
std::vector<TriangleMesh> meshes() {
  TriangleMesh off_centre = sphere(22.0, 200, Vec3(7.0, -3.0, 5.0));
  return {std::move(off_centre), cup(26.0, 75.0, 120), test::soup(25, 4)};
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Both radii or both none, bit for bit, and the same rim; one table in units `scale` times as large.
template <SamplingScheme S>
void expect_same(const RadialTable<S>& table, const RadialTable<S>& other, double scale = 1.0) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < table.radii().size(); ++i) {
    const double expected = table.radii()[i] * scale;
    const bool none = std::isnan(expected) && std::isnan(other.radii()[i]);
    if (!none && !same_bits(expected, other.radii()[i])) ++different;
  }
  EXPECT_EQ(different, 0U) << S::name;
  std::size_t rims = 0;
  for (std::size_t c = 0; c < table.scheme().cells(); ++c) {
    if (table.is_rim_cell(c) != other.is_rim_cell(c)) ++rims;
  }
  EXPECT_EQ(rims, 0U) << S::name;
}

template <SamplingScheme S>
RadialTable<S> filled(const TriangleMesh& mesh) {
  return fill_exact(mesh, S::with_precision(kPrecision), Layer::nearest);
}

TYPED_TEST(Metamorphic, ScaleByAPowerOfTwoScalesTheTable) {
  for (const TriangleMesh& mesh : meshes()) {
    const RadialTable<TypeParam> table = filled<TypeParam>(mesh);
    for (const int exponent : {-90, -1, 10, 90}) {
      const double scale = std::ldexp(1.0, exponent);
      TriangleMesh other = mesh;
      for (Vec3& v : other.vertices) v *= scale;
      expect_same(table, filled<TypeParam>(other), scale);
    }
  }
}

TYPED_TEST(Metamorphic, ScaleByAPowerOfTwoScalesTheGaps) {
  const TriangleMesh mesh = meshes()[1];
  std::vector<Vec3> vertices = test::random_directions(500, 6);
  for (Vec3& x : vertices) x *= 23.0;
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(0.4, Vec3(0.48, -0.6, 0.64)).toRotationMatrix();
  pose.translation = Vec3(0.5, -0.25, 1.0);
  std::vector<double> gaps(vertices.size());
  scan_gaps(filled<TypeParam>(mesh), vertices, pose, Surface::ball, gaps);
  for (const double scale : {0x1p-90, 0x1p90}) {
    TriangleMesh scaled_mesh = mesh;
    for (Vec3& v : scaled_mesh.vertices) v *= scale;
    std::vector<Vec3> scaled = vertices;
    for (Vec3& x : scaled) x *= scale;
    const Pose scaled_pose{pose.rotation, scale * pose.translation};
    std::vector<double> found(vertices.size());
    scan_gaps(filled<TypeParam>(scaled_mesh), scaled, scaled_pose, Surface::ball, found);
    for (std::size_t i = 0; i < gaps.size(); ++i)
      ASSERT_TRUE(same_bits(gaps[i] * scale, found[i]) || (std::isnan(gaps[i]) && std::isnan(found[i]))) << i;
  }
}

// A query has any length above zero.
TYPED_TEST(Metamorphic, ScaleOfAQueryChangesNothing) {
  const TypeParam scheme = TypeParam::with_precision(kPrecision);
  for (const Vec3& u : test::random_directions(300, 7)) {
    const Stencil expected = scheme.stencil(u);
    for (const int exponent : {-500, -100, 3, 100, 500}) {
      const Stencil found = scheme.stencil(std::ldexp(1.0, exponent) * u);
      ASSERT_EQ(found.cell, expected.cell) << exponent;
      for (std::size_t k = 0; k < expected.taps; ++k) {
        ASSERT_EQ(found.entry[k], expected.entry[k]) << exponent;
        ASSERT_TRUE(same_bits(found.weight[k], expected.weight[k])) << exponent;
      }
    }
  }
}

TYPED_TEST(Metamorphic, OrderOfFacesChangesNothing) {
  std::mt19937_64 random(8);
  for (const TriangleMesh& mesh : meshes()) {
    TriangleMesh other = mesh;
    std::shuffle(other.faces.begin(), other.faces.end(), random);
    expect_same(filled<TypeParam>(mesh), filled<TypeParam>(other));
  }
}

TYPED_TEST(Metamorphic, OrderOfVerticesChangesNothing) {
  std::mt19937_64 random(9);
  for (const TriangleMesh& mesh : meshes()) {
    std::vector<VertexIndex> place(mesh.vertices.size());
    std::iota(place.begin(), place.end(), VertexIndex{0});
    std::shuffle(place.begin(), place.end(), random);
    TriangleMesh other = mesh;
    for (std::size_t v = 0; v < place.size(); ++v) other.vertices[place[v]] = mesh.vertices[v];
    for (Face& face : other.faces) {
      for (VertexIndex& v : face) v = place[v];
    }
    expect_same(filled<TypeParam>(mesh), filled<TypeParam>(other));
  }
}

// The plane of a face is computed from its first corner: which one that is shows in the last bits alone, at
// most as often as the radius of each may be off. A face that is turned over is met alike.
TYPED_TEST(Metamorphic, OrderOfCornersIsRounding) {
  const TriangleMesh mesh = meshes()[0];
  const RadialTable<TypeParam> table = filled<TypeParam>(mesh);
  TriangleMesh turned = mesh;
  for (Face& face : turned.faces) face = {face[1], face[2], face[0]};
  TriangleMesh flipped = mesh;
  for (Face& face : flipped.faces) face = {face[0], face[2], face[1]};
  for (const TriangleMesh& other : {turned, flipped}) {
    const RadialTable<TypeParam> found = filled<TypeParam>(other);
    for (std::size_t i = 0; i < table.radii().size(); ++i)
      ASSERT_NEAR(found.radii()[i] / table.radii()[i], 1.0, 2e-14) << i;
  }
}

Vec3 permuted(const Vec3& x) { return {x.y(), x.z(), x.x()}; }

TriangleMesh permuted(TriangleMesh mesh) {
  for (Vec3& v : mesh.vertices) v = permuted(v);
  return mesh;
}

TEST(AxisPermutation, ChangesNoBitOfTheExactReference) {
  for (const TriangleMesh& mesh : meshes()) {
    std::vector<Vec3> directions = test::random_directions(200, 10);
    const std::vector<double> radii = exact_radii(mesh, {directions, Layer::nearest, {}});
    for (Vec3& u : directions) u = permuted(u);
    const std::vector<double> found = exact_radii(permuted(mesh), {directions, Layer::nearest, {}});
    for (std::size_t i = 0; i < radii.size(); ++i)
      ASSERT_TRUE(same_bits(radii[i], found[i]) || (std::isnan(radii[i]) && std::isnan(found[i]))) << i;
  }
}

// The entries of a cube are the same after a permutation of its axes, so that only the order of three
// summands is another one.
TEST(AxisPermutation, IsRoundingInATableThatHasTheSymmetry) {
  for (const TriangleMesh& mesh : {meshes()[0], meshes()[1]}) {
    const RadialTable<CubeGnomonic> table = filled<CubeGnomonic>(mesh);
    const RadialTable<CubeGnomonic> other = filled<CubeGnomonic>(permuted(mesh));
    std::size_t answered = 0;
    for (const Vec3& u : test::random_directions(2000, 11)) {
      const double radius = table.radius_at(u);
      const double found = other.radius_at(permuted(u));
      ASSERT_EQ(std::isnan(radius), std::isnan(found)) << u.transpose();
      if (std::isnan(radius)) continue;
      ASSERT_NEAR(found / radius, 1.0, 2e-14);
      ++answered;
    }
    EXPECT_GT(answered, 500U);
  }
}

// Many threads read one table and fill tables of their own at the same time.
TYPED_TEST(Metamorphic, NumberOfThreadsChangesNothing) {
  const TriangleMesh mesh = meshes()[0];
  const RadialTable<TypeParam> table = filled<TypeParam>(mesh);
  const std::vector<Vec3> directions = test::random_directions(2000, 12);
  std::vector<double> expected;
  for (const Vec3& u : directions) expected.push_back(table.radius_at(u));
  for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
    std::vector<std::vector<double>> answers(threads);
    std::vector<RadialTable<TypeParam>> tables(threads, RadialTable<TypeParam>(table.scheme()));
    {
      std::vector<std::jthread> running;
      for (std::size_t k = 0; k < threads; ++k) {
        running.emplace_back([&, k] {
          for (const Vec3& u : directions) answers[k].push_back(table.radius_at(u));
          tables[k] = filled<TypeParam>(mesh);
        });
      }
    }
    for (std::size_t k = 0; k < threads; ++k) {
      EXPECT_EQ(answers[k], expected);
      expect_same(table, tables[k]);
    }
  }
}

}  // namespace
}  // namespace impinge::lab
