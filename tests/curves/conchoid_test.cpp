// SPDX-License-Identifier: GPL-3.0-or-later
// r = a + b cos(phi) (thesis, Eq. 11): length (Eq. 12), area and incidence against quadrature, limits,
// refusals.
#include "curves/conchoid.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "curves/quadrature.hpp"
#include "sphere/direction.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

// Menschik's, a circle, almost a circle, almost a cusp, the cusp.
const ConchoidShape kConchoids[] = {{},           {22.0, 0.0},         {22.0, 1e-9},
                                    {22.0, 11.0}, {20.0, 20.0 - 1e-9}, {20.0, 20.0}};
constexpr double kAngles[] = {0.0, 1e-7, 0.01, 0.7, 0.5 * kPi, 2.5, 3.14, kPi};

// sqrt(r^2 + r'^2) as Eq. 12 has it.
double speed(const ConchoidShape& s, double phi) {
  return std::hypot(s.a + s.b * std::cos(phi), s.b * std::sin(phi));
}

TEST(Conchoid, LengthIsEq12) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : kAngles) {
      const double expected = integrate([&](double t) { return speed(shape, t); }, 0.0, phi);
      EXPECT_NEAR(meridian_length(shape, phi), expected, 1e-12 * expected) << shape.b << ' ' << phi;
      EXPECT_NEAR(conchoid_speed(shape, phi), speed(shape, phi), 1e-14 * shape.a);
    }
  }
}

TEST(Conchoid, LengthOfACircleAndOfTheCuspAreClosedForms) {
  for (const double phi : kAngles) {
    EXPECT_DOUBLE_EQ(meridian_length({22.0, 0.0}, phi), 22.0 * phi);
    EXPECT_DOUBLE_EQ(meridian_length({20.0, 20.0}, phi), 80.0 * std::sin(0.5 * phi));
  }
  // Continuous into the cusp: beyond its closed form a shape b = a (1 - e) adds a term of order e^2 ln(1 /
  // e).
  EXPECT_NEAR(meridian_length({20.0, 20.0 * (1.0 - 1e-12)}, kPi), 80.0, 1e-10);
}

// dA = 2 pi r sin(phi) ds.
TEST(Conchoid, AreaIsThatOfTheSweptSurface) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : kAngles) {
      const auto strip = [&](double t) {
        return 2.0 * kPi * (shape.a + shape.b * std::cos(t)) * std::sin(t) * speed(shape, t);
      };
      const double expected = integrate(strip, 0.0, phi);
      EXPECT_NEAR(cap_area(shape, phi), expected, 1e-12 * expected) << shape.b << ' ' << phi;
    }
  }
}

// The closed form of the header before v0 - v was taken out, where it does not cancel.
TEST(Conchoid, AreaIsTheClosedForm) {
  const ConchoidShape s;
  const double u0 = std::pow(s.a + s.b, 2);
  const double u = s.a * s.a + s.b * s.b;
  const auto primitive = [&](double x) {
    return 0.4 * std::pow(x, 2.5) + 2.0 / 3.0 * (s.a * s.a - s.b * s.b) * std::pow(x, 1.5);
  };
  const double expected = kPi / (2.0 * s.a * s.a * s.b) * (primitive(u0) - primitive(u));
  EXPECT_NEAR(cap_area(s, 0.5 * kPi), expected, 1e-12 * expected);
  EXPECT_NEAR(expected, 6218.80, 5e-3);
}

TEST(Conchoid, InversesRoundTrip) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double share : {0.0, 1e-12, 1e-3, 0.2, 0.5, 0.9, 0.9999, 1.0}) {
      const double length = share * meridian_length(shape, kPi);
      EXPECT_NEAR(meridian_length(shape, polar_angle_at_meridian_length(shape, length)), length,
                  1e-13 * length);
      const double area = share * cap_area(shape, kPi);
      EXPECT_NEAR(cap_area(shape, polar_angle_at_cap_area(shape, area)), area, 1e-13 * area);
    }
    EXPECT_EQ(polar_angle_at_meridian_length(shape, meridian_length(shape, kPi) * (1.0 + 1e-15)), kPi);
    EXPECT_EQ(polar_angle_at_cap_area(shape, cap_area(shape, kPi) * (1.0 + 1e-15)), kPi);
  }
}

// The normal turned out of the direction by psi: of the surface x(phi), n.u = cos psi.
TEST(Conchoid, IncidenceIsTheAngleOfTheNormal) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : {0.0, 0.3, 1.0, 0.5 * kPi, 2.0, 3.0}) {
      const double r = shape.a + shape.b * std::cos(phi);
      const double slope = -shape.b * std::sin(phi);
      const double tangent_x = slope * std::sin(phi) + r * std::cos(phi);
      const double tangent_z = slope * std::cos(phi) - r * std::sin(phi);
      const double along = std::abs(tangent_x * std::sin(phi) + tangent_z * std::cos(phi));
      EXPECT_NEAR(std::sin(conchoid_incidence(shape, phi)), along / std::hypot(tangent_x, tangent_z), 1e-12);
    }
  }
  EXPECT_EQ(conchoid_incidence({20.0, 20.0}, kPi), 0.5 * kPi);
  EXPECT_NEAR(conchoid_incidence({}, 0.5 * kPi), std::atan(17.843 / 20.501), 1e-15);
}

// dA / dOmega with dOmega = 2 pi sin(phi) dphi, by differences.
TEST(Conchoid, AreaPerSolidAngle) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : {0.3, 1.0, 0.5 * kPi, 2.0}) {
      const double h = 1e-4;
      const double area = cap_area(shape, phi + h) - cap_area(shape, phi - h);
      const double solid_angle = 2.0 * kPi * (std::cos(phi - h) - std::cos(phi + h));
      EXPECT_NEAR(area_per_solid_angle(shape, phi), area / solid_angle, 1e-6 * area / solid_angle);
    }
  }
}

TEST(Conchoid, NothingIsNotANumber) {
  for (const ConchoidShape& shape : kConchoids) {
    for (const double phi : kAngles) {
      for (const auto value : {conchoid_radius(shape, phi), meridian_length(shape, phi), cap_area(shape, phi),
                               conchoid_incidence(shape, phi), area_per_solid_angle(shape, phi)}) {
        EXPECT_TRUE(std::isfinite(value) && value >= 0.0) << shape.a << ' ' << shape.b << ' ' << phi;
      }
    }
  }
}

TEST(Conchoid, RefusesALoopAndSaysWhy) {
  const std::string said = test::thrown<std::invalid_argument>([] {
    static_cast<void>(meridian_length({17.843, 20.501}, 1.0));
  });
  EXPECT_NE(said.find("a < b"), std::string::npos) << said;
  EXPECT_NE(said.find("choose a >= b"), std::string::npos) << said;
}

TEST(Conchoid, RefusesWhatIsNoShapeAndNoPlaceOnIt) {
  for (const ConchoidShape& shape : {ConchoidShape{0.0, 0.0},
                                     {-1.0, -2.0},
                                     {20.0, -1.0},
                                     {std::nan(""), 1.0},
                                     {20.0, std::nan("")},
                                     {HUGE_VAL, 1.0}}) {
    EXPECT_THROW(cap_area(shape, 1.0), std::invalid_argument);
    EXPECT_THROW(conchoid_radius(shape, 1.0), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_cap_area(shape, 1.0), std::invalid_argument);
  }
  for (const double phi : {-1e-9, 3.2, std::nan("")}) {
    EXPECT_THROW(conchoid_radius({}, phi), std::invalid_argument);
    EXPECT_THROW(meridian_length({}, phi), std::invalid_argument);
    EXPECT_THROW(cap_area({}, phi), std::invalid_argument);
    EXPECT_THROW(conchoid_incidence({}, phi), std::invalid_argument);
  }
  for (const double beyond : {-1.0, 1e5, std::nan("")}) {
    EXPECT_THROW(polar_angle_at_meridian_length({}, beyond), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_cap_area({}, beyond), std::invalid_argument);
  }
}

}  // namespace
}  // namespace impinge
