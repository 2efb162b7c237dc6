// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/hole_filling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <Eigen/SparseCholesky>

namespace impinge {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Angle from the pole of the border between row - 1 and row: half-way between them.
double border(const GaussGrid& grid, std::size_t row) {
  if (row == 0) return 0.0;
  if (row == grid.rows()) return kPi;
  return 0.5 * (grid.phi(row - 1) + grid.phi(row));
}

// A border of two cells lets through its length divided by the distance of their middles, times the
// difference of their values.
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

// The energy v' E v that a filling makes least.
Matrix energy(const GaussGrid& grid, Filling filling) {
  Matrix laplacian = stiffness(grid);
  if (filling == Filling::membrane) return laplacian;
  Eigen::VectorXd inverse_area(laplacian.rows());
  for (std::size_t i = 0; i < grid.size(); ++i)
    inverse_area[static_cast<Eigen::Index>(i)] = 1.0 / grid.weight(i / grid.columns());
  return laplacian * inverse_area.asDiagonal() * laplacian;
}

}  // namespace

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
