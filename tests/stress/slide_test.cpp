// SPDX-License-Identifier: GPL-3.0-or-later
// The slide touches the face where it is told to, ever more gently: d gap / d angle ~ angle, so that the
// condition of the angle, r / |d gap / d angle| / angle, grows as 1 / angle^2.
#include "stress/slide.hpp"

#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge::lab {
namespace {

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

}  // namespace
}  // namespace impinge::lab
