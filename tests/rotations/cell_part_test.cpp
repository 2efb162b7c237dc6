// SPDX-License-Identifier: GPL-3.0-or-later
// The small parts that cells are decided with, beside points: half-spaces and polytopes of a cell, spans of
// radii, and how a surface is seen from the centre where a direction lies on a side or a face is too wide.
#include "rotations/cell_part.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/weld.hpp"
#include "rotations/cap_floor.hpp"
#include "rotations/cell_test.hpp"
#include "rotations/radii_over_cap.hpp"
#include "rotations/ray_spans.hpp"
#include "rotations/seen_surface.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"
#include "table/near_faces.hpp"

namespace impinge {
namespace {

CellPlane plane_across(const Vec3& slope, double offset) {
  return {{static_cast<float>(slope[0]), static_cast<float>(slope[1]), static_cast<float>(slope[2])},
          static_cast<float>(offset)};
}

// Beside the eight corners of the eighth.
TEST(CellParts, HoldAnEighthIfTheyHoldItsCorners) {
  test::Dice dice(71);
  std::size_t frees = 0;
  std::size_t blocks = 0;
  for (std::size_t round = 0; round < random_cases(); ++round) {
    CellPart part;
    for (int n = dice.whole(0, 2); n > 0; --n)
      part.free.push_back(plane_across(dice.direction(), dice.between(-0.5, 1.5)));
    for (int n = dice.whole(0, 2); n > 0; --n)
      part.blocked.push_back(plane_across(dice.direction(), dice.between(-0.5, 1.5)));
    for (std::uint64_t k = 0; k < 8; ++k) {
      const auto least = [&](const CellPlane& plane) {
        double found = HUGE_VAL;
        for (std::uint64_t corner = 0; corner < 8; ++corner) {
          Vec3 t;
          for (std::size_t side = 0; side < 3; ++side)
            t[static_cast<Eigen::Index>(side)] =
                ((k >> side) & 1U ? 0.0 : -1.0) + ((corner >> side) & 1U ? 1.0 : 0.0);
          found = std::min(found, plane.at(t));
        }
        return found;
      };
      const auto rounded = [&](const CellPlane& plane) { return std::abs(least(plane)) < 1e-5; };
      const auto holds = [&](const CellPlane& plane) { return least(plane) > 0.0; };
      if (std::ranges::any_of(part.free, rounded) || std::ranges::any_of(part.blocked, rounded)) continue;
      EXPECT_EQ(part.frees(k), !part.free.empty() && std::ranges::all_of(part.free, holds)) << round;
      EXPECT_EQ(part.blocks(k), std::ranges::any_of(part.blocked, holds)) << round;
      frees += part.frees(k) ? 1U : 0U;
      blocks += part.blocks(k) ? 1U : 0U;
    }
  }
  EXPECT_GT(frees, random_cases() / 10);
  EXPECT_GT(blocks, random_cases() / 10);
}

// Planes that touch a sphere: each adds a face, until there are too many. The share is that of points.
TEST(CellParts, APolytopeOfTooManyFacesIsNothing) {
  test::Dice dice(72);
  for (int round = 0; round < 20; ++round) {
    const RotationCell cell = cell_of(dice.quaternion(), 9);
    const CellFrame frame(cell);
    std::vector<CellPlane> planes;
    CellPolytope left;
    double last = 1.0;
    const auto clip = [&] {
      planes.push_back(plane_across(dice.direction(), 0.8));
      return left.clip(planes.back(), static_cast<std::uint32_t>(5 + planes.size()));
    };
    while (clip()) {
      ASSERT_TRUE(left.bounds(static_cast<std::uint32_t>(5 + planes.size())));
      last = left.share(frame) / share(cell);
      ASSERT_LT(planes.size(), 100U);
    }
    EXPECT_GE(planes.size(), 25U);  // the cell has six sides, a polytope has room for 30
    EXPECT_TRUE(left.empty());
    EXPECT_EQ(left.share(frame), 0.0);
    planes.pop_back();
    constexpr int kPoints = 2000;
    int within = 0;
    for (int k = 0; k < kPoints; ++k) {
      const Vec3 t(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
      if (std::ranges::all_of(planes, [&](const CellPlane& plane) { return plane.at(t) >= 0.0; })) ++within;
    }
    EXPECT_NEAR(last, within / double{kPoints}, 0.06);
  }
}

// The two sides of a plane together are what was divided. Planes far from the middle cut small pieces off
// polytopes that larger cuts have made. In so small a cell what the bound of a share leaves out does not
// count.
TEST(CellParts, SidesOfAPlaneAddUp) {
  test::Dice dice(74);
  const CellFrame frame({12, 12345678901});
  const double all = CellPolytope().share(frame);
  int cuts = 0;
  for (std::size_t round = 0; round < random_cases(); ++round) {
    CellPolytope left;
    for (std::uint32_t n = 6; n < 16; ++n) {
      const CellPlane plane = plane_across(dice.direction(), dice.between(-0.2, 1.6));
      CellPolytope piece = left;
      const double whole = left.share(frame);
      ASSERT_TRUE(piece.clip(plane.opposite(), n));
      ASSERT_TRUE(left.clip(plane, n));
      EXPECT_NEAR(piece.share(frame) + left.share(frame), whole, 1e-6 * all) << round << " " << n;
      if (!piece.empty() && !left.empty()) ++cuts;
    }
  }
  EXPECT_GT(cuts, static_cast<int>(random_cases()));
}

// How deep a polytope goes below a plane, by its faces' corners and by random points of it; and no more of it
// is worked out than is asked for.
TEST(CellParts, APolytopeKnowsHowDeepItGoesBelowAForm) {
  test::Dice dice(75);
  std::size_t below = 0;
  for (std::size_t round = 0; round < random_cases(); ++round) {
    CellPolytope left;
    std::vector<CellPlane> planes;
    for (std::uint32_t n = 6; n < 16; ++n) {
      planes.push_back(plane_across(dice.between(0.5, 2.0) * dice.direction(), dice.between(0.0, 1.6)));
      ASSERT_TRUE(left.clip(planes.back(), n));
      const CellPlane cut = plane_across(dice.between(0.1, 10.0) * dice.direction(), dice.between(-2.0, 2.0));
      const Vec3 slope(cut.slope[0], cut.slope[1], cut.slope[2]);
      const FormOverCell form{static_cast<double>(cut.offset) + 1.0, slope, -1.0};
      const double depth = std::max(0.0, left.farthest(cut.opposite())) / slope.norm();
      EXPECT_NEAR(left.depth_below(form), depth, 1e-12);
      for (const double most : {0.0, 0.5 * depth, depth + 0.1})
        EXPECT_EQ(left.depth_below(form, most) >= most, depth >= most) << depth << " " << most;
      const Vec3 t(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
      if (std::ranges::any_of(planes, [&](const CellPlane& plane) { return plane.at(t) < 0.0; })) continue;
      EXPECT_GE(left.depth_below(form), -cut.at(t) / slope.norm() - 1e-12);
      if (cut.at(t) < 0.0) ++below;
    }
  }
  EXPECT_GT(below, random_cases());
}

// Both bounds of n . R x - k over a cell, against its value at random places; they are close to it, up to the
// square of the cell.
TEST(CellParts, FormsAreBoundsOfSecondOrder) {
  test::Dice dice(76);
  for (std::size_t round = 0; round < random_cases(); ++round) {
    const RotationCell cell = cell_of(dice.quaternion(), static_cast<std::uint32_t>(dice.whole(1, 10)));
    const CellFrame frame(cell);
    const Eigen::Matrix3d middle = rotation_of(centre(cell));
    const Vec3 x = std::pow(10.0, dice.between(-3.0, 3.0)) * dice.direction();
    Vec3 n = std::pow(10.0, dice.between(-3.0, 3.0)) * dice.direction();
    if (round % 3 == 0) n = n.norm() * (middle * x).normalized();  // along R x
    const double product = n.norm() * x.norm();
    const double k = dice.between(-2.0, 2.0) * product;
    const double sign = dice.sign();
    for (const FormOverCell& form : {frame.form(n, x, k, sign, 0.0),
                                     frame.form_in_ball(middle.transpose() * n, x, product, k, sign, 0.0)}) {
      EXPECT_LE(form.least, 0.0);
      for (int draw = 0; draw < 10; ++draw) {
        const Vec3 t(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
        const Quaternion4 q = point_of(cell, {t[0], t[1], t[2]});
        const double scale = q.squaredNorm() * (product + std::abs(k));
        const double value = sign * (n.dot(rotation_of(q) * x) - k) * q.squaredNorm();
        const double bound = form.middle + form.slope.dot(t) + form.least;
        EXPECT_LE(bound, value + 1e-14 * scale);
        EXPECT_GE(bound, value - (12.0 * frame.half() * frame.half() + 1e-11) * scale);
      }
    }
  }
}

// A prism of 24 sides, cut across: the new face has 24 corners, for which there is room.
TEST(CellParts, APlaneThatCutsTwentyFourFacesIsKept) {
  CellPolytope left;
  for (std::uint32_t n = 6; n < 30; ++n) {
    const double way = 2.0 * kPi * (7 * n % 24) / 24.0;
    ASSERT_TRUE(left.clip(plane_across({std::cos(way), std::sin(way), 0.0}, 0.6), n));
  }
  const CellFrame frame({12, 12345678901});
  const double area = 24.0 * 0.36 * std::tan(kPi / 24.0);  // of the circle's polygon
  EXPECT_NEAR(left.share(frame), 0.25 * area * CellPolytope().share(frame), 1e-4 * left.share(frame));
  const double whole = left.share(frame);
  ASSERT_TRUE(left.clip(plane_across({0.0, 0.0, 1.0}, 0.0), 30));
  EXPECT_TRUE(left.bounds(30));
  EXPECT_NEAR(left.share(frame), 0.5 * whole, 1e-4 * whole);
}

// Planes through a corner, an edge or a side of the cell cut nothing off; those that leave only these keep no
// volume.
TEST(CellParts, APlaneThatTouchesKeepsAllOrNoVolume) {
  const CellFrame frame({3, 0});
  const double all = CellPolytope().share(frame);
  for (const auto& [slope, touches] :
       {std::pair{Vec3(1, 1, 1), 3.0}, {Vec3(1, 1, 0), 2.0}, {Vec3(0, 0, -1), 1.0}}) {
    CellPolytope kept;
    EXPECT_TRUE(kept.clip(plane_across(-slope, touches), 6));
    EXPECT_EQ(kept.share(frame), all);
    CellPolytope left;
    EXPECT_TRUE(left.clip(plane_across(slope, -touches), 6));
    EXPECT_LE(left.share(frame), 1e-12 * all);
  }
}

// A bound without a slope is the same in all of the cell.
TEST(CellParts, AFormWithoutASlopeIsAllOrNothing) {
  for (const double value : {1e-9, 1.0, 1e9}) {
    const CellPlane all = FormOverCell{value, Vec3::Zero(), 0.0}.plane();
    const CellPlane none = FormOverCell{-value, Vec3::Zero(), 0.0}.plane();
    for (const Vec3& t : {Vec3(0, 0, 0), Vec3(1, -1, 1)}) {
      EXPECT_GT(all.at(t), 0.0);
      EXPECT_LT(none.at(t), 0.0);
      EXPECT_TRUE(std::isfinite(all.at(t)) && std::isfinite(none.at(t)));
    }
  }
}

// Thirty faces, as of two pyramids that slope up and down in turn: a plane cuts all of them.
TEST(CellParts, APlaneThatCutsThirtyFacesLeavesNothing) {
  constexpr std::uint32_t kFaces = 30;
  CellPolytope left;
  for (std::uint32_t n = 0; n < kFaces; ++n) {
    const std::uint32_t k = 7 * n % kFaces;
    const double way = 2.0 * kPi * k / kFaces;
    ASSERT_TRUE(left.clip(plane_across({std::cos(way), std::sin(way), k % 2 == 0 ? 0.8 : -0.8}, 0.6), 6 + n));
  }
  for (std::uint32_t n = 0; n < 6 + kFaces; ++n) EXPECT_EQ(left.bounds(n), n >= 6) << n;
  EXPECT_FALSE(left.clip(plane_across({0.0, 0.0, 1.0}, 0.0), 6 + kFaces));
  EXPECT_TRUE(left.empty());
}

// Whole radii, beside every half of them.
TEST(RaySpans, AreSetsOfRadii) {
  constexpr int kMost = 20;
  test::Dice dice(73);
  for (std::size_t round = 0; round < random_cases(); ++round) {
    RaySpans set;
    std::array<bool, 2 * kMost + 1> in{};
    for (int n = dice.whole(0, 5); n > 0; --n) {
      const int from = dice.whole(0, kMost);
      const int to = dice.whole(0, kMost);
      set.add(from, to);
      for (int k = 2 * from; k <= 2 * to; ++k) in[static_cast<std::size_t>(k)] = true;
    }
    const int from = dice.whole(0, kMost);
    const int to = dice.whole(from, kMost);
    const auto begin = in.begin() + 2 * from;
    const auto end = in.begin() + 2 * to + 1;
    EXPECT_EQ(set.holds(from, to), std::all_of(begin, end, [](bool is) { return is; }));
    EXPECT_EQ(set.meets(from, to), std::any_of(begin, end, [](bool is) { return is; }));
    double length = 0.0;
    double volume = 0.0;
    for (int k = 0; k < to; ++k) {
      if (!in[static_cast<std::size_t>(2 * k + 1)]) continue;
      length += k >= from ? 1.0 : 0.0;
      volume += (std::pow(k + 1, 3) - std::pow(k, 3)) / 3.0;
    }
    EXPECT_NEAR(set.length(from, to), length, 1e-9);
    EXPECT_NEAR(set.volume(to), volume, 1e-9);
    for (std::size_t k = 1; k < set.spans().size(); ++k)
      EXPECT_LT(set.spans()[k - 1].high, set.spans()[k].low);
  }
}

// A direction on a side belongs to neither face.
// A sphere with a patch before or behind it, whose rim has long edges, half of the caps near the rim: what
// any ray meets is within the bounds.
TEST(RadiiOverCap, HoldWhatARayMeets) {
  test::Dice dice(77);
  for (const Layer layer : {Layer::nearest, Layer::farthest}) {
    const double patch = layer == Layer::nearest ? 15.0 : 30.0;
    const TriangleMesh mesh = test::joined(sphere(20.0, 300), cup(patch, 40.0, 30));
    const RadiiOverCap radii(mesh, layer);
    const NearFaces faces(mesh, 0.0);
    std::size_t bounded = 0;
    for (std::size_t k = 0; k < random_cases(); ++k) {
      const double tilt = (k % 2 == 0 ? dice.between(0.0, 180.0) : dice.between(34.0, 42.0)) * kDegree;
      const double azimuth = dice.between(0.0, 2.0 * kPi);
      const Vec3 axis(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt));
      const DirectionCap cap{axis, dice.power(-3.0, -1.05)};
      const double least = radii.least(cap);
      const double largest = radii.largest(cap);
      if (std::isfinite(least) && std::isfinite(largest)) ++bounded;
      for (int n = 0; n < 20; ++n) {
        const Vec3 about = axis.cross(dice.direction()).normalized();
        const Vec3 u = Eigen::AngleAxisd(dice.between(0.0, cap.radius), about) * axis;
        const double radius = faces.radius(u, layer);
        if (std::isnan(radius)) continue;
        EXPECT_LE(least, radius) << tilt;
        EXPECT_GE(largest, radius) << tilt;
      }
    }
    EXPECT_GT(bounded, random_cases() / 3);
    EXPECT_LT(bounded, random_cases());
  }
}

// A side of the slab is seen under more than 75.5 degrees, so that its corners are not moved out far enough
// for the gap; a triangle 0.5 mm above its middle is nearer than the gap in all of these rotations, wherever
// the tip of the slab comes near the other triangle.
TEST(CellPart, FreesNothingBelowAWideFaceThatIsNearerThanTheGap) {
  TriangleMesh slab;
  for (const double x : {-10.0, 10.0})
    for (const double y : {-10.0, 10.0})
      for (const double z : {-1.0, 1.0}) slab.vertices.emplace_back(x, y, z);
  slab.vertices.emplace_back(80.0, 0.0, 0.0);
  slab.faces = {{0, 1, 3}, {0, 3, 2}, {0, 4, 5}, {0, 5, 1}, {2, 3, 7}, {2, 7, 6}, {0, 2, 6},
                {0, 6, 4}, {1, 5, 7}, {1, 7, 3}, {4, 6, 8}, {6, 7, 8}, {7, 5, 8}, {5, 4, 8}};
  std::size_t open = 0;
  for (double azimuth = 0.508; azimuth < 0.53; azimuth += 0.004) {
    TriangleMesh socket;
    test::add_face(socket, {-1.0, -1.0, 1.5}, {0.0, 1.0, 1.5}, {1.0, -1.0, 1.5});
    const auto at = [](double angle, double z) {
      return Vec3(25.0 * std::cos(angle), 25.0 * std::sin(angle), z);
    };
    test::add_face(socket, at(azimuth, -4.0), at(azimuth, 4.0), at(azimuth + 0.2, 0.0));
    const CellTest joint({slab, socket}, {.gap_mm = 1.0});
    CellSearch search(joint);
    for (std::uint32_t level = 6; level <= 9; ++level) {
      const RotationCell cell = cell_of(Quaternion4(1.0, 0.001, 0.0012, 0.03), level);
      search.enter(parent(cell));
      const CellVerdict verdict = search.decide(cell);
      EXPECT_NE(verdict.state, CellState::free);
      if (verdict.state != CellState::open) continue;
      ++open;
      EXPECT_EQ(search.part_of(cell, verdict.hint).free_share, 0.0) << azimuth << " " << level;
    }
  }
  EXPECT_GT(open, 0U);
}

TEST(CapFloor, FindsTheFaceThatHoldsADirection) {
  const TriangleMesh mesh = test::askew(sphere(20.0, 500));
  const SeenSurface surface(mesh, Layer::farthest);
  const CapFloor floor(surface);
  test::Dice dice(74);
  for (std::uint32_t f = 0; f < surface.faces().size(); ++f) {
    const auto& [a, b, c] = surface.faces()[f].corner;
    EXPECT_EQ(floor.face_along((a + b).normalized()), DirectionFace::kNone) << f;
    EXPECT_EQ(floor.face_along(c), DirectionFace::kNone) << f;
    const Vec3 shares(dice.between(0.1, 1.0), dice.between(0.1, 1.0), dice.between(0.1, 1.0));
    EXPECT_EQ(floor.face_along((shares[0] * a + shares[1] * b + shares[2] * c).normalized()), f);
  }
}

// A strip of 800 faces from +z on, half a degree long, of which only those near a direction of the grid can
// be walked to: farther on nothing is said, and nothing wrong.
TEST(CapFloor, GivesUpAWalkOfManyFaces) {
  TriangleMesh strip;
  const auto at = [](double step, double y) {
    return Vec3(26.0 * (step + 0.3) * 0.5 * kDegree / 400.0, y, 26.0);
  };
  for (int k = -2; k < 400; ++k) {
    test::add_face(strip, at(k, -1.0), at(k + 1, -1.0), at(k + 1, 1.0));
    test::add_face(strip, at(k, -1.0), at(k + 1, 1.0), at(k, 1.0));
  }
  const SeenSurface surface(weld(strip), Layer::nearest);
  const CapFloor floor(surface);
  for (const auto& [step, found] : {std::pair{10.3, true}, {300.3, false}}) {
    const Vec3 u = at(step, 0.13).normalized();
    ASSERT_NE(surface.face_along(u), DirectionFace::kNone);
    EXPECT_EQ(floor.face_along(u), found ? surface.face_along(u) : DirectionFace::kNone) << step;
  }
}

// The base is seen under nearly a quarter turn from its middle: its plane is not used, its corners bound it.
TEST(CapFloor, OfAFaceWithoutAPlaneIsItsRange) {
  const double corner = std::hypot(20.0, 1.0);
  const TriangleMesh mesh = cone({.base_radius = 20.0, .apex_height = 30.0, .base_depth = 1.0, .sides = 3});
  TriangleMesh base;
  test::add_face(base, mesh.vertices[2], mesh.vertices[4], mesh.vertices[3]);
  for (const Layer layer : {Layer::farthest, Layer::nearest}) {
    const SeenSurface surface(base, layer);
    ASSERT_EQ(surface.faces().size(), 1U);
    ASSERT_TRUE(surface.faces()[0].plane.isZero(0.0));
    const double sign = layer == Layer::farthest ? 1.0 : -1.0;
    const CapFloor floor(surface);
    EXPECT_NEAR(floor.within(-Vec3::UnitZ(), 0.0), sign * corner, 1e-4);
    EXPECT_EQ(floor.within(Vec3::UnitZ(), 0.0), -HUGE_VALF);
  }
}

// Its length is rounded to 0, though its face is not edge-on.
TEST(SeenSurface, HasNoVertexThatIsTooNearTheCentreForADirection) {
  TriangleMesh mesh = cup(26.0, 70.0, 100);
  const std::size_t seen = SeenSurface(mesh, Layer::nearest).vertices().size();
  test::add_face(mesh, {0.0, 0.0, 1e-200}, {20.0, 0.0, 0.0}, {0.0, 20.0, 0.0});
  const SeenSurface surface(mesh, Layer::nearest);
  EXPECT_EQ(surface.faces().size(), mesh.faces.size());
  EXPECT_EQ(surface.vertices().size(), seen + 2);
  EXPECT_TRUE(std::ranges::all_of(surface.vertices(), [](const Vec3& x) { return x.norm() > 1.0; }));
}

// An edge-on face with a corner in the centre may have any direction; no face has none.
TEST(SeenSurface, IsNearEverythingOrNothing) {
  TriangleMesh mesh;
  test::add_face(mesh, Vec3::Zero(), {20.0, 0.0, 0.0}, {0.0, 20.0, 0.0});
  test::Dice dice(75);
  for (int k = 0; k < 100; ++k) {
    const DirectionCap cap{dice.direction(), 0.01};
    EXPECT_TRUE(SeenSurface(mesh, Layer::nearest, true).any_near(cap));
    EXPECT_FALSE(SeenSurface(mesh, Layer::nearest).any_near(cap));
  }
}

// A face in a plane through the centre, and the centre in it.
TEST(SeenSurface, OfAFaceRoundTheCentreIsNearEverything) {
  TriangleMesh mesh;
  test::add_face(mesh, {-20.0, -10.0, 0.0}, {20.0, -10.0, 0.0}, {0.0, 20.0, 0.0});
  test::Dice dice(76);
  const SeenSurface seen(mesh, Layer::nearest, true);
  for (int k = 0; k < 100; ++k) EXPECT_TRUE(seen.any_near({dice.direction(), 0.01}));
}

TEST(SeenSurface, CoversCapsOfAQuarterTurnAndMore) {
  const TriangleMesh whole = test::askew(sphere(20.0, 500));
  TriangleMesh open = whole;
  const Vec3 hole =
      corner(whole, whole.faces[0], 0) + corner(whole, whole.faces[0], 1) + corner(whole, whole.faces[0], 2);
  open.faces.erase(open.faces.begin());
  PatchMemory memory;
  for (const double radius : {0.3 * kPi, 0.6 * kPi, 0.8 * kPi, kPi}) {
    for (const double away : {0.1, 0.5, 0.9}) {
      const Vec3 axis = Eigen::AngleAxisd(away * kPi, hole.unitOrthogonal()) * hole.normalized();
      for (const TriangleMesh& mesh : {whole, open}) {
        const SeenSurface surface(mesh, Layer::nearest);
        const std::uint32_t from = surface.face_along(axis);
        ASSERT_NE(from, DirectionFace::kNone);
        EXPECT_EQ(surface.covers({axis, radius}, from, memory, [](const DirectionFace&) { return true; }),
                  mesh.faces.size() == 500 || away * kPi > radius)
            << radius << " " << away;
        memory = {};
      }
    }
  }
}

// Marks of old searches that have the number of the next one would make it end at once, as if all were well.
TEST(SeenSurface, CoversWhenTheNumberOfSearchesOverflows) {
  const TriangleMesh mesh = cup(26.0, 70.0, 500);
  const SeenSurface surface(mesh, Layer::nearest);
  for (const double polar : {20.0, 60.0}) {
    const double angle = polar * kDegree;
    const DirectionCap cap{{std::sin(angle) * 0.8, std::sin(angle) * 0.6, std::cos(angle)}, 20.0 * kDegree};
    const std::uint32_t from = surface.face_along(cap.axis);
    ASSERT_NE(from, DirectionFace::kNone);
    PatchMemory memory{{}, std::vector<std::uint32_t>(mesh.faces.size(), 1U), 0xffffffffU};
    for (int again = 0; again < 3; ++again)
      EXPECT_EQ(surface.covers(cap, from, memory, [](const DirectionFace&) { return true; }), polar < 50.0);
    EXPECT_EQ(memory.search, 3U);
  }
}

}  // namespace
}  // namespace impinge
