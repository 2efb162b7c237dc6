// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/rings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "mesh/vertex_ring.hpp"

namespace impinge {
namespace {

using Counts = std::vector<std::size_t>;

// Divides `total` in proportion to the sines of the polar angles k * step, k = 1..rings, into integers.
// Running sums are rounded, so that they add up.
Counts ring_sizes(std::size_t total, std::size_t rings, double step) {
  std::vector<double> sum(rings + 1, 0.0);
  for (std::size_t k = 1; k <= rings; ++k) sum[k] = sum[k - 1] + std::sin(step * static_cast<double>(k));
  Counts sizes;
  std::size_t used = 0;
  for (std::size_t k = 1; k <= rings; ++k) {
    const auto upto = static_cast<std::size_t>(std::lround(static_cast<double>(total) * sum[k] / sum[rings]));
    sizes.push_back(upto - used);
    used = upto;
  }
  return sizes;
}

bool all_are_rings(const Counts& sizes) {
  return std::ranges::all_of(sizes, [](std::size_t n) { return n >= 3; });
}

// Edge of an equilateral triangle, if `faces` of them cover `area`.
double edge_length(double area, std::size_t faces) {
  return std::sqrt(4.0 * area / (static_cast<double>(faces) * std::sqrt(3.0)));
}

std::size_t rounded_at_least(long least, double x) {
  return static_cast<std::size_t>(std::max(least, std::lround(x)));
}

Counts sphere_rings(std::size_t faces) {
  const double height = edge_length(4.0 * kPi, faces) * std::sqrt(0.75);
  for (std::size_t rings = rounded_at_least(1, kPi / height - 1.0);; --rings) {
    Counts sizes = ring_sizes(faces / 2, rings, kPi / static_cast<double>(rings + 1));
    if (rings == 1 || all_are_rings(sizes)) return sizes;
  }
}

// The rim, the last ring, has the parity of the number of faces; the rest is divided as on the sphere.
Counts cap_rings(std::size_t faces, double half_opening) {
  const double edge = edge_length(2.0 * kPi * (1.0 - std::cos(half_opening)), faces);
  std::size_t rim = rounded_at_least(3, 2.0 * kPi * std::sin(half_opening) / edge);
  if ((faces - rim) % 2 != 0) ++rim;
  for (std::size_t rings = rounded_at_least(1, half_opening / (edge * std::sqrt(0.75)));; --rings) {
    if (rings == 1 || rim >= faces) return {faces};
    Counts sizes = ring_sizes((faces - rim) / 2, rings - 1, half_opening / static_cast<double>(rings));
    sizes.push_back(rim);
    if (all_are_rings(sizes)) return sizes;
  }
}

// Appends n points on the parallel at height z; every second ring is turned by half a step.
void append_ring(TriangleMesh& mesh, std::size_t n, double z, bool turned) {
  const double rho = std::sqrt((1.0 - z) * (1.0 + z));
  for (std::size_t k = 0; k < n; ++k) {
    const CosSin c = half_turn_fraction(static_cast<long>(2 * k + (turned ? 1 : 0)), static_cast<long>(n));
    mesh.vertices.emplace_back(rho * c.cos, rho * c.sin, z);
  }
}

// The points of pole and rings. Each vertex stands for the same area (a rim vertex for half of it), which
// gives the heights; the first `total` shares lie above `bottom`.
TriangleMesh ring_points(const Counts& sizes, double total, double bottom) {
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0.0, 0.0, 1.0);
  double above = 1.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto n = static_cast<double>(sizes[i]);
    const double share = (above + 0.5 * n) / total;
    append_ring(mesh, sizes[i], share < 1.0 ? 1.0 - (1.0 - bottom) * share : bottom, i % 2 != 0);
    above += n;
  }
  return mesh;
}

// Adds the faces between pole and first ring, and of all bands. Returns the last ring.
VertexRing stitch_rings(TriangleMesh& mesh, const Counts& sizes) {
  VertexRing ring{1, sizes[0]};
  for (std::size_t k = 0; k < ring.size; ++k) mesh.faces.push_back({0, ring[k], ring[k + 1]});
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    const VertexRing next{ring.first + ring.size, sizes[i]};
    stitch(mesh, ring, next);
    ring = next;
  }
  return ring;
}

}  // namespace

TriangleMesh unit_sphere(std::size_t faces) {
  if (faces < 8 || faces % 2 != 0) {
    throw std::invalid_argument("a closed sphere needs an even number of faces, 8 or more, not " +
                                std::to_string(faces));
  }
  const Counts sizes = sphere_rings(faces);
  const std::size_t vertices = faces / 2 + 2;
  TriangleMesh mesh = ring_points(sizes, static_cast<double>(vertices), -1.0);
  const VertexRing last = stitch_rings(mesh, sizes);
  const auto south = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.0, 0.0, -1.0);
  for (std::size_t k = 0; k < last.size; ++k) mesh.faces.push_back({last[k], south, last[k + 1]});
  return mesh;
}

TriangleMesh unit_cap(std::size_t faces, double half_opening) {
  if (faces < 3) {
    throw std::invalid_argument("a spherical cap needs 3 faces or more, not " + std::to_string(faces));
  }
  if (!(half_opening > 0.0 && half_opening < kPi)) {
    throw std::invalid_argument(
        "the half opening of a spherical cap lies between 0 and 180 degrees, not at " +
        std::to_string(half_opening / kDegree));
  }
  const Counts sizes = cap_rings(faces, half_opening);
  const std::size_t vertices = 1 + std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  const double total = static_cast<double>(vertices) - 0.5 * static_cast<double>(sizes.back());
  TriangleMesh mesh = ring_points(sizes, total, std::cos(half_opening));
  stitch_rings(mesh, sizes);
  return mesh;
}

}  // namespace impinge
