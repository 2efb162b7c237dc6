// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces a smooth function that is costly to compute by polynomials on pieces of its interval.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace impinge {

/// The table of a function f is as accurate as f, if f is positive on (0, end), good to a few units in the
/// last place, and analytic within the circle round every x that passes 0. Pieces are halved until the
/// Chebyshev series of f on them has converged to rounding. They are short where f changes near 0 over many
/// orders of magnitude.
class SmoothTable {
 public:
  SmoothTable(const std::function<double(double)>& f, double end);  // tabulates f on [0, end]

  /// f(x) for x in [0, end]; beyond, the polynomial of the last piece.
  double operator()(double x) const;

 private:
  static constexpr std::size_t kTerms = 16;
  struct Piece {
    double middle;
    double scale;                      // 1 over half the width
    std::array<double, kTerms> power;  // coefficients of the powers of (x - middle) * scale
  };

  static double value(const Piece& piece, double x);
  static bool holds_near_zero(const Piece& piece, const std::function<double(double)>& f, double high);
  void add_pieces(const std::function<double(double)>& f, double low, double high, int depth);

  std::vector<double> ends_;  // right end of each piece
  std::vector<Piece> pieces_;
};

}  // namespace impinge
