// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <gtest/gtest.h>

#include "24_strain/layer_contact.hpp"
#include "mesh/bodies.hpp"
#include "sphere/direction.hpp"
#include "support/quadrature.hpp"

namespace impinge::test {

// A layer under a pressure by finite elements: axisymmetric quadrilaterals of nine nodes. The oracle of
// 24_strain/layer_contact.hpp; it knows no transform and no contact.

using namespace lab;

// Bonded at z = 0, held at its outer end; shear modulus 1.
class LayerElements {
 public:
  // edges: radii between elements, from 0; `rows` elements through the thickness.
  LayerElements(double poisson, double thickness, std::vector<double> edges, std::size_t rows)
      : edges_(std::move(edges)), rows_(rows), height_(thickness / static_cast<double>(rows)) {
    const double lambda = 2.0 * poisson / (1.0 - 2.0 * poisson);
    stiffness_ << lambda + 2.0, lambda, lambda, 0.0,  //
        lambda, lambda + 2.0, lambda, 0.0,            //
        lambda, lambda, lambda + 2.0, 0.0,            //
        0.0, 0.0, 0.0, 1.0;
  }

  // Solves for a pressure on the surface, smooth between the edges.
  void load(const std::function<double(double)>& pressure) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * nodes()));
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
      for (std::size_t j = 0; j < rows_; ++j) add_element(i, j, entries);
      add_load(i, pressure, force);
    }
    for (std::size_t n = 0; n < nodes(); ++n) {
      for (std::size_t way = 0; way < 2; ++way) {
        if (!held(n, way)) continue;
        const auto k = static_cast<int>(2 * n + way);
        entries.emplace_back(k, k, 1e12);  // a spring beside which the layer's own is nothing
        force[k] = 0.0;
      }
    }
    Eigen::SparseMatrix<double> matrix(force.size(), force.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    moved_ = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(force);
  }

  // Of node k of a level, 2 a element and one more: its radius, and how far it moved.
  std::size_t across() const { return 2 * (edges_.size() - 1) + 1; }
  double radius(std::size_t k) const {
    return k % 2 == 0 ? edges_[k / 2] : 0.5 * (edges_[k / 2] + edges_[k / 2 + 1]);
  }
  double surface_z(std::size_t k) const { return moved(k, 2 * rows_, 1); }
  // Derivatives along z at the bone and at the surface, of the parabola through the three nearest nodes.
  double bone_slope(std::size_t k, std::size_t way) const {
    return (4.0 * moved(k, 1, way) - moved(k, 2, way)) / height_;
  }
  double surface_slope(std::size_t k) const {
    const std::size_t top = 2 * rows_;
    return (3.0 * moved(k, top, 1) - 4.0 * moved(k, top - 1, 1) + moved(k, top - 2, 1)) / height_;
  }

 private:
  using Corners = Eigen::Matrix<double, 4, 18>;

  std::size_t nodes() const { return across() * (2 * rows_ + 1); }
  std::size_t node(std::size_t k, std::size_t level) const { return level * across() + k; }
  double moved(std::size_t k, std::size_t level, std::size_t way) const {
    return moved_[static_cast<Eigen::Index>(2 * node(k, level) + way)];
  }
  bool held(std::size_t n, std::size_t way) const {
    const std::size_t k = n % across();
    return n < across() || k + 1 == across() || (k == 0 && way == 0);
  }

  static double shape(std::size_t k, double x) {
    return k == 0 ? 0.5 * x * (x - 1.0) : k == 1 ? 1.0 - x * x : 0.5 * x * (x + 1.0);
  }
  static double shape_slope(std::size_t k, double x) {
    return k == 0 ? x - 0.5 : k == 1 ? -2.0 * x : x + 0.5;
  }

  // Strains (rr, tt, zz, rz) of the 18 displacements of an element at local x and y.
  Corners strains(std::size_t i, double x, double y) const {
    const double half = 0.5 * (edges_[i + 1] - edges_[i]);
    const double r = edges_[i] + half * (x + 1.0);
    Corners b = Corners::Zero();
    for (std::size_t n = 0; n < 9; ++n) {
      const auto u = static_cast<Eigen::Index>(2 * n);
      const double along = shape_slope(n % 3, x) * shape(n / 3, y) / half;
      const double up = shape(n % 3, x) * shape_slope(n / 3, y) / (0.5 * height_);
      b(0, u) = along;
      b(1, u) = shape(n % 3, x) * shape(n / 3, y) / r;
      b(2, u + 1) = up;
      b(3, u) = up;
      b(3, u + 1) = along;
    }
    return b;
  }

  void add_element(std::size_t i, std::size_t j, std::vector<Eigen::Triplet<double>>& entries) const {
    const double far = std::sqrt(0.6);
    const std::array<double, 3> points{-far, 0.0, far};
    const std::array<double, 3> weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    const double half = 0.5 * (edges_[i + 1] - edges_[i]);
    Eigen::Matrix<double, 18, 18> sum = Eigen::Matrix<double, 18, 18>::Zero();
    for (std::size_t p = 0; p < 3; ++p) {
      for (std::size_t q = 0; q < 3; ++q) {
        const Corners b = strains(i, points[p], points[q]);
        const double r = edges_[i] + half * (points[p] + 1.0);
        sum += weights[p] * weights[q] * r * half * 0.5 * height_ * b.transpose() * stiffness_ * b;
      }
    }
    const auto place = [&](Eigen::Index k) {
      const auto n = static_cast<std::size_t>(k) / 2;
      return static_cast<int>(2 * node(2 * i + n % 3, 2 * j + n / 3)) + static_cast<int>(k % 2);
    };
    for (Eigen::Index k = 0; k < 18; ++k)
      for (Eigen::Index l = 0; l < 18; ++l) entries.emplace_back(place(k), place(l), sum(k, l));
  }

  void add_load(std::size_t i, const std::function<double(double)>& pressure, Eigen::VectorXd& force) const {
    const double from = edges_[i];
    const double to = edges_[i + 1];
    for (std::size_t n = 0; n < 3; ++n) {
      force[static_cast<Eigen::Index>(2 * node(2 * i + n, 2 * rows_) + 1)] -=
          integral([&](double r) { return r * pressure(r) * shape(n, (2.0 * r - from - to) / (to - from)); },
                   from, to);
    }
  }

  std::vector<double> edges_;
  std::size_t rows_;
  double height_;
  Eigen::Matrix4d stiffness_;
  Eigen::VectorXd moved_;
};

}  // namespace impinge::test

namespace impinge::lab {
namespace {

// Contract: under the pressure of a contact the layer takes the shape of the sphere within it and does not
// meet it outside; no pressure pulls; for very thin and very thick layers it is the contact of Johnson,
// Jaffar and Hertz, with an error of first order in h / a or a / h.

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

// Contract: a gap g over cartilage of thickness h is a strain of 1 - g / h, 0 from g = h on, 1 from g = 0
// down, and NaN where there is no gap; by place, h is that of the map there.

TEST(GapStrain, IsTheOverlapOverTheThickness) {
  EXPECT_EQ(gap_strain(1.0, 4.0), 0.75);
  EXPECT_EQ(gap_strain(4.0, 4.0), 0.0);
  EXPECT_EQ(gap_strain(4.5, 4.0), 0.0);
  EXPECT_EQ(gap_strain(0.0, 4.0), 1.0);
  EXPECT_EQ(gap_strain(-0.5, 4.0), 1.0);
  EXPECT_TRUE(std::isnan(gap_strain(std::numeric_limits<double>::quiet_NaN(), 4.0)));
}

TEST(GapStrain, WithoutCartilageBoneTouchesBoneOrNothing) {
  EXPECT_EQ(gap_strain(1e-300, 0.0), 0.0);
  EXPECT_EQ(gap_strain(0.0, 0.0), 1.0);
}

// Concentric spheres with their ball moved by t along z: the gap of a vertex x of the socket is
// |x| - t cos - root(R^2 - t^2 sin^2), and the strain that over h (1 + z / 2) taken from 1.
TEST(GapStrain, ByPlaceTakesTheThicknessThere) {
  const TriangleMesh socket = sphere(28.0, 200);
  const double t = 1.5;
  CartilageMap map;
  std::vector<double> gap;
  std::vector<double> expected;
  for (const Vec3& x : socket.vertices) {
    const double z = x.normalized().z();
    map.directions.push_back(x.normalized());
    map.thickness.push_back(4.0 * (1.0 + 0.5 * z));
    gap.push_back(28.0 - t * z - std::sqrt(24.0 * 24.0 - t * t * (1.0 - z * z)));
    expected.push_back(std::max(0.0, 1.0 - gap.back() / map.thickness.back()));
  }
  const std::vector<double> strain = gap_strains(gap, socket.vertices, map);
  double largest = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    EXPECT_NEAR(strain[i], expected[i], 1e-15);
    largest = std::max(largest, strain[i]);
  }
  EXPECT_NEAR(largest, 1.0 - 2.5 / 6.0, 1e-12) << "at the pole";
}

}  // namespace
}  // namespace impinge::lab
