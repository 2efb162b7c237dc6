// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change the answer, and how the answer must change with what does. With s = 2^k, P a
// permutation of the axes:
//   r(s M, s x) = s r(M, x)                        bit for bit
//   r(P M, P x) = r(M, x)                          bit for bit in the exact reference, to rounding in tables
//   r(M with its vertices in another order) = r(M)    bit for bit
// (Gaps, the order of faces and threads: stiff_metamorphic_test.cpp.)
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/usid.hpp"
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

}  // namespace
}  // namespace impinge::lab
