// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a gap measured on the faces holds the exact one between its ends, with digits to spare; the
// smallest gap of two scans lies between the ends that their bounds and the faces prove.
#include "detection/measured_gap.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/ball_socket_pair.hpp"
#include "reference/exact_radius.hpp"
#include "support/random_cases.hpp"
#include "support/soup.hpp"

namespace impinge {
namespace {

constexpr double kOracle = 0x1p-50;  // what rounding leaves of exact_radii() and of a length, as a share

// The gap of x by the oracle: exact but for the roundings of radius, length and difference.
double true_gap(const TriangleMesh& mesh, const Vec3& x, ScannedSurface scanned) {
  const bool ball = scanned == ScannedSurface::ball;
  const double radius =
      exact_radii(mesh, {.directions = {&x, 1}, .layer = ball ? Layer::nearest : Layer::farthest})[0];
  return ball ? radius - x.norm() : x.norm() - radius;
}

void expect_holds(const TriangleMesh& mesh, const NearFaces& faces, const Vec3& x, double widest) {
  for (const ScannedSurface scanned : {ScannedSurface::ball, ScannedSurface::socket}) {
    const CertifiedGap found =
        scanned == ScannedSurface::ball ? measured_ball_gap(faces, x) : measured_socket_gap(faces, x);
    const double gap = true_gap(mesh, x, scanned);
    ASSERT_EQ(found.cover == Cover::none, std::isnan(gap)) << x.transpose();
    if (found.cover == Cover::none) continue;
    const double slack = kOracle * (std::abs(gap) + x.norm());
    ASSERT_LE(found.low, gap + slack) << x.transpose();
    ASSERT_GE(found.high, gap - slack) << x.transpose();
    ASSERT_LE(found.high - found.low, widest) << x.transpose();
  }
}

TEST(MeasuredGap, OfAJointIsExactToAMillionthOfAMicrometre) {
  const BallSocketPair pair = make_ball_socket_pair(800, impinging_cam());
  const NearFaces socket(pair.socket, 0.0);
  const NearFaces ball(pair.ball, 0.0);
  for (const Vec3& x : pair.ball.vertices) expect_holds(pair.socket, socket, x, 1e-9);
  for (const Vec3& x : pair.socket.vertices) expect_holds(pair.ball, ball, x, 1e-9);
}

TEST(MeasuredGap, ThereIsNoneAtTheCentreAndWhereNoFaceIsMet) {
  const BallSocketPair pair = make_ball_socket_pair(60);
  const NearFaces socket(pair.socket, 0.0);
  EXPECT_EQ(measured_ball_gap(socket, Vec3::Zero()).cover, Cover::none);
  EXPECT_EQ(measured_ball_gap(socket, Vec3(0.0, 0.0, -20.0)).cover, Cover::none);
  EXPECT_EQ(measured_socket_gap(socket, Vec3::Zero()).cover, Cover::none);
}

// Faces that are seen more and more edge-on, slivers, and points next to corners and edges.
TEST(MeasuredGapAttack, HoldsTheExactGapOfSteepFacesAndSlivers) {
  std::mt19937_64 random(181);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (std::size_t k = 0; k < random_cases() / 2; ++k) {
    TriangleMesh mesh = test::soup(3, static_cast<unsigned>(k));
    const double tilt = std::pow(10.0, 8.0 * (unit(random) - 1.0));
    for (std::size_t f = 0; f < 2; ++f) {  // two of them nearly in a plane with the centre, or a sliver
      Vec3& c = mesh.vertices[3 * f + 2];
      const Vec3& a = mesh.vertices[3 * f];
      const Vec3& b = mesh.vertices[3 * f + 1];
      c = (f == 0 ? Vec3(0.7 * a + 0.9 * b) : Vec3(0.4 * a + 0.6 * b)) + tilt * vector();
    }
    const NearFaces faces(mesh, 0.0);
    for (const Face& face : mesh.faces) {
      const Vec3 inside =
          0.3 * corner(mesh, face, 0) + 0.5 * corner(mesh, face, 1) + 0.2 * corner(mesh, face, 2);
      const Vec3 edge = 0.5 * (corner(mesh, face, 0) + corner(mesh, face, 1));
      for (const Vec3& x :
           {inside, edge, corner(mesh, face, 2), Vec3(1.01 * inside), Vec3(inside + 1e-9 * vector())})
        expect_holds(mesh, faces, x, 200.0);
    }
  }
}

struct Scanned {
  std::vector<double> gap;
  std::vector<double> bound;
};

// A table that errs by up to its bound, of which some are large and some are missing.
Scanned disturbed(const std::vector<double>& truth, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Scanned scan;
  for (const double gap : truth) {
    const double kind = unit(random);
    const double bound = kind < 0.1 ? 60.0 : 0.05 * unit(random);
    scan.gap.push_back(gap + bound * (2.0 * unit(random) - 1.0));
    scan.bound.push_back(kind < 0.05 ? HUGE_VAL : bound);
  }
  return scan;
}

TEST(SmallestBetween, HoldsTheSmallestGapAndIsAsNarrowAsTheFaces) {
  const BallSocketPair pair = make_ball_socket_pair(600, impinging_cam());
  const NearFaces socket_faces(pair.socket, 0.0);
  const NearFaces ball_faces(pair.ball, 0.0);
  std::vector<double> ball;
  std::vector<double> socket;
  for (const Vec3& x : pair.ball.vertices) ball.push_back(true_gap(pair.socket, x, ScannedSurface::ball));
  for (const Vec3& x : pair.socket.vertices) socket.push_back(true_gap(pair.ball, x, ScannedSurface::socket));
  double smallest = HUGE_VAL;
  for (const double gap : ball) smallest = std::fmin(smallest, gap);
  for (const double gap : socket) smallest = std::fmin(smallest, gap);
  std::mt19937_64 random(18);
  for (int k = 0; k < 20; ++k) {
    const Scanned first = disturbed(ball, random);
    const Scanned second = disturbed(socket, random);
    const SmallestBetween found = smallest_between(
        {ScannedSurface::ball, socket_faces, pair.ball.vertices, first.gap, first.bound},
        {ScannedSurface::socket, ball_faces, pair.socket.vertices, second.gap, second.bound});
    EXPECT_LE(found.low, smallest + 1e-12);
    EXPECT_GE(found.high, smallest - 1e-12);
    EXPECT_LT(found.high - found.low, 1e-9);
    EXPECT_GT(found.measured, 0U);
    EXPECT_LT(found.measured, ball.size());
  }
}

TEST(SmallestBetween, IsInfiniteWhereNoVertexHasAGap) {
  const BallSocketPair pair = make_ball_socket_pair(60);
  const NearFaces faces(pair.socket, 0.0);
  const SmallestBetween found = smallest_between({ScannedSurface::ball, faces, {}, {}, {}},
                                                 {ScannedSurface::socket, faces, {}, {}, {}});
  EXPECT_TRUE(std::isinf(found.low) && std::isinf(found.high));
}

}  // namespace
}  // namespace impinge
