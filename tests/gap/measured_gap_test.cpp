// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a gap measured on the faces holds the exact one between its ends, with digits to spare; the
// smallest gap of two scans lies between the ends that their bounds and the faces prove.
#include "gap/measured_gap.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "gap/certified_gap.hpp"
#include "gap/exact_side.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "reference/exact_radius.hpp"
#include "reference/shadow.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "support/poses.hpp"
#include "support/random_cases.hpp"
#include "support/random_vector.hpp"
#include "support/soup.hpp"

namespace impinge {
namespace {

TEST(CertifiedGap, IsImpingedWhereASurfaceCoversItAndClearWhereNoneDoes) {
  const auto verdict = [](double low, double high, Cover cover) {
    const CertifiedGap gap = certified(low, high, cover);
    EXPECT_EQ(gap.verdict, verdict_of(low, high, cover));
    return gap.verdict;
  };
  for (const Cover cover : {Cover::none, Cover::part, Cover::whole})
    EXPECT_EQ(verdict(0.1, 0.2, cover), Verdict::clear);
  EXPECT_EQ(verdict(HUGE_VAL, -HUGE_VAL, Cover::none), Verdict::clear);
  EXPECT_EQ(verdict(-0.2, -0.1, Cover::none), Verdict::clear);
  EXPECT_EQ(verdict(-0.2, 0.0, Cover::whole), Verdict::impinged);
  EXPECT_EQ(verdict(-0.2, 0.1, Cover::whole), Verdict::undecided);
  EXPECT_EQ(verdict(0.0, 0.1, Cover::whole), Verdict::undecided);
  EXPECT_EQ(verdict(-0.2, -0.1, Cover::part), Verdict::undecided) << "the surface may be missing there";
}

constexpr auto kHalfUnit = static_cast<long double>(kExactRadiusError);

// The gap of x by the oracle, exact but for half a unit in the last place of the radius.
long double true_gap(const TriangleMesh& mesh, const Vec3& x, Surface scanned) {
  const bool ball = scanned == Surface::ball;
  const long double radius =
      exact_radii(mesh, {.directions = {&x, 1}, .layer = ball ? Layer::nearest : Layer::farthest})[0];
  const long double length = x.cast<long double>().norm();
  return ball ? radius - length : length - radius;
}

CertifiedGap measured_gap(const NearFaces& faces, const Vec3& x, Surface scanned) {
  return measured_gap(scanned, faces, x);
}

void expect_holds(const TriangleMesh& mesh, const NearFaces& faces, const Vec3& x, double widest) {
  for (const Surface scanned : {Surface::ball, Surface::socket}) {
    const CertifiedGap found = measured_gap(faces, x, scanned);
    const long double gap = true_gap(mesh, x, scanned);
    ASSERT_EQ(found.cover == Cover::none, std::isnan(gap)) << x.transpose();
    if (found.cover == Cover::none) continue;
    // Of the radius, and of the length in long double.
    const long double slack =
        kHalfUnit * (x.norm() + (scanned == Surface::ball ? gap : -gap)) + 0x1p-60L * x.norm();
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
  EXPECT_EQ(measured_gap(Surface::ball, socket, Vec3::Zero()).cover, Cover::none);
  EXPECT_EQ(measured_gap(Surface::ball, socket, Vec3(0.0, 0.0, -20.0)).cover, Cover::none);
  EXPECT_EQ(measured_gap(Surface::socket, socket, Vec3::Zero()).cover, Cover::none);
}

// A sphere within a sphere: neither end is that of the other layer.
TEST(MeasuredGap, OfTwoLayersIsThatOfTheOneThatCounts) {
  const TriangleMesh mesh = test::joined(sphere(20.0, 300), sphere(30.0, 300));
  const NearFaces faces(mesh, 0.0);
  for (const Vec3& u : test::random_directions(300, 36)) expect_holds(mesh, faces, 25.0 * u, 1e-9);
}

// A face seen so nearly edge-on that its radius is anything up to 40, and a plain one at 20, in either order.
TEST(MeasuredGap, AnUncertainFaceLeavesTheOtherItsEnd) {
  TriangleMesh mesh;
  mesh.vertices = {{10, -1, 0}, {10, 1, 0}, {40, 0, 1e-15}, {20, -9, -9}, {20, 9, -9}, {20, 0, 9}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  const Vec3 x(19.0, 0.0, 19e-17);
  for (int order = 0; order < 2; ++order) {
    const NearFaces faces(mesh, 0.0);
    const CertifiedGap nearest = measured_gap(Surface::ball, faces, x);
    EXPECT_NEAR(nearest.low, -19.0, 1e-9);
    EXPECT_NEAR(nearest.high, 1.0, 1e-9);
    const CertifiedGap farthest = measured_gap(Surface::socket, faces, x);
    EXPECT_NEAR(farthest.low, -21.0, 1e-9);
    EXPECT_NEAR(farthest.high, -1.0, 1e-9);
    std::swap(mesh.faces[0], mesh.faces[1]);
  }
}

// What the header derives is taken in full on both sides: 60 u r / cos psi of the radius.
TEST(MeasuredGap, TheEndsAreAsFarOutAsIsDerived) {
  for (const double slope : {0.0, 1.0, 1e3, 1e8}) {
    TriangleMesh mesh;  // through (20, 0, 0)
    mesh.vertices = {
        {20 - 1e-3 * slope, -1, -1e-3}, {20 - 1e-3 * slope, 1, -1e-3}, {20 + 2e-3 * slope, 0, 2e-3}};
    mesh.faces = {{0, 1, 2}};
    const NearFaces faces(mesh, 0.0);
    const Vec3 x(20.0, 0.0, 1e-9);
    const auto derived = static_cast<long double>(60.0 * 0x1p-53 * 20.0 * std::hypot(1.0, slope));
    for (const Surface scanned : {Surface::ball, Surface::socket}) {
      const CertifiedGap found = measured_gap(faces, x, scanned);
      EXPECT_GE(found.high - found.low, 2.0L * derived) << slope;
      EXPECT_LE(found.high - found.low, 3.0L * derived) << slope;
    }
  }
}

// What is derived holds up to a sixteenth of the radius (measured_gap.gappa). A steeper face is anywhere up
// to its farthest corner, 22 mm.
TEST(MeasuredGap, AFaceThatIsUncertainByASixteenthIsAnywhere) {
  for (const double slope : {4e12, 2e13, 1e14}) {
    const double h = 1.0 / slope;
    TriangleMesh mesh;  // through (20, 0, 0)
    mesh.vertices = {{19, -1, -h}, {19, 1, -h}, {22, 0, 2 * h}};
    mesh.faces = {{0, 1, 2}};
    const NearFaces faces(mesh, 0.0);
    const double uncertain = 64.0 * 0x1p-53 * slope;  // of the radius
    const CertifiedGap found = measured_gap(faces, Vec3(20.0, 0.0, 0.0), Surface::ball);
    ASSERT_EQ(found.cover, Cover::whole);
    EXPECT_NEAR(found.low, uncertain < 1.0 / 16.0 ? -20.0 * uncertain : -20.0, 0.01) << slope;
    EXPECT_NEAR(found.high, uncertain < 1.0 / 16.0 ? 20.0 * uncertain : 2.0, 0.01) << slope;
  }
}

// Faces that are seen more and more edge-on, slivers, and points next to corners and edges, near and far.
TEST(TheoremGap, HoldsTheExactGapOfSteepFacesAndSlivers) {
  std::mt19937_64 random(181);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return test::random_vector(unit, random); };
  for (std::size_t k = 0; k < random_cases() / 2; ++k) {
    TriangleMesh mesh = test::soup(3, static_cast<unsigned>(k));
    const double tilt =
        k % 8 == 0 ? 0.0 : std::pow(10.0, 8.0 * (unit(random) - 1.0));  // or by rounding alone
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
           {inside, edge, corner(mesh, face, 2), Vec3(1.01 * inside),
            Vec3(std::pow(10.0, 3.0 * unit(random)) * inside), Vec3(inside + 1e-9 * vector())})
        expect_holds(mesh, faces, x, 200.0 + 1e-12 * x.norm());
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
  for (const Vec3& x : pair.ball.vertices)
    ball.push_back(static_cast<double>(true_gap(pair.socket, x, Surface::ball)));
  for (const Vec3& x : pair.socket.vertices)
    socket.push_back(static_cast<double>(true_gap(pair.ball, x, Surface::socket)));
  double smallest = HUGE_VAL;
  for (const double gap : ball) smallest = std::fmin(smallest, gap);
  for (const double gap : socket) smallest = std::fmin(smallest, gap);
  std::mt19937_64 random(18);
  for (int k = 0; k < 20; ++k) {
    const Scanned first = disturbed(ball, random);
    const Scanned second = disturbed(socket, random);
    const SmallestBetween found =
        smallest_between({Surface::ball, socket_faces, pair.ball.vertices, first.gap, first.bound},
                         {Surface::socket, ball_faces, pair.socket.vertices, second.gap, second.bound});
    EXPECT_LE(found.low, smallest + 1e-12);
    EXPECT_GE(found.high, smallest - 1e-12);
    EXPECT_LT(found.high - found.low, 1e-9);
    EXPECT_GT(found.measured, 0U);
    EXPECT_LT(found.measured, ball.size());
  }
}

// Bounds of nothing leave the smallest gap itself to be measured.
TEST(SmallestBetween, HoldsAGapThatIsKnownExactly) {
  const TriangleMesh socket = sphere(20.0, 300);
  const NearFaces faces(socket, 0.0);
  const std::vector<Vec3> places{{18.0, 1.0, 2.0}, {3.0, 18.5, 1.0}};
  std::vector<double> gaps;
  for (const Vec3& x : places) gaps.push_back(static_cast<double>(true_gap(socket, x, Surface::ball)));
  const std::vector<double> bounds(gaps.size(), 0.0);
  const SmallestBetween found =
      smallest_between({Surface::ball, faces, places, gaps, bounds}, {Surface::socket, faces, {}, {}, {}});
  EXPECT_NEAR(found.low, std::min(gaps[0], gaps[1]), 1e-12);
  EXPECT_NEAR(found.high, std::min(gaps[0], gaps[1]), 1e-12);
  EXPECT_EQ(found.measured, 1U);
}

TEST(SmallestBetween, IsInfiniteWhereNoVertexHasAGap) {
  const BallSocketPair pair = make_ball_socket_pair(60);
  const NearFaces faces(pair.socket, 0.0);
  // The table has one, and proves nothing, where the faces have none.
  const std::vector<Vec3> place{{0.0, 0.0, -20.0}};
  const std::vector<double> gap{5.0};
  const std::vector<double> bound{HUGE_VAL};
  const SmallestBetween missed =
      smallest_between({Surface::ball, faces, place, gap, bound}, {Surface::socket, faces, {}, {}, {}});
  EXPECT_TRUE(std::isinf(missed.low) && std::isinf(missed.high));
  const SmallestBetween found =
      smallest_between({Surface::ball, faces, {}, {}, {}}, {Surface::socket, faces, {}, {}, {}});
  EXPECT_TRUE(std::isinf(found.low) && std::isinf(found.high));
}

// Verdicts of poses, and on which side of a face a point lies, exactly.

TEST(CertifiedGap, OneImpingedVertexIsEnoughForThePose) {
  EXPECT_EQ((VerdictCount{5, 0, 0}).pose(), Verdict::clear);
  EXPECT_EQ((VerdictCount{5, 0, 1}).pose(), Verdict::undecided);
  EXPECT_EQ((VerdictCount{5, 1, 1}).pose(), Verdict::impinged);
}

TEST(CertifiedGap, VerticesAreCountedByTheirVerdicts) {
  VerdictCount count;
  for (int k = 0; k < 3; ++k) count.add(Verdict::clear);
  for (int k = 0; k < 2; ++k) count.add(Verdict::impinged);
  count.add(Verdict::undecided);
  EXPECT_EQ(count.clear, 3U);
  EXPECT_EQ(count.impinged, 2U);
  EXPECT_EQ(count.undecided, 1U);
}

TEST(ExactSide, OfTheCentreIsWithinTheBallAndNeverBeyondTheSocket) {
  const TriangleMesh mesh = sphere(20.0, 100);
  const NearFaces faces(mesh, 0.0);
  EXPECT_FALSE(exactly_impinged(Surface::ball, faces, Vec3::Zero()));
  EXPECT_TRUE(exactly_impinged(Surface::socket, faces, Vec3::Zero()));
}

// A vertex of the ball impinges if it is in the shadow of a face of the socket, one of the socket if it is in
// the pyramid of a face of the ball.
TEST(TheoremSigns, IsThatOfTheOracleInEveryPose) {
  const BallSocketPair joint = make_ball_socket_pair(400, impinging_cam());
  const NearFaces ball_faces(joint.ball, 0.0);
  const NearFaces socket_faces(joint.socket, 0.0);
  std::size_t clear = 0;
  std::size_t impinged = 0;
  const auto check = [&](Surface of, const NearFaces& faces, const TriangleMesh& posed,
                         const std::vector<bool>& expected) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(exactly_impinged(of, faces, posed.vertices[i]), expected[i]) << i;
      ++(expected[i] ? impinged : clear);
    }
  };
  for (const Pose& pose : test::random_poses(60, 3.0, 5.0, 7)) {
    const TriangleMesh ball = test::ball_in_socket_frame(joint.ball, pose);
    check(Surface::ball, socket_faces, ball, ShadowReference(ball, joint.socket).ball_vertices_impinged());
    const TriangleMesh socket = test::socket_in_ball_frame(joint.socket, pose);
    check(Surface::socket, ball_faces, socket,
          ShadowReference(joint.ball, socket).socket_vertices_impinged());
  }
  EXPECT_GT(clear, 1000U);
  EXPECT_GT(impinged, 100U);
}

// At a vertex of the mesh itself the gap is zero: on it is impinged, a unit of the last place before it
// clear.
TEST(TheoremSigns, TellsNeighbouringDoublesApart) {
  const TriangleMesh mesh = octahedron(16.0);
  const NearFaces faces(mesh, 0.0);
  for (const Vec3& u : test::random_directions(500, 12)) {
    const Vec3 x = u * (octahedron_mesh_radius(u, 16.0));
    EXPECT_TRUE(exactly_impinged(Surface::ball, faces, (1.0 + 0x1p-48) * x));
    EXPECT_FALSE(exactly_impinged(Surface::ball, faces, (1.0 - 0x1p-48) * x));
    EXPECT_FALSE(exactly_impinged(Surface::socket, faces, (1.0 + 0x1p-48) * x));
    EXPECT_TRUE(exactly_impinged(Surface::socket, faces, (1.0 - 0x1p-48) * x));
  }
  for (const Vec3& x : {Vec3(8, 8, 0), Vec3(16, 0, 0), Vec3(4, 4, 8), Vec3(-1, 7, -8)}) {
    EXPECT_TRUE(exactly_impinged(Surface::ball, faces, x));
    EXPECT_TRUE(exactly_impinged(Surface::socket, faces, x));
    const Vec3 less(std::nextafter(x.x(), 0.0), x.y(), x.z());
    EXPECT_FALSE(exactly_impinged(Surface::ball, faces, less));
  }
}

}  // namespace
}  // namespace impinge
