// SPDX-License-Identifier: GPL-3.0-or-later
// A verdict other than `undecided` is that of the exact oracle, and an undecided vertex gets it on demand:
//   ball vertex x: impinged iff x is in the shadow of a face of the socket;  low <= S - |x| <= high
//   socket vertex x: impinged iff x is in the pyramid of a face of the ball;  low <= |x| - B <= high
#include "10_certified/certified_scan.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "reference/shadow.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"
#include "support/directions.hpp"
#include "support/poses.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

struct Scan {
  std::vector<CertifiedGap> gaps;
  std::vector<bool> impinged;  // by the oracle
};

// Both scans of a pose, undecided vertices left as they are, beside the oracle.
template <class S>
std::array<Scan, 2> scan(const BallSocketPair& joint, const RangeTable<S>& ball, const RangeTable<S>& socket,
                         const Pose& pose) {
  std::array<Scan, 2> scans;
  scans[0].gaps.resize(joint.ball.vertices.size());
  certify(Surface::ball, socket, joint.ball.vertices, pose, scans[0].gaps);
  scans[0].impinged =
      ShadowReference(test::ball_in_socket_frame(joint.ball, pose), joint.socket).ball_vertices_impinged();
  scans[1].gaps.resize(joint.socket.vertices.size());
  certify(Surface::socket, ball, joint.socket.vertices, pose, scans[1].gaps);
  scans[1].impinged =
      ShadowReference(joint.ball, test::socket_in_ball_frame(joint.socket, pose)).socket_vertices_impinged();
  return scans;
}

std::size_t count_wrong(const Scan& scan) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < scan.gaps.size(); ++i) {
    if (scan.gaps[i].verdict == Verdict::undecided) continue;
    wrong += (scan.gaps[i].verdict == Verdict::impinged) != scan.impinged[i] ? 1U : 0U;
  }
  return wrong;
}

const BallSocketPair& bumpy_joint() {
  static const BallSocketPair pair = make_ball_socket_pair(400, impinging_cam());
  return pair;
}

template <class S>
class CertifiedScanOf : public ::testing::Test {};
using Schemes = ::testing::Types<Rsid, Usid, IcosahedralGnomonic>;
TYPED_TEST_SUITE(CertifiedScanOf, Schemes);

TYPED_TEST(CertifiedScanOf, IsNeverWrongAndResolvesTheRest) {
  const NearFaces ball_faces(bumpy_joint().ball, 0.0);
  const NearFaces socket_faces(bumpy_joint().socket, 0.0);
  VerdictCount found;
  for (const double precision : {4.0, 1.0}) {
    const auto ball = fill_ranges(bumpy_joint().ball, TypeParam::with_precision(precision));
    const auto socket = fill_ranges(bumpy_joint().socket, TypeParam::with_precision(precision));
    for (const Pose& pose : test::random_poses(60, 3.0, 5.0, 7)) {
      auto scans = scan(bumpy_joint(), ball, socket, pose);
      for (const Scan& one : scans) {
        ASSERT_EQ(count_wrong(one), 0U);
        const VerdictCount count = count_verdicts(one.gaps);
        found.clear += count.clear;
        found.impinged += count.impinged;
        found.undecided += count.undecided;
      }
      const std::size_t left = count_verdicts(scans[0].gaps).undecided;
      EXPECT_EQ(resolve(Surface::ball, socket_faces, bumpy_joint().ball.vertices, pose, scans[0].gaps), left);
      resolve(Surface::socket, ball_faces, bumpy_joint().socket.vertices, pose, scans[1].gaps);
      for (const Scan& one : scans) {
        ASSERT_EQ(count_wrong(one), 0U);
        EXPECT_EQ(count_verdicts(one.gaps).undecided, 0U);
      }
    }
  }
  EXPECT_GT(found.clear, 1000U);
  EXPECT_GT(found.impinged, 100U);
  EXPECT_GT(found.undecided, 100U);
}

TEST(CertifiedScan, HoldsTheGapToTheMesh) {
  const auto ball = fill_ranges(bumpy_joint().ball, Rsid::with_precision(2.0));
  const auto socket = fill_ranges(bumpy_joint().socket, Rsid::with_precision(2.0));
  const RayCaster ball_rays(bumpy_joint().ball);
  const RayCaster socket_rays(bumpy_joint().socket);
  for (const Pose& pose : test::random_poses(20, 3.0, 3.0, 8)) {
    const auto scans = scan(bumpy_joint(), ball, socket, pose);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& vertices = k == 0 ? bumpy_joint().ball.vertices : bumpy_joint().socket.vertices;
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const CertifiedGap& gap = scans[k].gaps[i];
        const Vec3 x = k == 0 ? to_socket(pose, vertices[i]) : to_ball(pose, vertices[i]);
        const double radius = k == 0 ? socket_rays.cast(x.normalized(), Layer::nearest)
                                     : ball_rays.cast(x.normalized(), Layer::farthest);
        const double truth = k == 0 ? radius - x.norm() : x.norm() - radius;
        if (std::isnan(truth)) {
          EXPECT_NE(gap.cover, Cover::whole);
          EXPECT_EQ(gap.verdict == Verdict::impinged, false);
        } else {
          EXPECT_NE(gap.cover, Cover::none);
          EXPECT_GE(truth, gap.low);
          EXPECT_LE(truth, gap.high);
        }
      }
    }
  }
}

// Points beside the ball by a millionth: whoever trusts a range that is too narrow by a tenth at both ends is
// wrong about some of them.
TEST(CertifiedScan, ARangeThatIsTooNarrowIsCaught) {
  const auto ball = fill_ranges(bumpy_joint().ball, Rsid::with_precision(5.0));
  const RayCaster rays(bumpy_joint().ball);
  std::size_t wrong = 0;
  std::size_t wrong_if_narrow = 0;
  for (const Vec3& u : test::random_directions(5000, 9)) {
    const double radius = rays.cast(u, Layer::farthest);
    for (const double share : {1.0 - 1e-6, 1.0 + 1e-6}) {
      const CertifiedGap gap = certified_gap(Surface::socket, ball, radius * share * u);
      const Verdict refuted = share < 1.0 ? Verdict::clear : Verdict::impinged;
      const double tenth = 0.1 * (gap.high - gap.low);
      wrong += gap.verdict == refuted ? 1U : 0U;
      wrong_if_narrow += verdict_of(gap.low + tenth, gap.high - tenth, gap.cover) == refuted ? 1U : 0U;
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_GT(wrong_if_narrow, 10U);
}

TEST(CertifiedScan, AVertexAtTheCentreIsLeftToTheExactTest) {
  const TriangleMesh mesh = sphere(20.0, 100);
  const auto ranges = fill_ranges(mesh, Rsid::with_precision(5.0));
  EXPECT_EQ(certified_gap(Surface::ball, ranges, Vec3::Zero()).verdict, Verdict::undecided);
  EXPECT_EQ(certified_gap(Surface::socket, ranges, Vec3::Zero()).verdict, Verdict::undecided);
}

}  // namespace
}  // namespace impinge::lab
