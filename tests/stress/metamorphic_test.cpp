// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change the answer, and how the answer must change with what does. With s = 2^k, P a
// permutation of the axes:
//   r(s M, s x) = s r(M, x)                        bit for bit
//   r(P M, P x) = r(M, x)                          bit for bit in the exact reference, to rounding in tables
//   r(M with its vertices in another order) = r(M)    bit for bit
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <exception>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "gap/simd/exact_cells.hpp"
#include "mesh/bodies.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/as_floats.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/usid.hpp"
#include "stress/shapes.hpp"
#include "stress/stiff_surfaces.hpp"
#include "stress/table_kernels.hpp"
#include "support/bits.hpp"
#include "support/directions.hpp"
#include "support/soup.hpp"
#include "table/exact_raster.hpp"

namespace impinge::test {

// What every kernel answers, from the mesh on, as lists of numbers that can be compared.

using namespace lab;

// Points in a pose, and the surface that they are asked of.
struct Questions {
  TriangleMesh mesh;
  Layer layer = Layer::nearest;
  std::vector<Vec3> points;
  Pose pose;
  double unit = 1.0;  // of length, over that of what is stated in mm
};

// Gaps, mm; NaN for none.
using Answers = std::vector<double>;

// Of the exact cells.
inline Answers exact_answers(const Questions& asked) {
  std::vector<float> gap(asked.points.size());
  scan_gaps(exact_cells(asked.mesh, asked.layer), packed_vertices<float>(asked.points), asked.pose,
            Surface::ball, gap);
  return {gap.begin(), gap.end()};
}

// Of all table kernels, one after the other.
inline Answers table_answers(const Questions& asked) {
  Answers all;
  for (const auto& kernel : table_kernels(asked.mesh, asked.layer, 15.0)) {
    const Answers gaps = kernel->gaps(asked.points, asked.pose, Surface::ball);
    all.insert(all.end(), gaps.begin(), gaps.end());
  }
  return all;
}

// A kernel, from the mesh on.
struct Answerer {
  const char* name;
  std::function<Answers(const Questions&)> answer;
};
// All of them.
inline const std::vector<Answerer>& answerers() {
  static const std::vector<Answerer> all{{"tables", table_answers}, {"exact cells", exact_answers}};
  return all;
}

// A surface of each kind: exact coordinates, layers, holes, cliffs everywhere.
struct NamedSurface {
  const char* name;
  StiffSurface surface;
};
inline std::vector<NamedSurface> some_surfaces() {
  return {{"dyadic", {dyadic_body()}},
          {"pleated", {pleated(3)}},
          {"noise", {noisy(sphere(22.0, 200, {2.0, -3.0, 1.0}), 0.1, 3)}},
          {"soup", {soup(30, 9), Layer::farthest}}};
}

// At random and at its corners.
inline Questions questions_for(const StiffSurface& surface) {
  Questions asked{surface.mesh, surface.layer, {}, {}};
  for (const Vec3& u : random_directions(200, 4)) asked.points.push_back(as_floats(23.0 * u));
  for (std::size_t v = 0; v < surface.mesh.vertices.size(); v += 3)
    asked.points.push_back(as_floats(surface.mesh.vertices[v]));
  return asked;
}

}  // namespace impinge::test

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

// What must not change, or change by a known factor, in what the kernels and the culled answers say:
//   units of a power of two    the same digits, bit for bit, or a refusal of one line
//   a pose without rounding    what the moved points give, bit for bit, whatever the translation
//   the order of faces         the same bits; of vertices, the same bits in that order
//   threads that share tables  the same bits

using test::Answerer;
using test::Answers;
using test::Questions;

// Bit for bit, all NaN alike, in units of `unit`.
void expect_same(const Answers& answers, const Answers& expected, double unit = 1.0) {
  ASSERT_EQ(answers.size(), expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const bool none = std::isnan(answers[i]) && std::isnan(expected[i]);
    if (!none && test::bits(answers[i]) != test::bits(unit * expected[i])) ++different;
  }
  EXPECT_EQ(different, 0U) << "of " << answers.size();
}

TEST(StiffMetamorphic, UnitsOfAPowerOfTwoAreTheSameBitsOrRefused) {
  std::size_t answered = 0;
  for (const auto& [name, surface] : test::some_surfaces()) {
    const Questions asked = test::questions_for(surface);
    for (const Answerer& by : test::answerers()) {
      const Answers expected = by.answer(asked);
      for (const int exponent : {-200, -110, -90, -66, -40, 10, 66, 90, 110, 200}) {
        SCOPED_TRACE(std::string(name) + ", " + by.name + ", 2^" + std::to_string(exponent));
        Questions scaled = asked;
        scaled.unit = std::ldexp(1.0, exponent);
        for (Vec3& v : scaled.mesh.vertices) v *= scaled.unit;
        for (Vec3& x : scaled.points) x *= scaled.unit;
        try {
          expect_same(by.answer(scaled), expected, scaled.unit);
          ++answered;
        } catch (const std::exception& refused) {
          const std::string line = refused.what();
          EXPECT_GT(line.size(), 20U);
          EXPECT_EQ(line.find('\n'), std::string::npos) << line;
          EXPECT_GT(std::abs(exponent), 40) << line;
        }
      }
    }
  }
  EXPECT_EQ(answered, 16U);  // by both, of four surfaces, in units of 2^-40 and 2^10 mm
}

// Quarter turns and translations by multiples of 2^-8 mm move points of the same grid without rounding.
TEST(StiffMetamorphic, APoseWithoutRoundingIsThatOfTheMovedPoints) {
  for (const auto& [name, surface] : test::some_surfaces()) {
    Questions moved = test::questions_for(surface);
    for (Vec3& x : moved.points) x = (0x1p8 * x).array().round().matrix() * 0x1p-8;
    std::erase_if(moved.points, [](const Vec3& x) { return x.isZero(0.0); });
    const Answers tables = test::table_answers(moved);
    const Answers exact = test::exact_answers(moved);
    for (const double far : {0.0, 30000.0}) {
      SCOPED_TRACE(std::string(name) + ", " + std::to_string(far) + " mm");
      Questions asked = moved;
      asked.pose.translation = far * Vec3(1.0, -0.5, 0.75);
      asked.pose.rotation << 0, 0, -1, 1, 0, 0, 0, -1, 0;
      for (Vec3& x : asked.points) x = to_ball(asked.pose, x);
      expect_same(test::table_answers(asked), tables);
      expect_same(test::exact_answers(asked), exact);
    }
  }
}

TEST(StiffMetamorphic, TheOrderOfFacesAndVerticesChangesNothing) {
  std::mt19937_64 random(6);
  for (const auto& [name, surface] : test::some_surfaces()) {
    const Questions asked = test::questions_for(surface);
    std::vector<std::size_t> order(asked.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::shuffle(order, random);
    Questions shuffled = asked;
    std::ranges::shuffle(shuffled.mesh.faces, random);
    for (std::size_t i = 0; i < order.size(); ++i) shuffled.points[i] = asked.points[order[i]];
    for (const Answerer& by : test::answerers()) {
      SCOPED_TRACE(std::string(name) + ", " + by.name);
      const Answers answers = by.answer(asked);
      Answers expected;
      for (std::size_t first = 0; first < answers.size(); first += order.size())
        for (const std::size_t i : order) expected.push_back(answers[first + i]);
      expect_same(by.answer(shuffled), expected);
    }
  }
}

TEST(StiffMetamorphic, ThreadsThatShareATableGetTheSameBits) {
  for (const auto& [name, surface] : test::some_surfaces()) {
    SCOPED_TRACE(name);
    const Questions asked = test::questions_for(surface);
    const auto kernels = test::table_kernels(asked.mesh, asked.layer, 15.0);
    std::vector<Answers> each(3 * kernels.size());
    {
      std::vector<std::jthread> threads;
      for (std::size_t t = 0; t < 3; ++t)
        threads.emplace_back([&, t] {
          for (std::size_t k = 0; k < kernels.size(); ++k)
            each[t * kernels.size() + k] = kernels[k]->gaps(asked.points, asked.pose, Surface::ball);
        });
    }
    for (std::size_t k = 0; k < each.size(); ++k)
      expect_same(each[k], kernels[k % kernels.size()]->gaps(asked.points, asked.pose, Surface::ball));
  }
}

}  // namespace
}  // namespace impinge::lab
