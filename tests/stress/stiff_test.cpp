// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "contact/culled_joint.hpp"
#include "gap/simd/exact_cells.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/infinity.hpp"
#include "stress/measure.hpp"
#include "stress/slide.hpp"
#include "stress/stiff_surfaces.hpp"
#include "stress/table_kernels.hpp"
#include "support/every_vertex.hpp"
#include "support/poses.hpp"
#include "table/packed_fixture.hpp"

namespace impinge::lab {
namespace {

// Exact cells over the surfaces of the stiff and extreme families. Contract, at points that are floats: an
// answer exactly where the mesh has one, and
//   |gap - gap of the mesh| <= u (18 r + 8 |gap|)
// and what the plane of a face costs in double, 60 2^-53 (1 + tan psi) r

using test::StiffSurface;

constexpr double kStiffUnit = 0x1p-24;
// Of what is allowed 0.19 was seen at most: no more than twice as much may be.
constexpr double kExactShare = 0.38;

std::vector<float> gaps_in(const ExactCells& cells, const std::vector<Vec3>& points, Surface scanned) {
  std::vector<float> gap(points.size());
  scan_gaps(cells, packed_vertices<float>(points), {}, scanned, gap);
  return gap;
}

class StiffExactCells : public testing::TestWithParam<test::StiffFamily> {};
INSTANTIATE_TEST_SUITE_P(Families, StiffExactCells, testing::ValuesIn(test::stiff_families()), test::name_of);

TEST_P(StiffExactCells, AnswerAsTheMesh) {
  const StiffSurface surface = GetParam().make();
  const auto points = test::stiff_points(surface);
  const auto truth = exact_radii(surface.mesh, {points, surface.layer, {}});
  for (const double cells_a_face : {4.0, 0.2}) {
    const ExactCells cells = exact_cells(surface.mesh, surface.layer, cells_a_face);
    const auto ball = gaps_in(cells, points, Surface::ball);
    const auto socket = gaps_in(cells, points, Surface::socket);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(std::isnan(ball[i]), std::isnan(truth[i])) << points[i].transpose();
      EXPECT_EQ(std::isnan(socket[i]), std::isnan(truth[i])) << points[i].transpose();
      if (std::isnan(truth[i]) || std::isnan(ball[i])) continue;
      const double gap = truth[i] - points[i].norm();
      const double off = std::fmax(std::abs(ball[i] - gap), std::abs(socket[i] + gap));
      const double rounding = kStiffUnit * (18.0 * truth[i] + 8.0 * std::abs(gap));
      if (off <= kExactShare * rounding) continue;
      const double steep = conditions_along(surface.mesh, {&points[i], 1})[0].condition();
      EXPECT_LE(off, kExactShare * (rounding + kRadiusThreshold * 0x1p-53 * steep * truth[i]))
          << points[i].transpose();
    }
  }
}

// The culled answers over the surfaces of the stiff and extreme families, as ball and as socket. Contract, in
// every pose: impinged() as some vertex by exact signs, least_gap() the least of all vertices bit for bit

struct Touches {
  std::size_t touching = 0;
  std::size_t free = 0;
};

void expect_as_every_vertex(const BallSocketPair& joint, const std::vector<Pose>& poses, Touches& seen) {
  const CulledJoint culled(joint);
  const test::EveryVertex every(joint);
  for (const Pose& pose : poses) {
    const bool expected = every.impinged(pose);
    EXPECT_EQ(culled.impinged(pose).has_value(), expected) << pose.translation.transpose();
    EXPECT_EQ(culled.least_gap(pose), every.least_gap(pose)) << pose.translation.transpose();
    ++(expected ? seen.touching : seen.free);
  }
}

// Steps along a motion from none at all and 10^-12 to half a turn and 10^6 mm.
std::vector<Pose> tiny_and_huge_steps() {
  std::vector<Pose> poses(2);
  for (const double step : {1e-12, 1e-6, 1e-2, 0.3}) {
    for (int k = 0; k < 2; ++k) {
      Pose pose = poses.back();
      pose.rotation = pose.rotation * Eigen::AngleAxisd(step, Vec3(0.6, 0.0, -0.8)).toRotationMatrix();
      pose.translation += 2.0 * step * Vec3(0.0, 0.6, 0.8);
      poses.push_back(pose);
    }
  }
  for (const Pose& pose : test::random_poses(3, kPi, 4.0, 3)) poses.push_back(pose);
  for (const double far : {30.0, 1e3, 1e6}) {
    poses.push_back({});
    poses.push_back({Eigen::AngleAxisd(kPi, Vec3::UnitX()).toRotationMatrix(), far * Vec3(0.0, -0.8, 0.6)});
  }
  return poses;
}

// Of the vertices, mm.
struct Lengths {
  double least = kInfinity;
  double largest = 0.0;
};
Lengths lengths_of(const TriangleMesh& mesh) {
  Lengths lengths;
  for (const Vec3& v : mesh.vertices) {
    lengths.least = std::fmin(lengths.least, v.norm());
    lengths.largest = std::fmax(lengths.largest, v.norm());
  }
  return lengths;
}

TriangleMesh times(TriangleMesh mesh, double factor) {
  for (Vec3& v : mesh.vertices) v *= factor;
  return mesh;
}

class StiffJoints : public testing::TestWithParam<test::StiffFamily> {};
INSTANTIATE_TEST_SUITE_P(Families, StiffJoints, testing::ValuesIn(test::stiff_families()), test::name_of);

TEST_P(StiffJoints, AnswerAsEveryVertexAlongTinyAndHugeSteps) {
  const std::vector<Pose> poses = tiny_and_huge_steps();
  const BallSocketPair ordinary = make_ball_socket_pair(120);
  const TriangleMesh stiff = GetParam().make().mesh;
  const Lengths lengths = lengths_of(stiff);
  const double wide = 1.1 * lengths.largest / lengths_of(ordinary.socket).least;
  const double small = 0.5 * lengths.least / lengths_of(ordinary.ball).largest;
  Touches seen;
  expect_as_every_vertex({stiff, times(ordinary.socket, wide)}, poses, seen);
  expect_as_every_vertex({times(ordinary.ball, small), stiff}, poses, seen);
  expect_as_every_vertex({ordinary.ball, stiff}, poses, seen);
  EXPECT_GT(seen.touching, 0U);
  EXPECT_GT(seen.free, 0U);
}

// A vertex that slides along the face of an octahedron and is through it at `contact`: angles there and
// beside it, down to neighbouring doubles.
TEST(StiffCulling, AVertexThatSlidesThroughAFaceTouchesAtTheSameAngle) {
  constexpr double kSocketRadius = 26.0;
  Touches seen;
  for (const double degrees : {10.0, 1e-1, 1e-3, 1e-5}) {
    SCOPED_TRACE(degrees);
    const double contact = -degrees * kDegree;
    const Slide slide = slide_touching_at(contact, kSocketRadius);
    BallSocketPair joint{octahedron(1.0), octahedron(kSocketRadius)};
    joint.ball.vertices[0] = slide.vertex(0.0);
    std::vector<Pose> poses;
    for (const double beside : {-1.0, -1e-3, -1e-6, -1e-9, -1e-14, 0.0, 1e-14, 1e-9, 1e-6, 1e-3, 0.5}) {
      const double angle = contact * (1.0 - beside);
      poses.push_back({Eigen::AngleAxisd(angle, slide.axis).toRotationMatrix(), Vec3::Zero()});
    }
    expect_as_every_vertex(joint, poses, seen);
  }
  EXPECT_GT(seen.touching, 10U);
  EXPECT_GT(seen.free, 10U);
}

// The kernels that read tables, over the surfaces of the stiff and extreme families. Contract, at points that
// are floats:
//   |gap of the kernel - gap of the scalar look-up| <= what the kernel's header derives
//   |gap of the kernel - gap of the mesh|           <= that, storage and the proven bound of the table
// with an answer where the scalar look-up has one, and nowhere where the mesh has none, but within rounding
// of a grid line

using test::StiffSurface;
using test::TableKernel;

// What was met on the way, so that no test is empty.
struct Met {
  std::size_t answered = 0;
  std::size_t none = 0;
  std::size_t otherwise = 0;  // on a grid line
};

// Within rounding of x, is there an answer of the scalar look-up, or none, as the kernel says?
bool said_close_by(const TableKernel& kernel, const Vec3& x, bool none) {
  return std::ranges::any_of(test::close_to(x, 64.0 * kernel.unit()),
                             [&](const Vec3& near) { return std::isnan(kernel.radius_at(near)) == none; });
}

bool met_close_by(const StiffSurface& surface, const Vec3& x, double unit) {
  const auto near = test::close_to(x, 64.0 * unit);
  const auto radii = exact_radii(surface.mesh, {near, surface.layer, {}});
  return std::ranges::any_of(radii, [](double r) { return !std::isnan(r); });
}

struct Held {
  const StiffSurface& surface;
  const TableKernel& kernel;
  const std::vector<Vec3>& points;
  const std::vector<double>& truth;  // radius of the mesh
};

void expect_held(const Held& held, Surface scanned, Met& met) {
  const TableKernel& kernel = held.kernel;
  const double bound = kernel.bound();
  const double sign = scanned == Surface::ball ? 1.0 : -1.0;
  const auto gap = kernel.gaps(held.points, {}, scanned);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const Vec3& x = held.points[i];
    const double radius = kernel.radius_at(x);
    ++(std::isnan(gap[i]) ? met.none : met.answered);
    if (std::isnan(gap[i]) != std::isnan(radius)) {
      ++met.otherwise;
      EXPECT_TRUE(said_close_by(kernel, x, std::isnan(gap[i]))) << x.transpose();
    }
    if (std::isnan(gap[i]) || std::isnan(radius)) continue;
    const double off = std::abs(gap[i] - sign * (radius - x.norm()));
    const bool close = off <= 20.0 * kernel.unit() * (radius + x.norm());  // whatever the steps of the table
    const double rounding = close ? off : kernel.rounding(x, radius);
    EXPECT_LE(off, rounding) << x.transpose();
    if (std::isnan(held.truth[i])) {
      EXPECT_TRUE(met_close_by(held.surface, x, kernel.unit())) << x.transpose();
      continue;
    }
    EXPECT_LE(std::abs(gap[i] - sign * (held.truth[i] - x.norm())), bound + rounding) << x.transpose();
  }
}

class StiffTables : public testing::TestWithParam<test::StiffFamily> {};
INSTANTIATE_TEST_SUITE_P(Families, StiffTables, testing::ValuesIn(test::stiff_families()), test::name_of);

TEST_P(StiffTables, AnswerAsTheScalarLookUpAndWithinTheProvenBound) {
  const StiffSurface surface = GetParam().make();
  const auto points = test::stiff_points(surface);
  const auto truth = exact_radii(surface.mesh, {points, surface.layer, {}});
  Met met;
  Surface scanned = Surface::ball;
  for (const auto& kernel : test::table_kernels(surface.mesh, surface.layer, test::kStiffPrecision, true)) {
    SCOPED_TRACE(kernel->name());
    expect_held({surface, *kernel, points, truth}, scanned, met);
    scanned = other(scanned);
  }
  EXPECT_GT(met.answered, 0U);
  EXPECT_LT(met.otherwise, (met.answered + met.none) / 20);
}

}  // namespace
}  // namespace impinge::lab
