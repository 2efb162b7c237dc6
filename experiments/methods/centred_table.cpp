// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/centred_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "mesh/edges.hpp"
#include "methods/error_range.hpp"
#include "table/near_faces.hpp"
#include "table/rim.hpp"

namespace impinge::lab {
namespace {

constexpr double kInset = 1e-6;       // of a stretch: its ends are looked up so far inside of its cell
constexpr double kMostTaken = 0.5;    // of an inverse depth, which stays above zero
constexpr double kAlike = 1e-9;       // as a share: radii of faces with corners of their own along an edge
constexpr double kNearMargin = 1e-9;  // rad, about a direction whose faces are looked for

// What is found about the errors of a table around each of its entries.
template <class S>
class ErrorRanges {
 public:
  ErrorRanges(const TriangleMesh& mesh, const InverseDepthTable<S>& table, Layer layer)
      : table_(table), layer_(layer), faces_(mesh, kNearMargin), ranges_(table.scheme().size()) {
    for_each_edge(mesh, [&](std::span<const HalfEdge> sides) { add_edge(ends(mesh, sides.front())); });
    share();
  }

  // Of all cells that read an entry, 1 / mm.
  const ErrorRange& around(std::size_t entry) const { return ranges_[entry]; }

 private:
  // Of an edge, along which both are affine while it is seen through one face of the cube.
  struct Place {
    Vec3 on_cube;          // the point in its direction
    double inverse_depth;  // 1 / mm
  };

  static Place between(const Place& from, const Place& to, double share) {
    return {from.on_cube + share * (to.on_cube - from.on_cube),
            from.inverse_depth + share * (to.inverse_depth - from.inverse_depth)};
  }

  void add_edge(const Edge& edge) {
    const Vec3& from = faces_.mesh().vertices[edge[0]];
    const Vec3& to = faces_.mesh().vertices[edge[1]];
    if (from.cross(to).squaredNorm() == 0.0) return;  // seen as a point
    const auto place = [&](const Vec3& x) -> Place {
      const double depth = table_.scheme().depth(x);
      return {x / depth, 1.0 / depth};
    };
    for_each_cell_along(table_.scheme(), RimLine{from, to},
                        [&](const Stencil& /*cell*/, const Vec3& first, const Vec3& last) {
                          add_stretch(edge, place(first), place(last));
                        });
  }

  // Within one cell.
  void add_stretch(const Edge& edge, const Place& from, const Place& to) {
    const auto at = [&](double share) { return error_at(between(from, to, share)); };
    const std::array errors{at(kInset), at(0.5), at(1.0 - kInset)};
    const Place middle = between(from, to, 0.5);
    if (std::isnan(errors[0] + errors[1] + errors[2]) || is_hidden(edge, middle)) return;
    const ErrorRange range = range_of_quadratic(errors);
    const Stencil stencil = table_.scheme().plane_stencil(middle.on_cube);
    for (std::size_t k = 0; k < stencil.taps; ++k) ranges_[stencil.entry[k]].include(range);
  }

  // NaN where the table has no answer.
  double error_at(const Place& place) const {
    const Stencil stencil = table_.scheme().plane_stencil(place.on_cube);
    if (is_at_rim(table_.scheme(), table_.rim_cells(), stencil.cell, place.on_cube)) return kNoSurface;
    return place.inverse_depth - interpolate(stencil, table_.values());
  }

  // Is another face of the layer there?
  bool is_hidden(const Edge& edge, const Place& place) const {
    const TriangleMesh& mesh = faces_.mesh();
    const Vec3 u = place.on_cube.normalized();
    const double own = place.on_cube.norm() / place.inverse_depth;
    return faces_.any_hit(u, [&](std::uint32_t f, int /*side*/) {
      const Face& face = mesh.faces[f];
      const auto has = [&face](VertexIndex v) { return std::ranges::find(face, v) != face.end(); };
      if (has(edge[0]) && has(edge[1])) return false;
      const TriangleCone cone = cone_of(mesh, face);
      if (!cone.contains(u)) return false;
      const double radius = cone.radius(u);
      return layer_ == Layer::nearest ? radius < own * (1.0 - kAlike) : radius > own * (1.0 + kAlike);
    });
  }

  // Entries on an edge of the cube are there once for each of its faces.
  void share() {
    const auto key = [](const Vec3& u) { return std::array{u.x(), u.y(), u.z()}; };
    std::map<std::array<double, 3>, ErrorRange> shared;
    std::vector<std::size_t> border;
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const Vec3 u = table_.scheme().direction(i);
      const double depth = table_.scheme().depth(u);
      if ((u.array().abs() == depth).count() < 2) continue;
      border.push_back(i);
      shared[key(u)].include(ranges_[i]);
    }
    for (const std::size_t i : border) ranges_[i] = shared[key(table_.scheme().direction(i))];
  }

  const InverseDepthTable<S>& table_;
  Layer layer_;
  NearFaces faces_;
  std::vector<ErrorRange> ranges_;
};

}  // namespace

template <PlaneExactScheme S>
RadialTable<S> centred_table(const TriangleMesh& mesh, RadialTable<S> filled, Layer layer) {
  const InverseDepthTable<S> exact(filled);
  const ErrorRanges<S> ranges(mesh, exact, layer);
  const auto radii = filled.radii();
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double inverse_depth = exact.values()[i];
    const double shift = std::max(ranges.around(i).middle(), -kMostTaken * inverse_depth);
    if (shift != 0.0) radii[i] *= inverse_depth / (inverse_depth + shift);
  }
  return filled;
}

template RadialTable<CubeEquiangular> centred_table(const TriangleMesh&, RadialTable<CubeEquiangular>, Layer);
template RadialTable<CubeGnomonic> centred_table(const TriangleMesh&, RadialTable<CubeGnomonic>, Layer);

}  // namespace impinge::lab
