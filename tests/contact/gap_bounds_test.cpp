// SPDX-License-Identifier: GPL-3.0-or-later
// What a search rests on:
//   moved()       every vertex of a node is within `angle` of the middle, and |x| <= length for the ball, >=
//   for
//                 the socket
//   gap_bounds()  no vertex of a node has a gap below `gap`; `open` are the nodes for which !(gap > enough)
#include "contact/gap_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "contact/cap_lanes.hpp"
#include "contact/cap_limits.hpp"
#include "contact/cap_tree.hpp"
#include "contact/cube_cell.hpp"
#include "contact/culled_joint.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/infinity.hpp"
#include "support/dice.hpp"
#include "support/directions.hpp"
#include "support/poses.hpp"
#include "support/random_cases.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace test {

// Trees of caps, node by node.

// A ball of about 22 mm with bumps.
inline TriangleMesh bumpy(std::size_t faces, double height = 1.0) {
  return radial_body(faces, [height](const Vec3& u) {
    return 22.0 + height * std::sin(9.0 * u.x()) * std::cos(7.0 * u.y() + 1.0);
  });
}

// Items of the leaves below a node.
inline std::vector<std::uint32_t> items_below(const CapTree& tree, const CapNode& node) {
  const CapBlock& block = tree.blocks()[node.block];
  std::vector<std::uint32_t> found;
  for (std::uint32_t k = 0; k < block.items[node.lane]; ++k) found.push_back(block.first[node.lane] + k);
  if (block.leaf(node.lane)) return found;
  for (std::uint32_t lane = 0; lane < tree.blocks()[block.first[node.lane]].nodes; ++lane) {
    const auto below = items_below(tree, {block.first[node.lane], lane});
    found.insert(found.end(), below.begin(), below.end());
  }
  return found;
}

// Calls visit(node, block, lane) for all nodes.
template <class Visit>
void for_each_node(const CapTree& tree, Visit&& visit) {
  for (std::uint32_t at = 0; at < tree.blocks().size(); ++at) {
    for (std::uint32_t lane = 0; lane < tree.blocks()[at].nodes; ++lane)
      visit(CapNode{at, lane}, tree.blocks()[at], static_cast<std::size_t>(lane));
  }
}

}  // namespace test

namespace {

TEST(TheoremCaps, HoldTheirVertices) {
  const BallSocketPair joint{test::bumpy(400, 8.0), test::bumpy(400, 8.0)};
  for (const double shift : {0.0, 4.0, 24.0, 60.0}) {
    for (const Pose& pose : test::random_poses(3, 3.0, shift, 36)) {
      for (const Surface scanned : {Surface::ball, Surface::socket}) {
        const bool ball = scanned == Surface::ball;
        const CulledScan scan(scanned, ball ? joint.ball : joint.socket, ball ? joint.socket : joint.ball);
        const CapMove move(scanned, pose);
        test::for_each_node(scan.tree(), [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
          const MovedCaps caps = moved(block, move);
          const Vec3 middle(caps.x[lane], caps.y[lane], caps.z[lane]);
          const bool any = !(caps.angle[lane] < 4.0F);
          for (const std::uint32_t k : test::items_below(scan.tree(), node)) {
            const Vec3 x = move.place(scan.position(k));
            EXPECT_LE(ball ? x.norm() : caps.length[lane], ball ? caps.length[lane] : x.norm());
            EXPECT_LE(any ? 0.0 : angle_between(middle, x),
                      any ? 0.0 : static_cast<double>(caps.angle[lane]));
          }
        });
      }
    }
  }
}

// A cap of that angle, of one radius, whose axis is b away from +z.
CapBlock one_cap(float angle, double b) {
  CapBlock block;
  for (CapLanes* all : {&block.x, &block.y, &block.z, &block.spread}) all->fill(0.0F);
  block.x.fill(static_cast<float>(std::sin(b)));
  block.z.fill(static_cast<float>(std::cos(b)));
  block.angle.fill(angle);
  for (CapLanes* radius : {&block.low, &block.high, &block.mean}) radius->fill(22.0F);
  block.nodes = 1;
  return block;
}

// The largest |s w + o| of directions w within an angle of an axis b away from o is that for
//   w.o = T cos(max(b - angle, 0)),
// the least that for T cos(min(b + angle, pi)). No bound is closer than that but for its rounding, and up to
// half a radian they are as close as 40 um.
TEST(MovedCaps, LengthsAreThoseOfTheEdge) {
  for (const double shift : {0.5, 4.0, 8.0}) {
    const Pose pose{Eigen::Matrix3d::Identity(), Vec3(0.0, 0.0, shift)};
    const auto length = [&](double cosine) {
      return std::sqrt(22.0 * 22.0 + 2.0 * 22.0 * shift * cosine + shift * shift);
    };
    for (double b = 0.0; b < kPi; b += 0.02) {
      for (const float angle : {0.0F, 1e-4F, 1e-3F, 0.02F, 0.1F, 0.3F, 0.5F, 1.0F, 2.0F, 3.14F}) {
        const double most = length(std::cos(std::max(b - static_cast<double>(angle), 0.0)));
        const double least = length(std::cos(std::min(kPi - b + static_cast<double>(angle), kPi)));
        const CapBlock block = one_cap(angle, b);
        const double ball = moved(block, CapMove(Surface::ball, pose)).length[0];
        const double socket = moved(block, CapMove(Surface::socket, pose)).length[0];
        const double close = angle <= 0.5F ? 0.04 : kInfinity;
        EXPECT_GE(ball, most - 1e-6);
        EXPECT_LE(ball, most + close);
        EXPECT_LE(socket, least + 1e-6);
        EXPECT_GE(socket, least - close);
      }
    }
  }
}

// In poses near and far.
TEST(TheoremCaps, NoVertexHasASmallerGap) {
  const BallSocketPair joint = make_ball_socket_pair(300, impinging_cam());
  const CulledJoint culled(joint);
  for (const double shift : {0.0, 3.0, 23.0}) {
    for (const Pose& pose : test::random_poses(3, 3.0, shift, 37)) {
      for (const CulledScan& scan : culled.scans()) {
        const CapMove move(scan.scanned(), pose);
        test::for_each_node(scan.tree(), [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
          const GapBounds bounds = gap_bounds(block, move, scan.limits(), 1.0F);
          EXPECT_EQ(((bounds.open >> lane) & 1U) != 0, !(bounds.gap[lane] > 1.0F));
          EXPECT_EQ(bounds.open >> block.nodes, 0U);
          for (const std::uint32_t item : test::items_below(scan.tree(), node)) {
            const double gap = culled.gap(scan.scanned(), move.place(scan.position(item)));
            EXPECT_FALSE(gap < bounds.gap[lane]);  // NaN: none
          }
        });
      }
    }
  }
}

// Between a ball of 22 and one of 26 mm a gap of 4 mm is known to be as large but for the height of the
// faces, in caps of any width.
TEST(GapBounds, AreTightBetweenSpheres) {
  const BallSocketPair joint{sphere(22.0, 3000), sphere(26.0, 3000)};
  const CulledJoint culled(joint);
  const CapMove move(Surface::ball, {});
  const CulledScan& scan = culled.scans()[0];
  for (const CapBlock& block : scan.tree().blocks()) {
    const GapBounds bounds = gap_bounds(block, move, scan.limits(), 5.0F);
    for (std::size_t lane = 0; lane < block.nodes; ++lane) EXPECT_NEAR(bounds.gap[lane], 4.0F, 0.1F);
  }
}

// Where the ball of 22 mm is moved by 2 mm along z, the gap beside direction a is 4 mm less a_z of 2 mm; seen
// from the ball the socket comes nearer at the same place.
TEST(GapBounds, ATouchIsLikeliestWhereTheBallIsMovedTo) {
  const BallSocketPair joint{sphere(22.0, 1000), sphere(26.0, 1000)};
  const CulledJoint culled(joint);
  const Pose pose{Eigen::Matrix3d::Identity(), Vec3(0.0, 0.0, 2.0)};
  for (const CulledScan& scan : culled.scans()) {
    for (const CapBlock& block : scan.tree().blocks()) {
      const GapBounds bounds = gap_bounds(block, CapMove(scan.scanned(), pose), scan.limits(), 0.0F);
      for (std::size_t lane = 0; lane < block.nodes; ++lane)
        EXPECT_NEAR(bounds.likely[lane], 4.0F - 2.0F * block.z[lane], 0.3F);
    }
  }
}

// What culling rests on:
//   a node holds the directions and the radii of all its items
//   within(x, angle): every radius of the surface along u, angle(u, x) <= angle, is beyond the limit

Vec3 axis_of(const CapBlock& block, std::size_t lane) {
  return {block.x[lane], block.y[lane], block.z[lane]};
}

TEST(CapTree, EveryNodeHoldsItsItems) {
  std::vector<CapItem> items;
  for (const Vec3& u : test::random_directions(3000, 31)) {
    const double low = 20.0 + u.x();
    items.push_back({{u, 0.02 * (1.0 + u.y())}, {low, low + 0.1 * (1.0 + u.z())}});
  }
  const CapTree tree(items);
  std::vector<std::uint32_t> all;
  std::size_t nodes = 0;
  test::for_each_node(tree, [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
    ++nodes;
    const auto below = test::items_below(tree, node);
    if (node.block == 0) all.insert(all.end(), below.begin(), below.end());
    for (const std::uint32_t k : below) {
      const CapItem& item = items[tree.order()[k]];
      const double away = angle_between(axis_of(block, lane), item.cap.axis) + item.cap.radius;
      EXPECT_LE(std::min(away, kPi), block.angle[lane]);
      EXPECT_LE(block.low[lane], item.range.low);
      EXPECT_GE(block.high[lane], item.range.high);
    }
  });
  EXPECT_LT(nodes, items.size() + items.size() / 2);
  std::ranges::sort(all);
  std::vector<std::uint32_t> every(items.size());
  std::iota(every.begin(), every.end(), 0U);
  EXPECT_EQ(all, every);
}

// All in one eighth of a radian: most cells are empty, and have no nodes.
TEST(CapTree, OfACrowdHasNoNodeWithoutItems) {
  std::vector<CapItem> items;
  for (const Vec3& u : test::random_directions(3000, 33))
    items.push_back({{Vec3(1.0, 0.1 * u.x(), 0.1 * u.y()).normalized(), 0.0}, {20.0, 21.0}});
  const CapTree tree(items);
  test::for_each_node(tree, [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
    EXPECT_FALSE(test::items_below(tree, node).empty());
    EXPECT_LT(block.high[lane], 21.001F);
    EXPECT_GT(block.low[lane], 19.999F);
  });
}

// Next to a corner, within the cell and beyond it.
TEST(CubeCell, HasItsCorners) {
  for (const Vec3& u : test::random_directions(2000, 34)) {
    for (std::size_t level = 0; level <= CapTree::kDeepest; ++level) {
      const CubeCell cell{level, cell_of(u, level)};
      const std::array<Vec3, 4> corners = cell_corners(cell);
      const Vec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(cell_of(middle + (1.0 - 1e-6) * (corners[k] - middle), level), cell.prefix) << k;
        EXPECT_NE(cell_of(middle + (1.0 + 1e-6) * (corners[k] - middle), level), cell.prefix) << k;
        EXPECT_NE(corners[k], corners[(k + 1) % 4]);
      }
    }
  }
}

// The caps of leaves are little wider than their cells.
TEST(CapTree, CapsShrink) {
  std::vector<CapItem> items;
  for (const Vec3& u : test::random_directions(3000, 32)) items.push_back({{u, 0.0}, {20.0, 20.0}});
  test::for_each_node(CapTree(items), [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
    EXPECT_LT(block.angle[lane], block.leaf(node.lane) ? 0.2F : 4.0F);
  });
}

// What kernels find for a single vertex in a direction.
float alone(const CapLimits& limits, const Vec3& u) {
  MovedCaps caps;
  caps.x.fill(static_cast<float>(u.x()));
  caps.y.fill(static_cast<float>(u.y()));
  caps.z.fill(static_cast<float>(u.z()));
  caps.angle.fill(0.0F);
  const CapLevels levels = limits.levels();
  lanes::WholeLanes steps;
  steps.fill(levels.steps[lanes::levels_of(caps.angle, levels)[0]]);
  return levels.limits[lanes::entries_of(caps, steps)[0]];
}

class LimitsOf : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Faces, LimitsOf, ::testing::Values(8, 200, 1500));

TEST_P(LimitsOf, AreKeptInEveryCap) {
  const TriangleMesh mesh = test::bumpy(GetParam());
  const CapLimits low(mesh, Layer::nearest);
  const CapLimits high(mesh, Layer::farthest);
  const RayCaster rays(mesh);
  const auto ways = test::random_directions(400, 33);
  const auto asides = test::random_directions(400, 34);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const double angle = std::pow(10.0, -4.0 + 4.4 * static_cast<double>(k) / 400.0);
    const Vec3 aside = (asides[k] - asides[k].dot(ways[k]) * ways[k]).normalized();
    for (const double share : {0.0, 0.5, 1.0}) {
      const auto radius = [&](double way) {
        return rays.cast((std::cos(way) * ways[k] + std::sin(way) * aside).normalized(), Layer::nearest);
      };
      const double wide = radius(share * angle);
      EXPECT_LE(low.within(ways[k], static_cast<float>(angle)), wide);
      EXPECT_GE(high.within(ways[k], static_cast<float>(angle)), wide);
    }
    const double here = rays.cast(ways[k], Layer::nearest);
    EXPECT_LE(alone(low, ways[k]), here);
    EXPECT_GE(alone(high, ways[k]), here);
  }
}

// The finest levels holds 6e6 limits and more: kernels find the last of them, too. Along +x of a face of n
// cells that is the entry (n / 2) (n + 1) + n / 2.
TEST(CapLimits, KernelsReachTheEndOfManyLevels) {
  constexpr std::uint32_t kPlace = 8'000'000;
  constexpr std::uint32_t kCells = 510;
  MovedCaps caps;
  caps.x.fill(20.0F);
  caps.y.fill(0.0F);
  caps.z.fill(0.0F);
  lanes::WholeLanes steps;
  steps.fill(static_cast<std::int32_t>((kPlace << CapLimits::kLineBits) + kCells));
  for (const std::int32_t entry : lanes::entries_of(caps, steps))
    EXPECT_EQ(entry, static_cast<std::int32_t>(kPlace + kCells / 2 * (kCells + 1) + kCells / 2));
}

// Small caps of a fine mesh have limits that are worth something: a radius changes by 2 mm a radian, over the
// cap, the way to an entry and a face.
TEST(CapLimits, AreTightInSmallCaps) {
  const TriangleMesh mesh = sphere(22.0, 3000, Vec3(2.0, 0.0, 0.0));
  const CapLimits limits(mesh, Layer::nearest);
  const RayCaster rays(mesh);
  for (const Vec3& u : test::random_directions(200, 35)) {
    const double radius = rays.cast(u, Layer::nearest);
    EXPECT_GT(limits.within(u, 0.05F), radius - 2.0 * (0.25 + 0.101 + 0.2));
    EXPECT_GT(alone(limits, u), radius - 2.0 * (0.0505 + 0.2));
  }
}

TEST(CapLimits, WhereThereIsNoSurfaceThereIsNoLimit) {
  const TriangleMesh mesh = cup(20.0, 30.0, 500);
  const Vec3 away = -Vec3::UnitZ();
  EXPECT_EQ(CapLimits(mesh, Layer::nearest).within(away, 0.2F), HUGE_VALF);
  EXPECT_EQ(CapLimits(mesh, Layer::farthest).within(away, 0.2F), -HUGE_VALF);
  EXPECT_LT(CapLimits(mesh, Layer::nearest).within(away, 2.7F), 20.1F);
  EXPECT_LT(CapLimits(mesh, Layer::nearest).within(Vec3::Zero(), HUGE_VALF), 20.1F);
  EXPECT_EQ(alone(CapLimits({}, Layer::nearest), away), HUGE_VALF);
}

// Shifts that nearly cancel a vertex: it comes as near to the other centre as 10^-9 of its own length. Bounds
// hold there as anywhere, in long double, and no touch is missed.

using Long3 = Eigen::Matrix<long double, 3, 1>;

class TheoremCapsOfCancellingShifts : public testing::TestWithParam<Surface>, protected test::Dice {
 protected:
  TheoremCapsOfCancellingShifts() : Dice(7) {}
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

INSTANTIATE_TEST_SUITE_P(Surfaces, TheoremCapsOfCancellingShifts,
                         testing::Values(Surface::ball, Surface::socket),
                         [](const auto& of) { return of.param == Surface::ball ? "Ball" : "Socket"; });

// Up to eight vertices about a direction, and one of them taken beside the centre.
TEST_P(TheoremCapsOfCancellingShifts, BoundsHoldTheirVertices) {
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
TEST_P(TheoremCapsOfCancellingShifts, BoundsHoldTheEdgeOfACapAgainstTheShift) {
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
TEST_P(TheoremCapsOfCancellingShifts, NoTouchIsMissed) {
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
