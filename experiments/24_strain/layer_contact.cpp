// SPDX-License-Identifier: GPL-3.0-or-later
#include "24_strain/layer_contact.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

#include <Eigen/LU>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>

#include "sphere/direction.hpp"

namespace impinge::lab {
namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// With J0 and J1 the Hankel transforms turn the equations of elasticity into ordinary ones in z. Their
// solutions without displacement at the bone are, with s = xi z, k = 3 - 4 nu and amplitudes A and B,
//   u_z: A s sinh s + B (s cosh s - k sinh s),   u_r: -A (s cosh s + k sinh s) - B s sinh s,   over xi.
// The pressure p = integral of xi P(xi) J0(xi r) and no shear at the surface give A and B, and the
// displacement there (1 - nu) / (mu xi) P (1 - g(xi h)) with
//   g(x) = 1 - (k sinh x cosh x - x) / (k sinh^2 x + x^2 + 4 (1 - nu)^2).
// P(xi) = mu / (1 - nu) times the integral of phi(t) cos(xi t) over 0 <= t <= a leaves no pressure outside
// the circle. Abel's inversion of the depth inside gives the equation of Lebedev and Ufliand (1958)
//   phi(t) - 2 / pi integral over s of phi(s) integral over xi of g cos(xi t) cos(xi s)
//     = 2 / pi (d - t^2 / R).
// It is of the second kind and solved at Gauss-Legendre nodes. The pressure ends smoothly, so phi(a) = 0,
// which gives d. Limits: Hertz for h >> a; p = (lambda + 2 mu) (d - r^2 / 2R) / h for h << a (Johnson 1985,
// Section 5.8); and for nu = 1/2 and h << a p = 3 mu (a^2 - r^2)^2 / (32 R h^3) with d = a^2 / (4 R) (Jaffar
// 1989, Barber 1990).

constexpr double kThinnest = 0.05;  // h / a, radius of contact a
constexpr double kThickest = 50.0;
// Transforms fall as x^2 exp(-x) at the bone, and g falls twice as fast.
constexpr double kLargestArgument = 40.0;  // of x = xi h

struct Rule {
  ArrayXd node;
  ArrayXd weight;
};

// Gauss-Legendre nodes and weights from 0 to `to`.
Rule gauss(Eigen::Index count, double to) {
  const auto size = static_cast<std::size_t>(count);
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
      gsl_integration_glfixed_table_alloc(size), &gsl_integration_glfixed_table_free);
  if (!table) throw std::bad_alloc();
  Rule rule{ArrayXd(count), ArrayXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    gsl_integration_glfixed_point(0.0, to, static_cast<std::size_t>(i), &rule.node[i], &rule.weight[i],
                                  table.get());
  }
  return rule;
}

// The layer at one x = xi h. Hyperbolic functions are divided by exp(x), so that none overflows.
struct Mode {
  Mode(double x_of_h, double nu)
      : x(x_of_h),
        k(3.0 - 4.0 * nu),
        fade(std::exp(-2.0 * x)),
        c(0.5 * (1.0 + fade)),
        s(0.5 * (1.0 - fade)),
        clamp(0.25 * (1.0 + k) * (1.0 + k)),
        whole(k * s * s + (x * x + clamp) * fade) {}

  double missing() const { return fade * (x * x + x + clamp - k * s) / whole; }  // g
  // A and B divided by exp(-x), for a pressure of one.
  double amplitude_a() const { return -(2.0 * x * c + (1.0 - k) * s) / (4.0 * whole); }
  double amplitude_b() const { return ((1.0 + k) * c + 2.0 * x * s) / (4.0 * whole); }
  // d u_z / d z at the surface
  double surface_slope() const {
    return amplitude_a() * (s + x * c) + amplitude_b() * ((1.0 - k) * c + x * s);
  }

  double x;
  double k;
  double fade;
  double c;
  double s;
  double clamp;
  double whole;
};

// f of the mode at each node.
template <class F>
ArrayXd of_modes(const ArrayXd& xi, const ElasticLayer& layer, const F& f) {
  return xi.unaryExpr([&](double node) { return f(Mode(node * layer.thickness, layer.poisson)); });
}

ArrayXXd cosines(const ArrayXd& t, const ArrayXd& xi) {
  return (t.matrix() * xi.matrix().transpose()).array().cos();
}

void require_layer(const ElasticLayer& layer, double contact) {
  if (!(layer.poisson >= 0.0 && layer.poisson <= 0.5))
    throw std::invalid_argument("a layer's Poisson ratio is 0 to 0.5");
  const double share = layer.thickness / contact;
  if (!(contact > 0.0 && share >= kThinnest && share <= kThickest))
    throw std::invalid_argument("a layer is 0.05 to 50 radii of contact thick");
}

}  // namespace

LayerContact::LayerContact(const ElasticLayer& layer, double contact) : layer_(layer), a_(contact) {
  require_layer(layer, contact);
  // Enough nodes for the cosines to oscillate: xi t goes up to kLargestArgument a / h, the product twice as
  // far.
  const double turns = contact / layer.thickness;
  const Rule in_circle = gauss(static_cast<Eigen::Index>(40.0 + 20.0 * turns), contact);
  const Rule in_space =
      gauss(static_cast<Eigen::Index>(100.0 + 45.0 * turns), kLargestArgument / layer.thickness);
  t_ = in_circle.node;
  xi_ = in_space.node;
  xi_step_ = in_space.weight;
  missing_ = of_modes(xi_, layer, [](const Mode& m) { return m.missing(); }) * xi_step_;
  const MatrixXd wave = cosines(t_, xi_).matrix();
  const MatrixXd kernel = (2.0 / kPi) * wave * missing_.matrix().asDiagonal() * wave.transpose();
  const MatrixXd system =
      MatrixXd::Identity(t_.size(), t_.size()) - kernel * in_circle.weight.matrix().asDiagonal();
  MatrixXd right(t_.size(), 2);
  right << VectorXd::Constant(t_.size(), 2.0 / kPi), (2.0 / kPi) * t_.square().matrix();
  const MatrixXd both = system.partialPivLu().solve(right);
  const MatrixXd weighted = in_circle.weight.matrix().asDiagonal() * both;
  // phi(a) = 0, where phi is d times the first solution minus the second.
  const VectorXd edge = (2.0 / kPi) * weighted.transpose() * wave * ((a_ * xi_).cos() * missing_).matrix() +
                        (2.0 / kPi) * Eigen::Vector2d(1.0, a_ * a_);
  d_ = edge[1] / edge[0];
  phi_ = d_ * weighted.col(0) - weighted.col(1);
  transform_ = (wave.transpose() * phi_.matrix()).array();
}

double LayerContact::force() const { return 2.0 * kPi / (1.0 - layer_.poisson) * phi_.sum(); }

double LayerContact::bend(double t) const {
  // sin(xi t) / t, with its limit at t = 0
  const ArrayXd turned = t > 0.0 ? ArrayXd((t * xi_).sin() / t) : xi_;
  return (2.0 / kPi) * (2.0 + (missing_ * transform_ * xi_ * turned).sum());
}

// With t^2 = r^2 + v^2, dt / root(t^2 - r^2) = dv / t.
double LayerContact::pressure(double r) const {
  if (r >= a_) return 0.0;
  const Rule way = gauss(40, std::sqrt((a_ - r) * (a_ + r)));
  double sum = 0.0;
  for (Eigen::Index i = 0; i < way.node.size(); ++i) sum += way.weight[i] * bend(std::hypot(r, way.node[i]));
  return sum / (1.0 - layer_.poisson);
}

double LayerContact::sunk(double r) const {
  if (r <= a_) return d_ - 0.5 * r * r;
  const ArrayXd wave = xi_.unaryExpr([r](double xi) { return gsl_sf_bessel_J0(xi * r); });
  return (phi_ / (r * r - t_.square()).sqrt()).sum() - (missing_ * transform_ * wave).sum();
}

double LayerContact::bone_strain(double r) const {
  const ArrayXd mode = of_modes(xi_, layer_, [](const Mode& m) { return m.amplitude_b() * std::exp(-m.x); });
  const ArrayXd wave = xi_.unaryExpr([r](double xi) { return gsl_sf_bessel_J0(xi * r); });
  const double share = 2.0 * (1.0 - 2.0 * layer_.poisson) / (1.0 - layer_.poisson);  // (k - 1) / (1 - nu)
  return share * (xi_step_ * xi_ * mode * transform_ * wave).sum();
}

double LayerContact::bone_shear(double r) const {
  const ArrayXd mode = of_modes(xi_, layer_, [](const Mode& m) { return m.amplitude_a() * std::exp(-m.x); });
  const ArrayXd wave = xi_.unaryExpr([r](double xi) { return gsl_sf_bessel_J1(xi * r); });
  return -4.0 * (xi_step_ * xi_ * mode * transform_ * wave).sum();  // (1 + k) / (1 - nu)
}

// The strain of a half-space there, plus what the bone below adds to it.
double LayerContact::middle_surface_strain() const {
  const double half_space = 0.5 * (1.0 - 2.0 * layer_.poisson);
  const ArrayXd added = of_modes(xi_, layer_, [&](const Mode& m) { return m.surface_slope() + half_space; });
  return half_space * pressure(0.0) - (xi_step_ * xi_ * added * transform_).sum() / (1.0 - layer_.poisson);
}

double LayerContact::strain_by_gap(double r) const {
  return std::max(0.0, d_ - 0.5 * r * r) / layer_.thickness;
}

double LayerContact::aggregate_modulus() const {
  const double nu = layer_.poisson;
  return nu < 0.5 ? 2.0 * (1.0 - nu) / (1.0 - 2.0 * nu) : std::numeric_limits<double>::infinity();
}

double gap_strain(double gap, double thickness) {
  if (std::isnan(gap)) return gap;
  if (gap <= 0.0) return 1.0;
  return gap < thickness ? 1.0 - gap / thickness : 0.0;
}

std::vector<double> gap_strains(std::span<const double> gap, std::span<const Vec3> places,
                                const CartilageMap& map) {
  assert(gap.size() == places.size());
  std::vector<double> strains(gap.size());
  for (std::size_t i = 0; i < strains.size(); ++i)
    strains[i] = gap_strain(gap[i], thickness_at(map, places[i]));
  return strains;
}

}  // namespace impinge::lab
