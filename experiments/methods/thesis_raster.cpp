// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/thesis_raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "mesh/lengths.hpp"
#include "methods/chart.hpp"
#include "sphere/vector_clones.hpp"
#include "table/error_bound.hpp"
#include "table/rim.hpp"

namespace impinge::lab {
namespace {

constexpr double kOnLine = 1e-9;    // of a grid step: a line that close to an edge counts as on it
constexpr double kOffEntry = 4e-9;  // radians: delta of thesis_raster_bound()

// The part of one grid row inside a triangle, in columns, with the distance at either end.
struct Span {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double left_radius = 0.0;
  double right_radius = 0.0;

  void include(double column, double radius) {
    if (column < left) left = column, left_radius = radius;
    if (column > right) right = column, right_radius = radius;
  }
};

// Where the row `phi` crosses the triangle.
Span row_span(const ChartTriangle& triangle, double phi, double spacing) {
  Span span;
  const double slack = kOnLine * spacing;
  for (std::size_t k = 0; k < 3; ++k) {
    const ChartPoint& a = triangle[k];
    const ChartPoint& b = triangle[(k + 1) % 3];
    if (std::abs(a.phi - phi) <= slack) span.include(a.theta / spacing, a.radius);
    if (std::min(a.phi, b.phi) < phi - slack && std::max(a.phi, b.phi) > phi + slack) {
      const double share = (phi - a.phi) / (b.phi - a.phi);
      span.include((a.theta + share * (b.theta - a.theta)) / spacing,
                   a.radius + share * (b.radius - a.radius));
    }
  }
  return span;
}

// Keeps the distances of the span in the columns from `first` on, one per entry. Written so that the compiler
// does several columns at a time.
IMPINGE_VECTOR_CLONES
void draw_columns(const Span& span, double first, Layer layer, double* entry, int count) {
  const double left = span.left;
  const double from = span.left_radius;
  const double rise = span.right_radius - span.left_radius;
  const double width = span.right > span.left ? span.right - span.left : 1.0;
  const double sign = layer == Layer::nearest ? 1.0 : -1.0;
  for (int k = 0; k < count; ++k) {
    double share = (first + static_cast<double>(k) - left) / width;
    share = share < 0.0 ? 0.0 : share;
    share = share > 1.0 ? 1.0 : share;
    const double radius = from + share * rise;
    entry[k] = sign * entry[k] <= sign * radius ? entry[k] : radius;  // keep(), without a branch
  }
}

void draw(const ChartTriangle& triangle, Layer layer, RadialTable<Rsid>& table) {
  const Rsid& scheme = table.scheme();
  const double spacing = scheme.spacing();
  const auto columns = static_cast<long>(scheme.columns());
  const auto [top, bottom] = std::minmax({triangle[0].phi, triangle[1].phi, triangle[2].phi});
  const auto last_row = std::min(static_cast<std::size_t>(bottom / spacing + kOnLine), scheme.rows() - 1);
  for (auto i = static_cast<std::size_t>(std::ceil(top / spacing - kOnLine)); i <= last_row; ++i) {
    const Span span = row_span(triangle, static_cast<double>(i) * spacing, spacing);
    if (span.left > span.right) continue;
    double* const row = table.radii().data() + i * scheme.columns();
    const long end = static_cast<long>(std::floor(span.right + kOnLine)) + 1;
    auto j = static_cast<long>(std::ceil(span.left - kOnLine));
    while (j < end) {  // from seam to seam
      const long column = ((j % columns) + columns) % columns;
      const long count = std::min(end - j, columns - column);
      draw_columns(span, static_cast<double>(j), layer, row + column, static_cast<int>(count));
      j += count;
    }
  }
}

// Extents of a drawn triangle; names as at thesis_raster_bound().
struct Extents {
  double dphi;
  double dtheta;
  double s;
  double c;
  double to_pole;  // largest distance from the nearer pole

  explicit Extents(const ChartTriangle& triangle) {
    const auto [top, bottom] = std::minmax({triangle[0].phi, triangle[1].phi, triangle[2].phi});
    const auto [left, right] = std::minmax({triangle[0].theta, triangle[1].theta, triangle[2].theta});
    dphi = bottom - top;
    dtheta = right - left;
    const bool crosses_equator = top <= kPi / 2.0 && bottom >= kPi / 2.0;
    s = crosses_equator ? 1.0 : std::max(std::sin(top), std::sin(bottom));
    c = std::max(std::abs(std::cos(top)), std::abs(std::cos(bottom)));
    to_pole = std::min(bottom, kPi - top);
  }
};

// E1 + E2 of thesis_raster_bound().
double second_order_bound(const TriangleCone& cone, const Extents& t, double largest_slope) {
  const double length2 = t.dphi * t.dphi + t.s * t.s * t.dtheta * t.dtheta;
  const double bend = t.c * t.dtheta * std::sqrt(t.s * t.s * t.dtheta * t.dtheta + 4.0 * t.dphi * t.dphi);
  const double displacement = std::asin(std::min(1.0, (bend + length2) / 8.0));
  const double psi = std::atan(cone.largest_slope()) + displacement;
  if (psi >= kPi / 2.0) return std::numeric_limits<double>::infinity();
  const double slope = std::tan(psi);
  const double radius = cone.plane_distance() / std::cos(psi);
  const double interpolation = radius / 8.0 *
                               ((1.0 + 2.0 * slope * slope) * length2 +
                                slope * t.c * (t.s * t.dtheta * t.dtheta + 2.0 * t.dtheta * t.dphi));
  return interpolation + radius * (slope * displacement + std::expm1(largest_slope * displacement));
}

double triangle_bound(const TriangleCone& cone, const ChartTriangle& triangle, double largest_slope) {
  const Extents t(triangle);
  const double farthest = std::max({triangle[0].radius, triangle[1].radius, triangle[2].radius});
  const double reach = std::min(t.dphi + t.s * t.dtheta, 2.0 * t.to_pole);
  return std::min(second_order_bound(cone, t, largest_slope), farthest * std::expm1(largest_slope * reach));
}

}  // namespace

void draw_thesis(const TriangleMesh& mesh, Layer layer, RadialTable<Rsid>& table) {
  require_lengths(mesh);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    for (const ChartTriangle& triangle : chart_triangles(cone)) draw(triangle, layer, table);
  }
}

RadialTable<Rsid> fill_thesis(const TriangleMesh& mesh, const Rsid& scheme, Layer layer) {
  RadialTable<Rsid> table(scheme);
  draw_thesis(mesh, layer, table);
  mask_rim(mesh, layer, table);
  return table;
}

double thesis_raster_bound(const TriangleMesh& mesh) {
  double slope = 0.0;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) return std::numeric_limits<double>::infinity();
    slope = std::max(slope, cone.largest_slope());
  }
  double bound = 0.0;
  double farthest = 0.0;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    for (const Vec3& v : cone.corners()) farthest = std::max(farthest, v.norm());
    for (const ChartTriangle& triangle : chart_triangles(cone)) {
      bound = std::max(bound, triangle_bound(cone, triangle, slope));
    }
  }
  return bound + farthest * first_order_share(slope, kOffEntry);
}

}  // namespace impinge::lab
