// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/gauss_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>

#include <Eigen/SparseCholesky>
#include <gsl/gsl_integration.h>

#include "sphere/angular_box.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {
namespace {

struct Node {
  double z = 0.0;
  double weight = 0.0;  // weight in an integral over [-1, 1]
};

// One Newton step towards the nearest root of the Legendre polynomial of degree n, and the weight there. GSL
// gives nodes beyond its tables only to 1e-10.
Node polished(double z, std::size_t n) {
  double before = 1.0;
  double here = z;
  for (std::size_t l = 1; l < n; ++l) {
    const auto degree = static_cast<double>(l);
    const double next = ((2.0 * degree + 1.0) * z * here - degree * before) / (degree + 1.0);
    before = here;
    here = next;
  }
  const double span = (1.0 - z) * (1.0 + z);
  const double slope = static_cast<double>(n) * (before - z * here) / span;
  return {z - here / slope, 2.0 / (span * slope * slope)};
}

// Visits every direction of the grid in the box.
template <class Visit>
void for_each_in_box(const GaussGrid& grid, const AngularBox& box, const Visit& visit) {
  const auto columns = static_cast<long>(grid.columns());
  const double turn = 2.0 * kPi / static_cast<double>(columns);
  const auto left = static_cast<long>(std::floor(box.theta_min / turn));
  const auto right =
      std::min(static_cast<long>(std::ceil((box.theta_min + box.theta_width) / turn)), left + columns - 1);
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    if (grid.phi(row) < box.phi_min || grid.phi(row) > box.phi_max) continue;
    for (long j = left; j <= right; ++j)
      visit(row, static_cast<std::size_t>((j % columns + columns) % columns));
  }
}

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Angle from the pole of the border between row - 1 and row: half-way between them.
double border(const GaussGrid& grid, std::size_t row) {
  if (row == 0) return 0.0;
  if (row == grid.rows()) return kPi;
  return 0.5 * (grid.phi(row - 1) + grid.phi(row));
}

// The flow through the border of two cells is the difference of their values times the length of the border,
// divided by the distance of their middles.
void add_border(Triplets& terms, std::size_t a, std::size_t b, double conductance) {
  const auto i = static_cast<Eigen::Index>(a);
  const auto j = static_cast<Eigen::Index>(b);
  terms.emplace_back(i, i, conductance);
  terms.emplace_back(j, j, conductance);
  terms.emplace_back(i, j, -conductance);
  terms.emplace_back(j, i, -conductance);
}

// Minus the Laplacian, integrated over each cell. Nothing flows through the poles.
Matrix stiffness(const GaussGrid& grid) {
  const std::size_t n = grid.columns();
  const double turn = 2.0 * kPi / static_cast<double>(n);
  Triplets terms;
  terms.reserve(8 * grid.size());
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    const double height = border(grid, row + 1) - border(grid, row);
    const double along = height / (std::sin(grid.phi(row)) * turn);
    for (std::size_t j = 0; j < n; ++j) add_border(terms, row * n + j, row * n + (j + 1) % n, along);
    if (row == 0) continue;
    const double across = std::sin(border(grid, row)) * turn / (grid.phi(row) - grid.phi(row - 1));
    for (std::size_t j = 0; j < n; ++j) add_border(terms, (row - 1) * n + j, row * n + j, across);
  }
  const auto size = static_cast<Eigen::Index>(grid.size());
  Matrix matrix(size, size);
  matrix.setFromTriplets(terms.begin(), terms.end());
  return matrix;
}

// The energy v' E v that a filling minimises.
Matrix energy(const GaussGrid& grid, Filling filling) {
  Matrix laplacian = stiffness(grid);
  if (filling == Filling::membrane) return laplacian;
  Eigen::VectorXd inverse_area(laplacian.rows());
  for (std::size_t i = 0; i < grid.size(); ++i)
    inverse_area[static_cast<Eigen::Index>(i)] = 1.0 / grid.weight(i / grid.columns());
  return laplacian * inverse_area.asDiagonal() * laplacian;
}

}  // namespace

GaussGrid::GaussGrid(std::size_t band_limit) {
  constexpr std::size_t most = 4096;
  if (band_limit < 1 || band_limit > most) {
    throw std::invalid_argument("a band limit is 1 to 4096, not " + std::to_string(band_limit));
  }
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> nodes(
      gsl_integration_glfixed_table_alloc(band_limit), &gsl_integration_glfixed_table_free);
  if (!nodes) throw std::bad_alloc();
  z_.resize(band_limit);
  phi_.resize(band_limit);
  weight_.resize(band_limit);
  for (std::size_t i = 0; i < band_limit; ++i) {
    // GSL counts upwards from -1; the grid goes down from the pole at +1.
    const std::size_t row = band_limit - 1 - i;
    double z = 0.0;
    double weight = 0.0;
    gsl_integration_glfixed_point(-1.0, 1.0, i, &z, &weight, nodes.get());
    const Node node = polished(polished(z, band_limit).z, band_limit);
    z_[row] = node.z;
    weight_[row] = node.weight * kPi / static_cast<double>(band_limit);
    phi_[row] = std::acos(z_[row]);
  }
}

Vec3 GaussGrid::direction(std::size_t row, std::size_t column) const {
  const CosSin theta = half_turn_fraction(static_cast<long>(column), static_cast<long>(rows()));
  const double s = std::sqrt((1.0 - z_[row]) * (1.0 + z_[row]));
  return {s * theta.cos, s * theta.sin, z_[row]};
}

std::vector<double> sample(const GaussGrid& grid, const std::function<double(const Vec3&)>& f) {
  std::vector<double> values;
  values.reserve(grid.size());
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) values.push_back(f(grid.direction(i, j)));
  }
  return values;
}

double covered_share(const GaussGrid& grid, const std::vector<double>& values) {
  double covered = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) {
      all += grid.weight(i);
      if (!std::isnan(values[i * grid.columns() + j])) covered += grid.weight(i);
    }
  }
  return covered / all;
}

std::vector<double> grid_radii(const GaussGrid& grid, const TriangleMesh& mesh, Layer layer) {
  std::vector<double> radii(grid.size(), kNoSurface);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    for_each_in_box(grid, angular_box(cone.corners(), 1e-9), [&](std::size_t row, std::size_t column) {
      const Vec3 u = grid.direction(row, column);
      if (cone.contains(u)) keep(radii[row * grid.columns() + column], cone.radius(u), layer);
    });
  }
  return radii;
}

std::vector<Slice> slices_of_sphere(double radius, double thickness) {
  if (!(thickness > 0.0 && thickness <= radius && std::isfinite(radius))) {
    throw std::invalid_argument("slices have a thickness above 0 and at most the radius of the sphere, mm");
  }
  const auto count = static_cast<std::size_t>(radius / thickness * (1.0 + 1e-12)) + 1;
  std::vector<Slice> slices(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double height = std::min(static_cast<double>(i) * thickness, radius);
    slices[i] = {i, height, std::acos(height / radius), 0.0};
    if (i > 0) slices[i].gap = slices[i - 1].phi - slices[i].phi;
  }
  return slices;
}

std::string_view name_of(Filling filling) { return filling == Filling::membrane ? "membrane" : "plate"; }

std::vector<double> fill_holes(const GaussGrid& grid, std::vector<double> values, Filling filling) {
  const auto empty = [](double v) { return std::isnan(v); };
  if (values.size() != grid.size() || std::ranges::all_of(values, empty)) {
    throw std::invalid_argument(
        "holes are filled from the values round them: one place a direction, and one value at least");
  }
  std::vector<Eigen::Index> unknown(values.size(), -1);
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (empty(values[i])) unknown[i] = count++;
  }
  if (count == 0) return values;
  const Matrix all = energy(grid, filling);
  Triplets terms;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  for (Eigen::Index column = 0; column < all.outerSize(); ++column) {
    const auto from = static_cast<std::size_t>(column);
    for (Matrix::InnerIterator term(all, column); term; ++term) {
      const Eigen::Index k = unknown[static_cast<std::size_t>(term.row())];
      if (k < 0) continue;
      if (unknown[from] >= 0) {
        terms.emplace_back(k, unknown[from], term.value());
      } else {
        right[k] -= term.value() * values[from];
      }
    }
  }
  Matrix matrix(count, count);
  matrix.setFromTriplets(terms.begin(), terms.end());
  const Eigen::SimplicialLDLT<Matrix> solver(matrix);
  if (solver.info() != Eigen::Success) throw std::runtime_error("holes: the equations could not be solved");
  const Eigen::VectorXd solution = solver.solve(right);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (unknown[i] >= 0) values[i] = solution[unknown[i]];
  }
  return values;
}

}  // namespace impinge
