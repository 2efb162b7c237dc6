// SPDX-License-Identifier: GPL-3.0-or-later
// Shifts that nearly cancel a vertex: it comes as near to the other centre as 10^-9 of its own length. Bounds
// hold there as anywhere, in long double, and no touch is missed.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "contact/culled_joint.hpp"
#include "contact/gap_bounds.hpp"
#include "support/cap_nodes.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using Long3 = Eigen::Matrix<long double, 3, 1>;

class CancellingShiftsAttack : public testing::TestWithParam<Surface>, protected test::Dice {
 protected:
  CancellingShiftsAttack() : Dice(7) {}
  // Each power of ten as often as any other.
  double length(double from, double to) { return std::exp(between(std::log(from), std::log(to))); }
  Eigen::Matrix3d turn() { return Eigen::AngleAxisd(between(-kPi, kPi), direction()).toRotationMatrix(); }
  bool ball() const { return GetParam() == Surface::ball; }

  // That takes vertex v of the surface to x, but for rounding.
  Pose pose_that_takes(const Vec3& v, const Vec3& x) {
    const Eigen::Matrix3d r = turn();
    return ball() ? Pose{r, x - r * v} : Pose{r, v - r * x};
  }
  // Where the pose takes a vertex.
  Long3 place(const Pose& pose, const Vec3& v) const {
    const Eigen::Matrix<long double, 3, 3> r = pose.rotation.cast<long double>();
    const Long3 t = pose.translation.cast<long double>();
    const Long3 from = v.cast<long double>();
    return ball() ? Long3(r * from + t) : Long3(r.transpose() * (from - t));
  }
};

INSTANTIATE_TEST_SUITE_P(Surfaces, CancellingShiftsAttack, testing::Values(Surface::ball, Surface::socket),
                         [](const auto& of) { return of.param == Surface::ball ? "Ball" : "Socket"; });

// Up to eight vertices about a direction, and one of them taken beside the centre.
TEST_P(CancellingShiftsAttack, BoundsHoldTheirVertices) {
  for (std::size_t n = 0; n < random_cases(); ++n) {
    const Vec3 axis = direction();
    const double wide = length(1e-7, 1.0);
    const double thick = length(1e-7, 1.0);
    std::vector<Vec3> vertices(1 + n % 8);
    std::vector<CapItem> items;
    for (Vec3& v : vertices) {
      v = 30.0 * (1.0 + thick * between(-0.5, 0.5)) *
          (axis + wide * between(0.0, 1.0) * direction()).normalized();
      items.push_back({{v.normalized(), 0.0}, {v.norm(), v.norm()}});
    }
    const CapTree tree(items);
    const CapMove move(GetParam(), pose_that_takes(vertices[0], length(1e-9, 40.0) * direction()));
    test::for_each_node(tree, [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
      const MovedCaps caps = moved(block, move);
      const Long3 middle = Vec3(caps.x[lane], caps.y[lane], caps.z[lane]).cast<long double>();
      for (const std::uint32_t k : test::items_below(tree, node)) {
        const Long3 x = place(move.pose, vertices[tree.order()[k]]);
        const long double bound = caps.length[lane];
        ASSERT_LE(ball() ? x.norm() : bound, ball() ? bound : x.norm()) << "case " << n;
        if (!(caps.angle[lane] < 4.0F)) continue;
        ASSERT_LE(std::atan2(middle.cross(x).norm(), middle.dot(x)), caps.angle[lane]) << "case " << n;
      }
    });
  }
}

// A cap whose axis is opposite to the shift, or along it, but for less than what a float tells: the vertex on
// the edge of the cap is the one that its bound is about.
TEST_P(CancellingShiftsAttack, BoundsHoldTheEdgeOfACapAgainstTheShift) {
  for (std::size_t n = 0; n < random_cases(); ++n) {
    const Vec3 axis = direction();
    const Vec3 aside = axis.cross(direction()).normalized();
    const double angle = length(1e-4, 1.0);
    const double off = length(1e-6, 0.1);
    const double radius = between(20.0, 24.0);
    const Vec3 shift = radius * between(0.999, 1.001) * (off * aside - axis).normalized();
    const double against = ball() ? 1.0 : -1.0;  // the ball's farthest vertex, the socket's nearest
    const Vec3 v = radius * (std::cos(angle) * axis + against * std::sin(angle) * aside);
    const CapTree tree(std::vector<CapItem>{{{axis, angle}, {radius, radius}}});
    const Pose pose{Eigen::Matrix3d::Identity(), n % 3 == 0 ? Vec3(-shift) : shift};
    const long double bound = moved(tree.blocks()[0], CapMove(GetParam(), pose)).length[0];
    const long double truth = place(pose, v).norm();
    ASSERT_LE(ball() ? truth : bound, ball() ? bound : truth) << "case " << n << ", " << off << " radians";
  }
}

// Gap of a point to a face on its ray, in long double: how far the face is beyond it for the ball's scan and
// before it for the socket's. NaN where the ray misses the face.
long double gap_to(const TriangleMesh& face, const Long3& x, Surface scanned) {
  std::array<Long3, 3> c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = face.vertices[k].cast<long double>();
  const Long3 normal = (c[1] - c[0]).cross(c[2] - c[0]);
  const long double offset = normal.dot(c[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (c[k].cross(c[(k + 1) % 3]).dot(x) * offset < 0.0L) return std::nanl("");
  }
  const long double radius = offset * x.norm() / normal.dot(x);
  return scanned == Surface::ball ? radius - x.norm() : x.norm() - radius;
}

// A corner of a face is taken to 90 % of its distance beyond a face of the other surface, or as far before
// it.
TEST_P(CancellingShiftsAttack, NoTouchIsMissed) {
  const auto beside = [](const Vec3& p, double a, double b) -> Vec3 {
    const Vec3 across = p.unitOrthogonal();
    return p + a * across + b * p.normalized().cross(across);
  };
  int touching = 0;
  const std::size_t count = random_cases();
  for (std::size_t n = 0; n < count; ++n) {
    const double near = length(1e-7, 20.0);
    const Vec3 v = between(25.0, 35.0) * direction();
    const Vec3 x = near * direction();
    const Vec3 at = between(0.5, 1.5) * x;
    const TriangleMesh moved{{v, beside(1.03 * v, 0.3, 0.0), beside(1.03 * v, 0.0, 0.3)}, {{0, 1, 2}}};
    const TriangleMesh other{
        {beside(at, 2 * near, 0), beside(at, -near, 2 * near), beside(at, -near, -2 * near)}, {{0, 1, 2}}};
    const Pose pose = pose_that_takes(v, x);
    long double least = HUGE_VALL;
    for (const Vec3& w : moved.vertices) least = std::fmin(least, gap_to(other, place(pose, w), GetParam()));
    const Surface back = ball() ? Surface::socket : Surface::ball;
    const Eigen::Matrix<long double, 3, 3> r = pose.rotation.cast<long double>();
    const Long3 t = pose.translation.cast<long double>();
    for (const Vec3& w : other.vertices) {
      const Long3 y = w.cast<long double>();
      least =
          std::fmin(least, gap_to(moved, ball() ? Long3(r.transpose() * (y - t)) : Long3(r * y + t), back));
    }
    if (std::abs(least) < 1e-12L) continue;
    const BallSocketPair joint = ball() ? BallSocketPair{moved, other} : BallSocketPair{other, moved};
    const CulledJoint culled(joint);
    ASSERT_EQ(culled.impinged(pose).has_value(), least < 0.0L) << "case " << n << ", " << near << " mm";
    const auto gap = culled.least_gap(pose);
    ASSERT_NEAR(gap ? gap->gap_mm : HUGE_VAL, static_cast<double>(least), 1e-12) << "case " << n;
    touching += least < 0.0L ? 1 : 0;
  }
  EXPECT_GT(touching, static_cast<int>(count) / 4);
  EXPECT_LT(touching, static_cast<int>(count) * 9 / 10);
}

// A vertex is left 10^-300 mm from the centre, beside which a socket is 5 um away.
TEST(CancellingShifts, MayLeaveLessThanAFloatTells) {
  const BallSocketPair joint{{{{30, 1e-300, 0}, {31, -1, 1}, {31, -1, -1}}, {{0, 1, 2}}},
                             {{{-0.1, 0.005, -0.1}, {0.1, 0.005, -0.1}, {0, 0.005, 0.1}}, {{0, 1, 2}}}};
  const Pose pose{Eigen::Matrix3d::Identity(), Vec3(-30, 0, 0)};
  const CulledJoint culled(joint);
  EXPECT_FALSE(culled.impinged(pose));
}

}  // namespace
}  // namespace impinge
