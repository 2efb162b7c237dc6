// SPDX-License-Identifier: GPL-3.0-or-later
// What a turn of a spiral has inside a triangle, or near it, TurnClip keeps.
#include "sphere/turn_clip.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sphere/entries_inside.hpp"
#include "sphere/schemes/usid.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

TriangleCone triangle(const std::vector<Vec3>& u, std::size_t k, double size) {
  return {u[k], (u[k] + size * u[k + 1]).normalized(), (u[k] + size * u[k + 2]).normalized()};
}

// Points of turns with 0.03 radians between them, at every azimuth: those in the cone are in a part.
TEST(TurnClip, KeepsAllThatIsInside) {
  constexpr double kSpacing = 0.03;
  const auto u = test::random_directions(600, 73);
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    const TriangleCone cone = triangle(u, k, k % 2 == 0 ? 0.2 : 2.0);
    if (cone.edge_on()) continue;
    const AngularBox box = angular_box(cone.corners());
    const TurnClip clip(cone, box, {0.0, kSpacing, 0.0});
    for (double phi = box.phi_min; phi <= box.phi_max; phi += kSpacing) {
      const double rise = kSpacing * box.theta_width / (2.0 * kPi);
      const double middle = std::min(phi + 0.5 * rise, kPi);
      for (std::size_t piece = 0; piece < clip.pieces(); ++piece) {
        const TurnClip::Part part = clip.part(piece, {{std::cos(middle), std::sin(middle)}, rise});
        for (double share = 0.005; share < 1.0; share += 0.01) {
          const double turn = clip.azimuth(piece) + share * (clip.azimuth(piece + 1) - clip.azimuth(piece));
          const double polar = std::min(phi + kSpacing * (turn - clip.azimuth(0)), kPi);
          if (!cone.contains(to_direction({polar, 2.0 * kPi * turn}))) continue;
          ASSERT_LE(part.from, share);
          ASSERT_GE(part.to, share);
        }
      }
    }
  }
}

// Why it is there: of the entries that a walker visits nearly all are inside.
TEST(TurnClip, KeepsLittleElse) {
  const Usid helix = Usid::with_precision(0.25);
  const auto u = test::random_directions(300, 74);
  std::size_t visited = 0;
  std::size_t inside = 0;
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    const TriangleCone cone = triangle(u, k, 0.2);
    helix.walker().visit_near(cone, 0.0, [&](const DirectionRun& run) { visited += run.count; });
    for_each_entry_inside(helix.walker(), cone, [&](std::size_t, const Vec3&) { ++inside; });
  }
  EXPECT_LT(static_cast<double>(visited), 1.25 * static_cast<double>(inside));
}

TEST(TurnClip, ClipsNothingWhereThereIsNoTriangle) {
  const Vec3 u = Vec3(1, 2, 3).normalized();
  const TriangleCone point(u, u, u);
  const TurnClip clip(point, angular_box(point.corners(), 0.1), {0.1, 0.03, 0.0});
  const TurnClip::Part part = clip.part(0, {{u.z(), std::hypot(u.x(), u.y())}, 0.0});
  EXPECT_EQ(part.from, 0.0);
  EXPECT_EQ(part.to, 1.0);
}

}  // namespace
}  // namespace impinge
