// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/rotation_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace impinge {
namespace {

constexpr double kCornerRounding = 1e-12;  // radians
constexpr std::uint32_t kSmooth = 4;       // from this level on Gauss's rule is good enough (kShareError)

// A cell as its cube and its index along each of the three sides.
struct CellPlace {
  std::size_t cube = 0;
  std::array<std::uint64_t, 3> line{};
};

CellPlace place_of(const RotationCell& cell) {
  CellPlace place;
  for (std::uint32_t bit = 0; bit < cell.level; ++bit) {
    for (std::size_t k = 0; k < 3; ++k)
      place.line[k] |= ((cell.number >> (std::size_t{3} * bit + k)) & 1U) << bit;
  }
  place.cube = static_cast<std::size_t>(cell.number >> (3 * cell.level));
  return place;
}

RotationCell cell_at(const CellPlace& place, std::uint32_t level) {
  RotationCell cell{level, static_cast<std::uint64_t>(place.cube) << (3 * level)};
  for (std::uint32_t bit = 0; bit < level; ++bit) {
    for (std::size_t k = 0; k < 3; ++k)
      cell.number |= ((place.line[k] >> bit) & 1U) << (std::size_t{3} * bit + k);
  }
  return cell;
}

// The coordinate of a quaternion that goes along a side of a cube.
std::size_t coordinate(std::size_t cube, std::size_t side) { return side < cube ? side : side + 1; }
// The side of a cube along which a coordinate goes.
std::size_t side_number(std::size_t cube, std::size_t coordinate) {
  return coordinate < cube ? coordinate : coordinate - 1;
}

// The integral of 1 / (1 + x^2 + y^2 + z^2)^2 over the cell.
double integral(const RotationCell& cell) {
  constexpr std::array<double, 4> kPoint{-0.86113631159405257522, -0.33998104358485626480,
                                         0.33998104358485626480, 0.86113631159405257522};
  constexpr std::array<double, 4> kWeight{0.34785484513745385737, 0.65214515486254614263,
                                          0.65214515486254614263, 0.34785484513745385737};
  const Quaternion4 middle = centre(cell);
  const std::size_t cube = place_of(cell).cube;
  const double half = std::ldexp(1.0, -static_cast<int>(cell.level));
  std::array<std::array<double, 4>, 3> square{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = middle[static_cast<Eigen::Index>(coordinate(cube, k))] + half * kPoint[i];
      square[k][i] = x * x;
    }
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double norm = 1.0 + square[0][i] + square[1][j] + square[2][k];
        sum += kWeight[i] * kWeight[j] * kWeight[k] / (norm * norm);
      }
    }
  }
  return sum * half * half * half;
}

}  // namespace

Quaternion4 point_of(const RotationCell& cell, const std::array<double, 3>& along) {
  const CellPlace place = place_of(cell);
  const double half = std::ldexp(1.0, -static_cast<int>(cell.level));
  Quaternion4 q;
  q[static_cast<Eigen::Index>(place.cube)] = 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = static_cast<Eigen::Index>(coordinate(place.cube, k));
    q[at] = -1.0 + half * (static_cast<double>(2 * place.line[k] + 1) + along[k]);
  }
  return q;
}

Quaternion4 centre(const RotationCell& cell) { return point_of(cell, {0.0, 0.0, 0.0}); }

Eigen::Matrix3d rotation_of(const Quaternion4& q) {
  const double w = q[0];
  const double x = q[1];
  const double y = q[2];
  const double z = q[3];
  const double norm = (w * w + x * x) + (y * y + z * z);
  Eigen::Matrix3d r;
  r << (w * w + x * x) - (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y),  //
      2.0 * (x * y + w * z), (w * w + y * y) - (x * x + z * z), 2.0 * (y * z - w * x),   //
      2.0 * (x * z - w * y), 2.0 * (y * z + w * x), (w * w + z * z) - (x * x + y * y);
  return r / norm;
}

double angular_radius(const RotationCell& cell) {
  const Quaternion4 middle = centre(cell).normalized();
  double chord = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    std::array<double, 3> along{};
    for (std::size_t k = 0; k < 3; ++k) along[k] = ((corner >> k) & 1U) != 0 ? 1.0 : -1.0;
    chord = std::max(chord, (point_of(cell, along).normalized() - middle).norm());
  }
  return 4.0 * std::asin(0.5 * chord) + kCornerRounding;
}

double share(const RotationCell& cell) {
  constexpr double kAll = std::numbers::pi * std::numbers::pi;
  if (cell.level >= kSmooth) return integral(cell) / kAll;
  double sum = 0.0;
  for (std::uint64_t k = 0; k < 8; ++k) sum += share(child(cell, k));
  return sum;
}

RotationCell cell_of(const Quaternion4& q, std::uint32_t level) {
  Eigen::Index cube = 0;
  q.cwiseAbs().maxCoeff(&cube);
  const auto number = static_cast<std::size_t>(cube);
  const double cells = std::ldexp(1.0, static_cast<int>(level));
  CellPlace place{number, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = q[static_cast<Eigen::Index>(coordinate(number, k))] / q[cube];
    place.line[k] = static_cast<std::uint64_t>(std::clamp(0.5 * (at + 1.0) * cells, 0.0, cells - 1.0));
  }
  return cell_at(place, level);
}

RotationCell beside(const RotationCell& cell, std::size_t side) {
  CellPlace place = place_of(cell);
  const std::uint64_t last = (std::uint64_t{1} << cell.level) - 1;
  const std::size_t k = side / 2;
  const bool upper = side % 2 == 1;
  if (upper ? place.line[k] < last : place.line[k] > 0) {
    place.line[k] = upper ? place.line[k] + 1 : place.line[k] - 1;
    return cell_at(place, cell.level);
  }
  // On this border the coordinate along k is 1 or -1. Divided by it the others keep or change their sign.
  const std::size_t crossed = coordinate(place.cube, k);
  CellPlace other{crossed, {}};
  for (std::size_t of = 0; of < 4; ++of) {
    if (of == crossed) continue;
    const bool own = of == place.cube;
    const std::uint64_t line = own ? last : place.line[side_number(place.cube, of)];
    other.line[side_number(crossed, of)] = upper ? line : last - line;
  }
  return cell_at(other, cell.level);
}

}  // namespace impinge
