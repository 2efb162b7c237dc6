// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/smooth_table.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/direction.hpp"

namespace impinge {
namespace {

template <std::size_t N>
using Series = std::array<double, N>;

// cos(pi j (2 k + 1) / 2 N): T_j at node k.
template <std::size_t N>
double chebyshev_at_node(std::size_t j, std::size_t k) {
  return half_turn_fraction(static_cast<long>(j * (2 * k + 1)), 2 * static_cast<long>(N)).cos;
}

// Coefficients of the Chebyshev series that equals f at the N Chebyshev nodes of [low, high].
template <std::size_t N>
Series<N> chebyshev_series(const std::function<double(double)>& f, double low, double high) {
  static const std::array<Series<N>, N> polynomial = [] {
    std::array<Series<N>, N> table;
    for (std::size_t j = 0; j < N; ++j)
      for (std::size_t k = 0; k < N; ++k) table[j][k] = chebyshev_at_node<N>(j, k);
    return table;
  }();
  Series<N> value;
  for (std::size_t k = 0; k < N; ++k)
    value[k] = f(0.5 * (low + high) + 0.5 * (high - low) * polynomial[1][k]);
  Series<N> series;
  for (std::size_t j = 0; j < N; ++j) {
    double sum = 0.0;
    for (std::size_t k = 0; k < N; ++k) sum += value[k] * polynomial[j][k];
    series[j] = sum * (j == 0 ? 1.0 : 2.0) / static_cast<double>(N);
  }
  return series;
}

// The same polynomial in powers: T_0 = 1, T_1 = x, T_(j+1) = 2 x T_j - T_(j-1).
template <std::size_t N>
Series<N> powers(const Series<N>& series) {
  Series<N> power{};
  Series<N> before{};
  Series<N> here{};
  here[0] = 1.0;
  for (std::size_t j = 0; j < N; ++j) {
    for (std::size_t k = 0; k <= j; ++k) power[k] += series[j] * here[k];
    Series<N> next{};
    for (std::size_t k = 0; k < N; ++k)
      next[k] = (k == 0 ? 0.0 : (j == 0 ? 1.0 : 2.0) * here[k - 1]) - before[k];
    before = here;
    here = next;
  }
  return power;
}

}  // namespace

SmoothTable::SmoothTable(const std::function<double(double)>& f, double end) { add_pieces(f, 0.0, end, 0); }

void SmoothTable::add_pieces(const std::function<double(double)>& f, double low, double high, int depth) {
  constexpr double kRounding = 1e-15;
  constexpr double kNarrow = 1.0 / 32.0;  // of the distance from 0; in such a piece only rounding is left
  constexpr int kDeepest = 200;
  const Series<kTerms> series = chebyshev_series<kTerms>(f, low, high);
  const Piece piece{0.5 * (low + high), 2.0 / (high - low), powers(series)};
  const double rest = std::max(std::abs(series[kTerms - 1]), std::abs(series[kTerms - 2]));
  const bool wide = high - low > kNarrow * high;
  const bool good = rest <= kRounding * std::abs(series[0]) && (low > 0.0 || holds_near_zero(piece, f, high));
  if (wide && !good && depth < kDeepest) {
    const double middle = 0.5 * (low + high);
    add_pieces(f, low, middle, depth + 1);
    add_pieces(f, middle, high, depth + 1);
    return;
  }
  ends_.push_back(high);
  pieces_.push_back(piece);
}

// The series does not see what f does much nearer to 0 than the first node.
bool SmoothTable::holds_near_zero(const Piece& piece, const std::function<double(double)>& f, double high) {
  constexpr double kGood = 4e-15;
  constexpr double kNearest = 1e-18;
  for (double x = 0.25 * high; x > kNearest * high; x *= 0.25) {
    const double expected = f(x);
    if (std::abs(value(piece, x) - expected) > kGood * expected) return false;
  }
  return true;
}

double SmoothTable::value(const Piece& piece, double x) {
  const double t = (x - piece.middle) * piece.scale;
  const double t2 = t * t;
  const double t4 = t2 * t2;
  const auto four = [&](std::size_t k) {
    const auto& c = piece.power;
    return (c[k] + c[k + 1] * t) + (c[k + 2] + c[k + 3] * t) * t2;
  };
  return (four(0) + four(4) * t4) + (four(8) + four(12) * t4) * (t4 * t4);
}

double SmoothTable::operator()(double x) const {
  const auto end = std::lower_bound(ends_.begin(), ends_.end() - 1, x);
  return value(pieces_[static_cast<std::size_t>(end - ends_.begin())], x);
}

}  // namespace impinge
