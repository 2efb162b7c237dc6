// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "spectrum/gauss_grid.hpp"
#include "spectrum/power_spectrum.hpp"
#include "sphere/direction.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

const std::vector<double> kPower{1000.0, 80.0, 15.0, 4.0, 1.0};

TEST(PowerSpectrum, SharesLeaveOutTheMean) {
  const auto shares = cumulative_shares(kPower);
  const std::vector<double> expected{0.0, 0.8, 0.95, 0.99, 1.0};
  for (std::size_t l = 0; l < expected.size(); ++l) EXPECT_NEAR(shares[l], expected[l], 1e-15);
}

TEST(PowerSpectrum, BandLimitIsTheSmallestThatDoes) {
  EXPECT_EQ(band_limit(kPower, 0.0), 1U);
  EXPECT_EQ(band_limit(kPower, 0.8), 2U);
  EXPECT_EQ(band_limit(kPower, 0.81), 3U);
  EXPECT_EQ(band_limit(kPower, 0.98), 4U);
  EXPECT_EQ(band_limit(kPower, 1.0), 5U);
  EXPECT_EQ(band_limit({5.0, 0.0, 0.0}, 0.99), 1U);  // a sphere about the centre
}

TEST(PowerSpectrum, RestIsWhatTheBandLimitLeavesOut) {
  EXPECT_DOUBLE_EQ(rms_beyond(kPower, 3), std::sqrt(5.0 / (4.0 * kPi)));
  EXPECT_EQ(rms_beyond(kPower, 5), 0.0);
  for (const double rms : {0.1, 0.3, 0.7, 2.0, 100.0}) {
    const std::size_t limit = band_limit_leaving(kPower, rms);
    EXPECT_LE(limit == 5 ? 0.0 : rms_beyond(kPower, limit), rms);
    if (limit > 1) {
      EXPECT_GT(rms_beyond(kPower, limit - 1), rms);
    }
  }
}

// Entries and coefficients of the papers' own examples: L = 1 is a constant, which one entry determines.
TEST(SamplingTheorems, CountEntries) {
  EXPECT_EQ(optimal_entries(55), 3025U);
  EXPECT_EQ(mcewen_wiaux_entries(55), 5887U);
  EXPECT_EQ(driscoll_healy_entries(55), 12100U);
  EXPECT_EQ(mcewen_wiaux_entries(1), 1U);
  for (const std::size_t limit : {2U, 10U, 1000U}) {
    EXPECT_LE(optimal_entries(limit), mcewen_wiaux_entries(limit));
    EXPECT_LT(mcewen_wiaux_entries(limit), driscoll_healy_entries(limit));
    EXPECT_LE(mcewen_wiaux_entries(limit), 2 * limit * limit);
  }
  EXPECT_DOUBLE_EQ(nyquist_angle_deg(180), 1.0);
}

TEST(SamplingTheorems, AGapDeterminesABandLimit) {
  EXPECT_EQ(band_limit_of_gap(2.0 * kPi), 1U);         // one entry: the constant
  EXPECT_EQ(band_limit_of_gap(2.0 * kPi / 11.0), 6U);  // 11 entries: degree 5
  EXPECT_EQ(band_limit_of_gap(2.0 * kPi / 10.9), 5U);
  EXPECT_EQ(band_limit_of_gap(kDegree), 180U);
  EXPECT_THROW(band_limit_of_gap(0.0), std::invalid_argument);
  EXPECT_THROW(band_limit_of_gap(std::nan("")), std::invalid_argument);
}

// f = sum a_lm Y_lm: known functions, a round trip, and Parseval's sum |a_lm|^2 = integral of f^2.

HarmonicCoefficients random_coefficients(std::size_t limit) {
  HarmonicCoefficients a = zero_coefficients(limit);
  std::mt19937_64 random(61);
  const auto next = [&random] { return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1.0; };
  for (std::size_t l = 0; l < limit; ++l) {
    a.at(l, 0) = next();
    for (std::size_t m = 1; m <= l; ++m) {
      const double re = next();
      a.at(l, m) = {re, next()};
    }
  }
  return a;
}

// Real harmonics written out: sqrt(3 / 4 pi) z, sqrt(3 / 8 pi) sin e^(i theta), sqrt(5 / 16 pi) (3 z^2 - 1),
// sqrt(15 / 32 pi) sin^2 e^(2 i theta).
TEST(HarmonicTransform, FindsKnownFunctions) {
  const GaussGrid grid(8);
  const auto values = sample(grid, [](const Vec3& u) {
    return 5.0 + 2.0 * u.z() - 3.0 * u.y() + 0.5 * (3.0 * u.z() * u.z() - 1.0) + u.x() * u.x() -
           u.y() * u.y();
  });
  const HarmonicCoefficients a = analyse(grid, values);
  EXPECT_NEAR(a.at(0, 0).real(), 5.0 * std::sqrt(4.0 * kPi), 1e-13);
  EXPECT_NEAR(a.at(1, 0).real(), 2.0 * std::sqrt(4.0 * kPi / 3.0), 1e-13);
  EXPECT_NEAR(a.at(1, 1).imag(), 1.5 * std::sqrt(8.0 * kPi / 3.0), 1e-13);
  EXPECT_NEAR(a.at(2, 0).real(), 0.5 * std::sqrt(16.0 * kPi / 5.0), 1e-13);
  EXPECT_NEAR(a.at(2, 2).real(), 0.5 * std::sqrt(32.0 * kPi / 15.0), 1e-13);
  const double known = std::norm(a.at(0, 0)) + std::norm(a.at(1, 0)) + 2.0 * std::norm(a.at(1, 1)) +
                       std::norm(a.at(2, 0)) + 2.0 * std::norm(a.at(2, 2));
  double all = 0.0;
  for (const double power : power_by_degree(a)) all += power;
  EXPECT_NEAR(all, known, 1e-11);
}

TEST(HarmonicTransform, RecoversASpectrum) {
  for (const std::size_t limit : {1U, 2U, 17U, 64U}) {
    const GaussGrid grid(limit);
    const HarmonicCoefficients expected = random_coefficients(limit);
    const std::vector<double> values = synthesise(grid, expected);
    const HarmonicCoefficients found = analyse(grid, values);
    ASSERT_EQ(found.values.size(), expected.values.size());
    for (std::size_t k = 0; k < found.values.size(); ++k)
      ASSERT_LT(std::abs(found.values[k] - expected.values[k]), 1e-12) << limit << ' ' << k;
    double integral = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      integral += grid.weight(i / grid.columns()) * values[i] * values[i];
    double sum = 0.0;
    for (const double power : power_by_degree(found)) sum += power;
    EXPECT_NEAR(sum / integral, 1.0, 1e-12);
  }
}

// A high degree on its own: no other degree gets any of it.
TEST(HarmonicTransform, KeepsHighDegreesApart) {
  const GaussGrid grid(200);
  HarmonicCoefficients a = zero_coefficients(200);
  a.at(199, 3) = {1.0, -2.0};
  const auto power = power_by_degree(analyse(grid, synthesise(grid, a)));
  for (std::size_t l = 0; l < 199; ++l) EXPECT_LT(power[l], 1e-24);
  EXPECT_NEAR(power[199], 10.0, 1e-11);
}

TEST(HarmonicTransform, RefusesHolesAndOtherSizes) {
  const GaussGrid grid(4);
  std::vector<double> values(grid.size(), 1.0);
  values[3] = std::nan("");
  EXPECT_THROW(analyse(grid, values), std::invalid_argument);
  EXPECT_THROW(analyse(grid, std::vector<double>(7, 1.0)), std::invalid_argument);
  EXPECT_THROW(synthesise(grid, zero_coefficients(5)), std::invalid_argument);
}

// Integral of x^2p over the sphere: 4 pi / (2 p + 1), exact while 2 p < 2 L.
TEST(GaussGrid, IntegratesPowersExactly) {
  const GaussGrid grid(12);
  const GaussGrid fine(300);
  for (const int p : {0, 50, 299}) {
    double sum = 0.0;
    for (std::size_t i = 0; i < fine.rows(); ++i)
      sum += static_cast<double>(fine.columns()) * fine.weight(i) * std::pow(fine.z(i), 2 * p);
    EXPECT_NEAR(sum, 4.0 * kPi / (2.0 * p + 1.0), 1e-13) << p;
  }
  for (const int p : {0, 1, 3, 5, 11}) {
    for (const int axis : {0, 1, 2}) {
      double sum = 0.0;
      for (std::size_t i = 0; i < grid.rows(); ++i) {
        for (std::size_t j = 0; j < grid.columns(); ++j)
          sum += grid.weight(i) * std::pow(grid.direction(i, j)[axis], 2 * p);
      }
      EXPECT_NEAR(sum, 4.0 * kPi / (2.0 * p + 1.0), 1e-13) << p << ' ' << axis;
    }
  }
}

TEST(GaussGrid, RunsDownFromThePole) {
  for (const std::size_t limit : {1U, 2U, 7U, 64U}) {
    const GaussGrid grid(limit);
    EXPECT_EQ(grid.size(), 2 * limit * limit);
    for (std::size_t i = 0; i < grid.rows(); ++i) {
      if (i > 0) {
        EXPECT_LT(grid.z(i), grid.z(i - 1));
      }
      EXPECT_NEAR(grid.z(i), -grid.z(grid.rows() - 1 - i), 1e-15);
      EXPECT_NEAR(grid.direction(i, 1 % grid.columns()).norm(), 1.0, 4e-16);
      EXPECT_NEAR(to_angles(grid.direction(i, 0)).phi, grid.phi(i), 1e-12);
    }
  }
}

TEST(GaussGrid, CoveredShareIsBySolidAngle) {
  const GaussGrid grid(64);
  const auto half = sample(grid, [](const Vec3& u) { return u.z() > 0.0 ? 1.0 : std::nan(""); });
  EXPECT_NEAR(covered_share(grid, half), 0.5, 1e-12);
  EXPECT_EQ(covered_share(grid, sample(grid, [](const Vec3&) { return 1.0; })), 1.0);
}

TEST(GaussGrid, RefusesSizesThatMakeNoSense) {
  EXPECT_THROW(GaussGrid(0), std::invalid_argument);
  EXPECT_THROW(GaussGrid(4097), std::invalid_argument);
}

// The radii along a grid are those of rays against all faces.

TEST(GridRadii, AreThoseOfRays) {
  const GaussGrid grid(40);
  const BallSocketPair pair = make_ball_socket_pair(600);
  for (const TriangleMesh& mesh :
       {pair.ball, pair.socket, octahedron(20.0), cone(), sphere(10.0, 200, {3.0, 1.0, -2.0})}) {
    for (const Layer layer : {Layer::nearest, Layer::farthest}) {
      const auto radii = grid_radii(grid, mesh, layer);
      const RayCaster caster(mesh);
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const double expected = caster.cast(grid.direction(i / grid.columns(), i % grid.columns()), layer);
        ASSERT_EQ(std::isnan(radii[i]), std::isnan(expected)) << i;
        if (!std::isnan(expected)) {
          ASSERT_NEAR(radii[i], expected, 1e-11) << i;
        }
      }
    }
  }
}

// phi_i = arccos(i dT / r) (thesis, Section 3.5.2)

TEST(Slices, OfTheThesis) {
  const auto slices = slices_of_sphere(22.0, 1.25);
  ASSERT_EQ(slices.size(), 18U);  // the middle one and 17 above it
  EXPECT_DOUBLE_EQ(slices[0].phi, kPi / 2.0);
  EXPECT_EQ(slices[0].gap, 0.0);
  EXPECT_NEAR(slices[1].gap / kDegree, 3.2572, 1e-4);
  for (std::size_t i = 1; i < slices.size(); ++i) {
    EXPECT_NEAR(22.0 * std::cos(slices[i].phi), 1.25 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(slices[i].gap, slices[i - 1].phi - slices[i].phi, 1e-15);
    if (i > 1) {
      EXPECT_GT(slices[i].gap, slices[i - 1].gap);
    }
  }
}

TEST(Slices, TheLastOneMayTouchThePole) {
  const auto slices = slices_of_sphere(1.0, 0.1);  // 10 * 0.1 is meant to be 1
  ASSERT_EQ(slices.size(), 11U);
  EXPECT_EQ(slices.back().phi, 0.0);
  EXPECT_EQ(slices_of_sphere(5.0, 5.0).size(), 2U);
}

TEST(Slices, RefusesSizesThatMakeNoSense) {
  for (const double thickness : {0.0, -1.0, 30.0, std::nan("")})
    EXPECT_THROW(slices_of_sphere(22.0, thickness), std::invalid_argument);
  EXPECT_THROW(slices_of_sphere(std::numeric_limits<double>::infinity(), 1.0), std::invalid_argument);
}

// membrane: zero Laplacian; in a cap of half-angle a with the edge value cos(m theta) it is
//           (tan(phi / 2) / tan(a / 2))^m cos(m theta), because the Laplacian is conformal
// plate:    least squared Laplacian

constexpr double kHole = 0.6;  // radians

std::vector<double> with_hole(const GaussGrid& grid, std::vector<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (grid.phi(i / grid.columns()) < kHole) values[i] = std::nan("");
  }
  return values;
}

// Sum of l^p (l + 1)^p |a_lm|^2, the energy that a filling makes least.
double energy(const GaussGrid& grid, const std::vector<double>& values, double p) {
  const auto power = power_by_degree(analyse(grid, values));
  double sum = 0.0;
  for (std::size_t l = 0; l < power.size(); ++l) {
    const auto degree = static_cast<double>(l);
    sum += std::pow(degree * (degree + 1.0), p) * power[l];
  }
  return sum;
}

TEST(HoleFilling, LeavesAClosedSurfaceAlone) {
  const GaussGrid grid(16);
  const auto values = sample(grid, [](const Vec3& u) { return 20.0 + u.x() + u.y() * u.z(); });
  for (const Filling filling : {Filling::membrane, Filling::plate})
    EXPECT_EQ(fill_holes(grid, values, filling), values);
}

TEST(HoleFilling, KeepsWhatIsThereAndAConstantIsAConstant) {
  const GaussGrid grid(32);
  for (const Filling filling : {Filling::membrane, Filling::plate}) {
    for (const double v : fill_holes(grid, with_hole(grid, std::vector<double>(grid.size(), 7.0)), filling))
      ASSERT_NEAR(v, 7.0, 1e-9);
    const auto values = sample(grid, [](const Vec3& u) { return 20.0 + u.x() * u.z(); });
    const auto open = with_hole(grid, values);
    const auto filled = fill_holes(grid, open, filling);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isnan(open[i])) {
        ASSERT_EQ(filled[i], values[i]);
      }
    }
  }
}

TEST(HoleFilling, MembraneIsHarmonic) {
  const auto largest_error = [](std::size_t limit, int m) {
    const GaussGrid grid(limit);
    const auto exact = sample(grid, [m](const Vec3& u) {
      const auto [phi, theta] = to_angles(u);
      return std::pow(std::tan(0.5 * phi), m) * std::cos(m * theta);
    });
    const auto filled = fill_holes(grid, with_hole(grid, exact), Filling::membrane);
    double largest = 0.0;
    for (std::size_t i = 0; i < filled.size(); ++i) {
      if (grid.phi(i / grid.columns()) < kHole) largest = std::max(largest, std::abs(filled[i] - exact[i]));
    }
    return largest;
  };
  for (const int m : {1, 2, 5}) {
    EXPECT_LT(largest_error(64, m), 2e-4) << m;
    EXPECT_LT(largest_error(128, m), 0.35 * largest_error(64, m)) << m << ": not of second order";
  }
}

// Neither filling can be made better by adding a bump in the hole.
TEST(HoleFilling, HasTheLeastEnergy) {
  const GaussGrid grid(48);
  const auto open =
      with_hole(grid, sample(grid, [](const Vec3& u) { return std::exp(u.z() + 0.5 * u.x()); }));
  for (const auto& [filling, p] : {std::pair{Filling::membrane, 1.0}, {Filling::plate, 2.0}}) {
    const auto filled = fill_holes(grid, open, filling);
    const double least = energy(grid, filled, p);
    for (const double sign : {-1.0, 1.0}) {
      auto other = filled;
      for (std::size_t i = 0; i < other.size(); ++i) {
        const double t = grid.phi(i / grid.columns()) / kHole;
        if (t < 1.0) other[i] += sign * 0.1 * std::pow(1.0 - t * t, 3.0);
      }
      EXPECT_GT(energy(grid, other, p), least) << name_of(filling) << ' ' << sign;
    }
  }
}

// What the plate adds dies off faster: it has no kink.
TEST(HoleFilling, PlateIsSmoother) {
  const GaussGrid grid(96);
  const auto smooth = sample(grid, [](const Vec3& u) { return std::exp(u.z() + 0.5 * u.x()); });
  const auto high = [&](Filling filling) {
    const auto power = power_by_degree(analyse(grid, fill_holes(grid, with_hole(grid, smooth), filling)));
    return rms_beyond(power, 30);
  };
  EXPECT_LT(high(Filling::plate), 0.05 * high(Filling::membrane));
}

TEST(HoleFilling, RefusesASurfaceThatIsAllHole) {
  const GaussGrid grid(4);
  EXPECT_THROW(fill_holes(grid, std::vector<double>(grid.size(), std::nan("")), Filling::membrane),
               std::invalid_argument);
  EXPECT_THROW(fill_holes(grid, std::vector<double>(3, 1.0), Filling::plate), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
