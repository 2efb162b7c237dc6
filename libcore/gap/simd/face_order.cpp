// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/face_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace impinge {
namespace {

// Place on Hilbert's curve of the square (a, b) of a board of 2^levels squares a side.
std::uint32_t hilbert_place(std::uint32_t a, std::uint32_t b, unsigned levels) {
  std::uint32_t place = 0;
  for (unsigned level = levels; level-- > 0;) {
    const std::uint32_t a_bit = a >> level & 1U;
    const std::uint32_t b_bit = b >> level & 1U;
    place = 4 * place + (3 * a_bit ^ b_bit);
    if (b_bit != 0) continue;
    if (a_bit != 0) {  // the quarter is mirrored
      a = ~a;
      b = ~b;
    }
    std::swap(a, b);
  }
  return place;
}

std::uint32_t curve_place(const Vec3& x, unsigned levels) {
  Eigen::Index axis = 0;
  const double depth = x.cwiseAbs().maxCoeff(&axis);
  const auto squares = static_cast<double>(1U << levels);
  const auto square_of = [&](Eigen::Index k) {
    const double place = 0.5 * squares * (x[k] / depth + 1.0);
    return static_cast<std::uint32_t>(std::clamp(std::floor(place), 0.0, squares - 1.0));
  };
  const std::uint32_t face = 2 * static_cast<std::uint32_t>(axis) + (x[axis] < 0.0 ? 1U : 0U);
  const std::uint32_t within =
      hilbert_place(square_of(axis == 0 ? 1 : 0), square_of(axis == 2 ? 1 : 2), levels);
  return (face << (2 * levels)) + within;
}

}  // namespace

std::vector<std::uint32_t> faces_along_curve(const TriangleMesh& mesh) {
  unsigned levels = 1;  // about one square a face
  while (std::size_t{6} << (2 * levels) < mesh.faces.size() && levels < 12) ++levels;
  std::vector<std::uint32_t> start((std::size_t{6} << (2 * levels)) + 1);
  std::vector<std::uint32_t> place(mesh.faces.size());
  std::vector<std::uint32_t> seen;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const TriangleCone cone = cone_of(mesh, mesh.faces[f]);
    if (cone.edge_on()) continue;
    seen.push_back(f);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& corner : cone.corners()) middle += corner.stableNormalized();
    place[f] = curve_place(middle, levels);
    ++start[place[f] + 1];
  }
  for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
  std::vector<std::uint32_t> order(seen.size());
  for (const std::uint32_t f : seen) order[start[place[f]]++] = f;
  return order;
}

}  // namespace impinge
