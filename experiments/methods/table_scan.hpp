// SPDX-License-Identifier: GPL-3.0-or-later
// Method of the thesis (Algorithm 2): all vertices of the ball against the table of the socket, and all
// vertices of the socket against the table of the ball. It is named after the scheme of its tables. The work
// is the signed gap of every vertex of both surfaces and the smallest of these. Only vertices are tested:
// contact of two edges between vertices is not seen.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "gap/gap_scan.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {

// Tables of one joint at one precision.
template <SamplingScheme S>
struct TablePair {
  RadialTable<S> ball;    // its farthest layer
  RadialTable<S> socket;  // its nearest layer
};

/// Tables of both surfaces by the exact raster: farthest layer of the ball, nearest layer of the socket.
template <SamplingScheme S>
std::shared_ptr<const TablePair<S>> make_tables(const BallSocketPair& pair, double precision_deg) {
  const S scheme = S::with_precision(precision_deg);
  return std::make_shared<const TablePair<S>>(TablePair<S>{fill_exact(pair.ball, scheme, Layer::farthest),
                                                           fill_exact(pair.socket, scheme, Layer::nearest)});
}

template <SamplingScheme S>
class TableScan {
 public:
  // Meshes in their centre frames, mm. Their vertices are copied; the tables are shared.
  TableScan(const TriangleMesh& ball, const TriangleMesh& socket, std::shared_ptr<const TablePair<S>> tables)
      : ball_(ball.vertices),
        socket_(socket.vertices),
        tables_(std::move(tables)),
        gap_(ball_.size() + socket_.size()) {}

  bool touches(const Pose& pose) { return smallest_gap(pose) <= 0.0; }

  // The smallest gap, mm; NaN if no vertex meets the other surface.
  double smallest_gap(const Pose& pose) {
    const std::span<double> gaps(gap_);
    scan_gaps(tables_->socket, ball_, pose, Surface::ball, gaps.first(ball_.size()));
    scan_gaps(tables_->ball, socket_, pose, Surface::socket, gaps.subspan(ball_.size()));
    double smallest = std::numeric_limits<double>::infinity();
    for (const double gap : gap_) smallest = gap < smallest ? gap : smallest;  // a NaN is never smaller
    return std::isinf(smallest) ? std::numeric_limits<double>::quiet_NaN() : smallest;
  }

  // Gaps of the last pose, mm: first the ball's vertices, then the socket's.
  std::span<const double> gaps() const { return gap_; }

 private:
  std::vector<Vec3> ball_;
  std::vector<Vec3> socket_;
  std::shared_ptr<const TablePair<S>> tables_;
  std::vector<double> gap_;
};

// Checks a table by brute force over the mesh, before its filling is timed.

struct TableCheck {
  std::size_t entries = 2000;  // number compared, spread evenly over the table
  double tolerance = 0.0;      // mm
  // Must the table have a radius exactly where rays meet the mesh? If not, only entries with a radius in both
  // are compared, since a rasteriser that bends edges covers other entries along a rim.
  bool same_cover = true;
};

// `mesh` is in the centre frame. Throws std::runtime_error that names the first wrong entry.
template <SamplingScheme S>
void require_radii(const RadialTable<S>& table, const TriangleMesh& mesh, Layer layer,
                   const TableCheck& check) {
  const RayCaster oracle(mesh);
  const std::size_t stride = table.scheme().size() / check.entries + 1;
  for (std::size_t i = 0; i < table.scheme().size(); i += stride) {
    const double expected = oracle.cast(table.scheme().direction(i), layer);
    const double radius = table.radii()[i];
    const bool wrong_cover = check.same_cover && std::isnan(radius) != std::isnan(expected);
    if (!wrong_cover && !(std::abs(radius - expected) > check.tolerance)) continue;
    throw std::runtime_error("entry " + std::to_string(i) + " of a table at " +
                             std::to_string(table.scheme().precision_deg()) + " degrees holds " +
                             std::to_string(radius) + " mm, but the mesh is at " + std::to_string(expected) +
                             " mm: its time means nothing until the filling is right");
  }
}

}  // namespace impinge::lab
