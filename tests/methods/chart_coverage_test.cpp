// SPDX-License-Identifier: GPL-3.0-or-later
// Contract (thesis, Section 3.2, Figures 33 and 34): drawn with care for poles and seam, a face fills the
// entries that it meets, up to those between a straight edge on the chart and the great circle; drawn between
// its corners as mapped directly, it does so only away from poles and seam.
#include "methods/chart_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge::lab {
namespace {

constexpr double kSide = 6.0 * kDegree;  // half a side of a face, seen from the centre

// A face about a direction, one corner of it ahead in the direction of growing phi.
TriangleMesh face_about(Angles middle, double radius = 25.0) {
  const Vec3 u = to_direction(middle);
  const Vec3 down = to_direction({middle.phi + kPi / 2.0, middle.theta});
  const Vec3 across = u.cross(down);
  const auto at = [&](double turn) {
    return Vec3(radius * (u + kSide * (std::cos(turn) * down + std::sin(turn) * across)));
  };
  return {{at(0.1), at(0.1 + 2.0 * kPi / 3.0), at(0.1 + 4.0 * kPi / 3.0)}, {{0, 1, 2}}};
}

template <class Predicate>
long count(const std::vector<EntryCoverage>& entries, Predicate&& predicate) {
  return std::ranges::count_if(entries, predicate);
}

bool drawn_amiss(const EntryCoverage& e) { return e.drawn != e.met; }
bool direct_amiss(const EntryCoverage& e) { return e.direct != e.met; }

TEST(ChartCoverage, AwayFromPolesAllWaysAgree) {
  const auto entries = chart_coverage(face_about({1.5, 2.0}), Rsid::with_precision(0.5));
  const long met = count(entries, &EntryCoverage::met);
  EXPECT_GT(met, 100);
  EXPECT_EQ(count(entries, [](const auto& e) { return e.direct != e.drawn; }), 0);
  EXPECT_LT(count(entries, drawn_amiss), met / 20);
  for (const EntryCoverage& e : entries) {
    if (e.met && e.drawn) {
      EXPECT_NEAR(e.drawn_radius, e.met_radius, 0.05 * e.met_radius);
    }
    EXPECT_EQ(std::isnan(e.met_radius), !e.met);
    EXPECT_EQ(std::isnan(e.drawn_radius), !e.drawn);
  }
}

TEST(ChartCoverage, DirectMapMissesThePole) {
  const Rsid scheme = Rsid::with_precision(1.0);
  const auto entries = chart_coverage(face_about({0.03, 1.0}), scheme);
  for (std::size_t i = 0; i < scheme.columns(); ++i) {
    EXPECT_EQ(entries[i].entry, i);  // the whole row of the pole
    EXPECT_TRUE(entries[i].met && entries[i].drawn && !entries[i].direct);
  }
  const long met = count(entries, &EntryCoverage::met);
  EXPECT_GT(count(entries, direct_amiss), met / 2);
  // A great circle bends towards the pole: the straight edge on the chart takes in more, never less.
  EXPECT_EQ(count(entries, [](const auto& e) { return e.met && !e.drawn; }), 0);
}

// A face and the same face turned by whole columns fill as many entries, across the seam or not; the direct
// map does not.
TEST(ChartCoverage, SeamChangesNothingButTheDirectMap) {
  const Rsid scheme = Rsid::with_precision(1.0);
  const auto clear = chart_coverage(face_about({1.1, 90.0 * kDegree + 0.001}), scheme);
  const auto across = chart_coverage(face_about({1.1, 0.001}), scheme);
  EXPECT_EQ(count(across, &EntryCoverage::met), count(clear, &EntryCoverage::met));
  EXPECT_EQ(count(across, &EntryCoverage::drawn), count(clear, &EntryCoverage::drawn));
  EXPECT_GT(count(across, direct_amiss), 10 * count(clear, direct_amiss));
}

TEST(ChartCoverage, FacesAlongADirection) {
  const TriangleMesh body = octahedron(20.0);
  EXPECT_EQ(faces_along(body, Vec3(1.0, 1.0, 1.0).normalized()).faces.size(), 1U);
  EXPECT_EQ(faces_along(body, Vec3(1.0, 1.0, 0.0).normalized()).faces.size(), 2U);
  EXPECT_EQ(faces_along(body, Vec3::UnitZ()).faces.size(), 4U);
}

}  // namespace
}  // namespace impinge::lab
