// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: under the pressure of a contact the layer takes the shape of the sphere within it and does not
// meet it outside; no pressure pulls; for very thin and very thick layers it is the contact of Johnson,
// Jaffar and Hertz, with an error of first order in h / a or a / h.
#include "24_strain/layer_contact.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "experiments/layer_elements.hpp"
#include "sphere/direction.hpp"

namespace impinge::lab {
namespace {

using test::integral;
using test::LayerElements;

LayerContact unit_contact(double poisson, double thickness) { return {{poisson, thickness}, 1.0}; }

// By how much an error grows when its small parameter doubles, as a power of two.
double order(double coarse, double fine) { return std::log2(coarse / fine); }

constexpr int kInside = 16;
constexpr std::size_t kRows = 16;

std::vector<double> element_edges(double thickness) {
  std::vector<double> edges;
  for (int k = 0; k <= kInside; ++k) edges.push_back(std::sin(0.5 * kPi * k / kInside));  // closer at the end
  const double step = edges[kInside] - edges[kInside - 1];
  for (double width = step; edges.back() < 1.0 + 6.0 * thickness + 4.0; width *= 1.3)
    edges.push_back(edges.back() + width);
  return edges;
}

class LayerByElements : public testing::TestWithParam<ElasticLayer> {};

TEST_P(LayerByElements, TakesTheShapeOfTheSphereWithTheSameStrains) {
  const ElasticLayer layer = GetParam();
  const LayerContact contact(layer, 1.0);
  LayerElements elements(layer.poisson, layer.thickness, element_edges(layer.thickness), kRows);
  elements.load([&](double r) { return contact.pressure(r); });
  const double d = contact.approach();
  double outside = 0.0;
  for (std::size_t k = 0; k < elements.across(); ++k) {
    const double r = elements.radius(k);
    const double sunk = -elements.surface_z(k);
    if (r <= 1.0) {
      EXPECT_NEAR(sunk, d - 0.5 * r * r, 0.005 * d) << "r " << r;
    } else {
      EXPECT_GT(sunk, d - 0.5 * r * r - 0.005 * d) << "the sphere is in the layer, r " << r;
    }
    if (r > 1.1 && r < 2.0) {
      EXPECT_NEAR(sunk, contact.sunk(r), 0.005 * d) << "r " << r;
      outside = std::max(outside, std::abs(sunk));
    }
  }
  EXPECT_GT(outside, 0.005 * d) << "nothing was compared there";
  const double strain = contact.strain_by_gap(0.0);
  for (std::size_t k = 0; k < elements.across() && elements.radius(k) < 1.5; ++k) {
    const double r = elements.radius(k);
    EXPECT_NEAR(-elements.bone_slope(k, 1), contact.bone_strain(r), 0.02 * strain) << "r " << r;
    EXPECT_NEAR(elements.bone_slope(k, 0), contact.bone_shear(r), 0.02 * strain) << "r " << r;
  }
  EXPECT_NEAR(-elements.surface_slope(0), contact.middle_surface_strain(), 0.02 * strain);
}

INSTANTIATE_TEST_SUITE_P(Layers, LayerByElements,
                         testing::Values(ElasticLayer{0.0, 0.5}, ElasticLayer{0.3, 0.2},
                                         ElasticLayer{0.3, 1.0}, ElasticLayer{0.45, 0.5},
                                         ElasticLayer{0.45, 2.0}, ElasticLayer{0.49, 0.3}));

TEST(LayerContact, PressuresAddUpToTheForceAndPushOnly) {
  for (const double poisson : {0.0, 0.3, 0.49, 0.5}) {
    for (const double thickness : {0.1, 0.5, 3.0}) {
      const LayerContact contact = unit_contact(poisson, thickness);
      // With r = sin(angle) the end of the contact is smooth.
      const auto ring = [&](double angle) {
        const double r = std::sin(angle);
        const double p = contact.pressure(r);
        EXPECT_GE(p, 0.0) << poisson << " " << thickness << " " << r;
        return 2.0 * kPi * r * p * std::cos(angle);
      };
      EXPECT_NEAR(integral(ring, 0.0, 0.5 * kPi), contact.force(), 1e-6 * contact.force());
    }
  }
}

// d = a^2 / R, p = 4 / (pi (1 - nu)) root(a^2 - r^2), and twice the area of contact overlaps.
TEST(LayerContact, OfAThickLayerIsThatOfHertz) {
  for (const double poisson : {0.0, 0.3, 0.5}) {
    const LayerContact thick = unit_contact(poisson, 20.0);
    const LayerContact thicker = unit_contact(poisson, 40.0);
    EXPECT_NEAR(thicker.approach(), 1.0, 0.03);
    EXPECT_NEAR(order(1.0 - thick.approach(), 1.0 - thicker.approach()), 1.0, 0.05);
    EXPECT_NEAR(thicker.force(), 8.0 / (3.0 * (1.0 - poisson)), 1e-3);
    for (const double r : {0.0, 0.4, 0.8})
      EXPECT_NEAR(thicker.pressure(r), 4.0 * std::sqrt(1.0 - r * r) / (kPi * (1.0 - poisson)), 1e-3) << r;
    // On the axis of a half-space nothing is compressed at the surface but by (1 - 2 nu) p / 2 mu.
    EXPECT_NEAR(thicker.middle_surface_strain(), (1.0 - 2.0 * poisson) * 2.0 / (kPi * (1.0 - poisson)),
                0.002);
  }
}

// Springs side by side: d = a^2 / 2R, p = (lambda + 2 mu) (d - r^2 / 2R) / h, and the same strain at all
// depths.
TEST(LayerContact, OfAThinCompressibleLayerIsThatOfSprings) {
  for (const double poisson : {0.0, 0.3}) {
    const LayerContact thin = unit_contact(poisson, 0.1);
    const LayerContact thinner = unit_contact(poisson, 0.05);
    EXPECT_NEAR(order(2.0 * thin.approach() - 1.0, 2.0 * thinner.approach() - 1.0), 1.0, 0.05);
    for (const double r : {0.0, 0.3, 0.6}) {
      EXPECT_NEAR(thinner.pressure(r), thinner.aggregate_modulus() * thinner.strain_by_gap(r),
                  0.003 * thinner.pressure(0.0));
      EXPECT_NEAR(thinner.bone_strain(r), thinner.strain_by_gap(r), 0.005 * thinner.strain_by_gap(0.0));
    }
    EXPECT_NEAR(thinner.middle_surface_strain(), thinner.strain_by_gap(0.0),
                0.001 * thinner.strain_by_gap(0.0));
  }
}

// p = 3 mu (a^2 - r^2)^2 / (32 R h^3), d = a^2 / 4R, shear r (a^2 - r^2) 3 / (8 R h^2) at the bone. The layer
// bulges at the end of the contact, as if that were wider by some thicknesses: the sixth root of the force,
// pi a^6 mu / (32 R h^3), tends to it in first order.
TEST(LayerContact, OfAThinIncompressibleLayerIsThatOfJaffar) {
  const auto wider = [](double thickness) {
    const double jaffar = kPi / (32.0 * std::pow(thickness, 3.0));
    return std::pow(unit_contact(0.5, thickness).force() / jaffar, 1.0 / 6.0) - 1.0;
  };
  EXPECT_NEAR(order(wider(0.1), wider(0.05)), 1.0, 0.05);
  const auto off = [](double thickness) { return unit_contact(0.5, thickness).approach() - 0.25; };
  EXPECT_NEAR(order(off(0.1), off(0.05)), 1.0, 0.15);
  // Extrapolated to h = 0, in first order.
  const auto limit = [](const auto& of) { return 2.0 * of(0.05) - of(0.1); };
  EXPECT_NEAR(limit([](double h) { return unit_contact(0.5, h).approach(); }), 0.25, 0.005);
  for (const double r : {0.25, 0.5}) {  // some thicknesses away from the end
    const auto profile = [r](double h) {
      const LayerContact contact = unit_contact(0.5, h);
      return std::sqrt(contact.pressure(r) / contact.pressure(0.0));
    };
    EXPECT_NEAR(limit(profile), 1.0 - r * r, 0.01) << r;
  }
  EXPECT_EQ(unit_contact(0.5, 0.1).bone_strain(0.3), 0.0) << "nothing there can give way";
}

// A layer of 0.49 and one of 0.5 meet where it is thick; where it is thin, the first gives way.
TEST(LayerContact, NearlyIncompressibleIsNotIncompressible) {
  EXPECT_NEAR(unit_contact(0.49, 10.0).force(), unit_contact(0.5, 10.0).force(),
              0.03 * unit_contact(0.5, 10.0).force());
  EXPECT_LT(unit_contact(0.49, 0.05).force(), 0.5 * unit_contact(0.5, 0.05).force());
}

TEST(LayerContact, RefusesWhatItCannotSolve) {
  EXPECT_THROW(unit_contact(-0.1, 1.0), std::invalid_argument);
  EXPECT_THROW(unit_contact(0.51, 1.0), std::invalid_argument);
  EXPECT_THROW(unit_contact(0.3, 0.04), std::invalid_argument);
  EXPECT_THROW(unit_contact(0.3, 51.0), std::invalid_argument);
  EXPECT_THROW(LayerContact({0.3, 1.0}, 0.0), std::invalid_argument);
  EXPECT_THROW(unit_contact(std::nan(""), 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace impinge::lab
