// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter of each family is what its shape really has.
#include "stress/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/validation.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/stored_table.hpp"
#include "stress/measure.hpp"
#include "stress/methods.hpp"
#include "stress/shapes.hpp"
#include "stress/slide.hpp"
#include "support/directions.hpp"
#include "table/exact_raster.hpp"
#include "table/near_faces.hpp"
#include "table/pairwise.hpp"
#include "table/partial_table.hpp"
#include "table/surface_index.hpp"

namespace impinge::lab {
namespace {

std::vector<double> radii(const TriangleMesh& mesh, const std::vector<Vec3>& directions, Layer layer) {
  return exact_radii(mesh, {directions, layer, {}});
}

// Rounding a corner moves it by 2^-49 mm: of 20 mm times the angle that is little down to 1e-12 degrees.
TEST(NearTangent, TheAimMeetsTheFaceAtTheAngle) {
  for (const double degrees : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
    for (const Vec3& aim : test::random_directions(20, 3)) {
      const TriangleMesh face = near_tangent_face(aim, degrees * kDegree);
      const double slope = conditions_along(face, {&aim, 1})[0].slope;
      EXPECT_NEAR(1.0 / slope, std::tan(degrees * kDegree), 1e-3 * degrees * kDegree + 3e-15);
      const double radius = radii(face, {aim}, Layer::nearest)[0];
      EXPECT_GT(radius, kAimedRadius - 5.0);
      EXPECT_LT(radius, kAimedRadius + 5.0);
    }
  }
}

TEST(NearTangent, TheWallIsSeenAsFarAsItReaches) {
  for (const double degrees : {30.0, 3.0, 0.1}) {
    for (const Vec3& aim : test::random_directions(20, 3)) {
      const double beside = degrees * kDegree;
      const TriangleMesh wall = near_tangent_wall(aim, beside);
      EXPECT_NEAR(1.0 / conditions_along(wall, {&aim, 1})[0].slope, std::tan(beside), 1e-9);
      EXPECT_NEAR(radii(wall, {aim}, Layer::nearest)[0], kAimedRadius, 1e-9);
      for (std::size_t k = 1; k <= kWallSides; ++k)
        EXPECT_NEAR(angle_between(wall.vertices[k], aim), wall_reach(beside), 1e-12);
    }
  }
}

double aspect_of(const TriangleMesh& mesh, const Face& face) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, (corner(mesh, face, k) - corner(mesh, face, (k + 1) % 3)).norm());
  return area_vector(mesh, face).norm() / (longest * longest);
}

TEST(Sliver, IsAsHighAsItSays) {
  for (const double aspect : {1.0, 1e-3, 1e-6, 1e-10}) {
    const TriangleMesh mesh = aimed_sliver({0.3, -0.5, 0.8}, aspect);
    EXPECT_NEAR(aspect_of(mesh, mesh.faces[0]), aspect, 0.3 * aspect + 1e-14);
    const StabilityScene body = slivered(sphere(22.0, 100), aspect);
    EXPECT_TRUE(validate(body.mesh).closed());
    if (aspect > 0.1) continue;
    EXPECT_NEAR(aspect_of(body.mesh, body.mesh.faces[0]), aspect, 0.05 * aspect + 1e-14);
  }
}

TEST(Sliver, HoldsItsAim) {
  const Vec3 aim = Vec3(0.3, -0.5, 0.8).normalized();
  for (const double aspect : {1.0, 1e-4, 1e-8, 1e-12}) {
    const TriangleMesh mesh = aimed_sliver(aim, aspect);
    EXPECT_TRUE(is_met(cone_of(mesh, mesh.faces[0]), aim, aim)) << aspect;
  }
}

TEST(Sliver, WithoutAreaIsFlatAndHasADuplicateCorner) {
  const TriangleMesh mesh = slivered(sphere(22.0, 100), 0.0).mesh;
  const TriangleMesh& m = mesh;
  std::size_t flat = 0;
  for (const Face& face : m.faces) flat += aspect_of(m, face) < 1e-14 ? 1U : 0U;
  EXPECT_EQ(flat, 200U) << "one on the side, one between two places, of each of 100 faces";
}

TEST(RayThroughEdgeOrVertex, CoordinatesAddWithoutRounding) {
  const TriangleMesh body = dyadic_body();
  EXPECT_TRUE(validate(body).closed());
  for (const Vec3& v : body.vertices) EXPECT_EQ((64.0 * v).eval(), Vec3((64.0 * v).array().round()));
  for (const Face& face : body.faces) {
    const Vec3& a = corner(body, face, 0);
    const Vec3& b = corner(body, face, 1);
    EXPECT_EQ(orientation(a, b, a + b), 0) << "the ray is in the plane of the edge, exactly";
  }
}

TEST(RayThroughEdgeOrVertex, PassesByUnitsInTheLastPlace) {
  const Vec3 x(1.0, -0.75, 0.0);
  ASSERT_EQ(ulps_beside(x, 0), std::vector<Vec3>{x});
  const auto beside = ulps_beside(x, 2);
  ASSERT_EQ(beside.size(), 6U);
  EXPECT_EQ(beside[1].x(), 1.0 + 0x1p-51);
  EXPECT_EQ(beside[0].x(), 1.0 - 0x1p-52) << "below a power of two they are half as long";
  EXPECT_EQ(beside[2].y(), -0.75 - 0x1p-52);
  EXPECT_EQ(beside[5].z(), 2.0 * std::numeric_limits<double>::denorm_min());
}

TEST(Fold, IsMetOnceALayer) {
  const Vec3 axis = Vec3(1.0, 2.0, 2.0).normalized();
  const Vec3 across = axis.unitOrthogonal();
  const Vec3 within = std::cos(40.0 * kDegree) * axis + std::sin(40.0 * kDegree) * across;
  for (const std::size_t layers : {2U, 5U, 20U}) {
    const TriangleMesh mesh = pleated(layers);
    std::size_t met = 0;
    for (const Face& face : mesh.faces) {
      const TriangleCone cone = cone_of(mesh, face);
      met += !cone.edge_on() && cone.contains(within) ? 1U : 0U;
    }
    EXPECT_EQ(met, layers);
    EXPECT_NEAR(radii(mesh, {within}, Layer::nearest)[0], 20.0, 0.7);
    EXPECT_NEAR(radii(mesh, {within}, Layer::farthest)[0], 19.0 + static_cast<double>(layers), 1.5);
  }
}

TEST(MeshNoise, HasTheSharesThatItSays) {
  const TriangleMesh clean = sphere(22.0, 2000);
  EXPECT_EQ(noisy(clean, 0.0, 1).faces, clean.faces);
  const MeshReport report = validate(noisy(clean, 0.1, 1));
  EXPECT_NEAR(static_cast<double>(report.duplicate_faces), 180.0, 60.0);
  EXPECT_NEAR(static_cast<double>(report.faces - report.duplicate_faces), 1800.0, 60.0);
  EXPECT_GT(report.boundary_edges, 300U);
  const TriangleMesh turned = noisy(clean, 0.1, 1);
  std::size_t inward = 0;
  for (const Face& face : turned.faces)
    inward += area_vector(turned, face).dot(corner(turned, face, 0)) < 0.0;
  EXPECT_NEAR(static_cast<double>(inward), 200.0, 60.0);
}

// The slide touches the face where it is told to, ever more gently: d gap / d angle ~ angle, so that the
// condition of the angle, r / |d gap / d angle| / angle, grows as 1 / angle^2.

constexpr double kRadius = 26.0;
// Below, errors of angles are allowed twice what was seen.

double rate(const PreciseSlide& slide, double angle) {
  const Precise at = angle;
  return Precise((slide.gap(at + 0x1p-60) - slide.gap(at)) * 0x1p60).convert_to<double>();
}

TEST(Slide, TouchesWhereItIsTold) {
  for (const double contact : {-0.1, -1e-3, -1e-6}) {
    const Slide slide = slide_touching_at(contact, kRadius);
    const PreciseSlide precise(slide, kRadius);
    const double found = precise.contact().convert_to<double>();
    EXPECT_NEAR(found / contact, 1.0, 3.7e-16 / (contact * contact));
    EXPECT_LT(abs(precise.gap(precise.contact())).convert_to<double>(), 1e-50);
    EXPECT_LT(rate(precise, found), 0.0) << "comes nearer";
    for (double angle = -0.5; angle <= 0.0; angle += 0.1)
      EXPECT_GT(slide.vertex(angle).minCoeff(), 1.0) << "in the octant of the face";
  }
}

TEST(Slide, IsAsStiffAsItsAngle) {
  const auto condition = [](double contact) {
    const Slide slide = slide_touching_at(contact, kRadius);
    return slide.vertex(0.0).norm() / std::abs(rate(PreciseSlide(slide, kRadius), contact) * contact);
  };
  EXPECT_NEAR(condition(-1e-4) / condition(-1e-3), 100.0, 1.0);
  EXPECT_NEAR(condition(-1e-5) / condition(-1e-4), 100.0, 1.0);
  EXPECT_GT(condition(-1e-5), 1e10);
}

// The octahedron in closed form, `off` mm too far out.
PointQuery octahedron_query(double off) {
  return one_by_one([off](const Vec3& x) { return octahedron_mesh_radius(x.normalized(), kRadius) + off; },
                    0.0);
}

TEST(Slide, ItsContactIsFoundToItsCondition) {
  const PointQuery exact = octahedron_query(0.0);
  for (const double contact : {-0.1, -1e-2, -1e-4}) {
    const Slide slide = slide_touching_at(contact, kRadius);
    const double truth = PreciseSlide(slide, kRadius).contact().convert_to<double>();
    const auto found = touching_angle(exact, slide, -0.5);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(*found / truth, 1.0, 5.3e-16 / (contact * contact));
  }
}

TEST(Slide, NoContactIsTold) {
  const Slide slide = slide_touching_at(-1e-3, kRadius);
  const PointQuery too_far = octahedron_query(0.1);
  EXPECT_FALSE(touching_angle(too_far, slide, -0.5).has_value());
  const PointQuery touching_at_once = octahedron_query(-5.0);
  EXPECT_FALSE(touching_angle(touching_at_once, slide, -0.5).has_value());
}

// A sliver answers as any face in its plane does, in every way of asking: |r - truth| <= 60 u (1 + tan psi)
// truth, and no more than twice the 3.2 u that were seen.

constexpr double kMost = 6.4;
static_assert(kMost < kRadiusThreshold);

// A sliver at every 20th entry of a small table.
struct Slivers {
  explicit Slivers(double aspect) : scheme(CubeGnomonic::with_precision(10.0)) {
    mesh = backdrop();
    for (std::size_t i = 7; i < scheme.size(); i += 20) {
      entries.push_back(i);
      aims.push_back(scheme.direction(i));
      append(mesh, aimed_sliver(aims.back(), aspect));
    }
    truth = exact_radii(mesh, {aims, Layer::nearest, {}});
    condition = conditions_along(mesh, aims);
  }

  // Largest error over condition and unit roundoff.
  template <class Radius>
  double largest_error(Radius&& radius_of) const {
    double largest = 0.0;
    for (std::size_t k = 0; k < aims.size(); ++k) {
      const double off = std::abs(radius_of(k) - truth[k]) / truth[k];
      largest = std::fmax(largest, std::isnan(off) ? 1e300 : off / condition[k].condition() / 0x1p-53);
    }
    return largest;
  }

  CubeGnomonic scheme;
  TriangleMesh mesh;
  std::vector<std::size_t> entries;
  std::vector<Vec3> aims;
  std::vector<double> truth;
  std::vector<RayCondition> condition;
};

class SliverAspects : public testing::TestWithParam<double> {};

TEST_P(SliverAspects, AnswerAsAnyFaceInItsPlane) {
  const Slivers slivers(GetParam());
  const TriangleMesh& mesh = slivers.mesh;
  ASSERT_GT(slivers.aims.size(), 20U);
  const auto expect_right = [&](const char* way, auto&& radius_of) {
    EXPECT_LT(slivers.largest_error(radius_of), kMost) << way;
  };
  const RayCaster caster(mesh);
  expect_right("pairwise", [&](std::size_t k) { return caster.cast(slivers.aims[k], Layer::nearest); });
  const RadialTable<CubeGnomonic> table = fill_exact(mesh, slivers.scheme, Layer::nearest);
  expect_right("table", [&](std::size_t k) { return table.radius_of(slivers.entries[k]); });
  const InverseDepthTable<CubeGnomonic> inverse(table);
  expect_right("inverse depths", [&](std::size_t k) {
    const double depth = slivers.scheme.depth(slivers.aims[k]);
    return 1.0 / (inverse.values()[slivers.entries[k]] * depth);
  });
  const SurfaceIndex index(mesh, Layer::nearest, 0.1);
  expect_right("surface index", [&](std::size_t k) { return index.radius(slivers.aims[k]); });
  const NearFaces near(mesh, 0.1);
  expect_right("near faces", [&](std::size_t k) { return near.radius(slivers.aims[k], Layer::nearest); });
  EntrySet set(slivers.scheme.size());
  for (const std::size_t entry : slivers.entries) set.insert(entry);
  set.number();
  const PartialTable partial =
      fill_partial(near, AnyScheme("cube_gnomonic", 10.0), std::move(set), Layer::nearest);
  expect_right("partial table", [&](std::size_t k) { return partial.radius_of(slivers.entries[k]); });
}

INSTANTIATE_TEST_SUITE_P(Sliver, SliverAspects, testing::Values(1.0, 1e-1, 1e-4, 1e-8, 1e-11, 1e-14));

}  // namespace
}  // namespace impinge::lab
