// SPDX-License-Identifier: GPL-3.0-or-later
// A layer under a pressure by finite elements: axisymmetric quadrilaterals of nine nodes. The oracle of
// 24_strain/layer_contact.hpp; it knows no transform and no contact.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "support/quadrature.hpp"

namespace impinge::test {

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
