// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to fill a joint's tables: those that Tables 3 and 8 of the thesis time, and our own.
#pragma once

#include <algorithm>
#include <string_view>

#include "mesh/ball_socket_pair.hpp"
#include "methods/table_scan.hpp"
#include "methods/thesis_fills.hpp"
#include "sphere/schemes/usid.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {

// One way of filling the table of a scheme.
template <SamplingScheme S>
struct FillMethod {
  std::string_view name;                                         // in the results
  RadialTable<S> (*fill)(const TriangleMesh&, const S&, Layer);  // mesh in the centre frame
  // Proven bound on the error of an entry, mm, for a precision in degrees.
  double (*tolerance)(const TriangleMesh&, double);
  bool same_cover = false;  // does it fill exactly the entries whose ray meets the surface, also at its rim?
};

// Tolerance of methods that are exact but for rounding, mm; far above their rounding.
inline double exact_tolerance(const TriangleMesh& mesh, double /*precision_deg*/) {
  double radius = 0.0;
  for (const Vec3& v : mesh.vertices) radius = std::max(radius, v.norm());
  return 1e-9 * radius;
}

// Tolerance of the thesis' raster for any precision, mm.
inline double raster_tolerance(const TriangleMesh& mesh, double /*precision_deg*/) {
  return thesis_raster_bound(mesh);
}

// The method with which Tables 3 and 8 compare, as the thesis describes it.
inline constexpr FillMethod<Rsid> kPairwiseThesis{"pairwise_thesis", fill_thesis_pairwise<Rsid>,
                                                  exact_tolerance, true};
// The thesis' own method of Tables 3 and 8, as described there.
inline constexpr FillMethod<Rsid> kRsidThesis{"rsid_thesis", fill_thesis, raster_tolerance};
inline constexpr FillMethod<Rsid> kRsid{"rsid", fill_exact<Rsid>, exact_tolerance, true};  // our exact raster
// The thesis' way of filling its helix (Section 4.2.2).
inline constexpr FillMethod<Usid> kUsidThesis{"usid_thesis", fill_resampled<Usid>, resampling_bound};
inline constexpr FillMethod<Usid> kUsid{"usid", fill_exact<Usid>, exact_tolerance, true};  // our exact raster

// Calls visit(table, mesh, layer) for the tables of ball and socket, each filled and released in turn.
template <SamplingScheme S, class Visit>
void for_both_tables(const FillMethod<S>& method, const BallSocketPair& pair, const S& scheme,
                     Visit&& visit) {
  visit(method.fill(pair.ball, scheme, Layer::farthest), pair.ball, Layer::farthest);
  visit(method.fill(pair.socket, scheme, Layer::nearest), pair.socket, Layer::nearest);
}

// Compares `entries` entries of both tables with brute force. Throws std::runtime_error for the first error
// above the method's tolerance.
template <SamplingScheme S>
void require_filling(const FillMethod<S>& method, const BallSocketPair& pair, const S& scheme,
                     std::size_t entries) {
  for_both_tables(method, pair, scheme, [&](const auto& table, const TriangleMesh& mesh, Layer layer) {
    const double tolerance = method.tolerance(mesh, scheme.precision_deg());
    require_radii(table, mesh, layer, {entries, tolerance, method.same_cover});
  });
}

// The tables of a joint, made once and filled many times, as in a program that keeps them. So the thesis'
// sampling is timed without making, emptying, masking and freeing the tables.

// The grids and the helices of one joint and one precision.
class KeptTables {
 public:
  // Makes empty grids and helices of a precision, degrees. The pair must outlive them.
  KeptTables(const BallSocketPair& pair, double precision_deg)
      : pair_(&pair),
        ball_grid_(Rsid::with_precision(precision_deg)),
        socket_grid_(ball_grid_.scheme()),
        ball_helix_(Usid::with_precision(precision_deg)),
        socket_helix_(ball_helix_.scheme()) {}

  // Draws both surfaces over the present contents of the grids.
  void fill_grids() {
    draw_thesis(pair_->ball, Layer::farthest, ball_grid_);
    draw_thesis(pair_->socket, Layer::nearest, socket_grid_);
  }
  // fill_grids(), then reads the grids into the helices (Section 4.2.2).
  void fill_helices() {
    fill_grids();
    read_raster(ball_grid_, ball_helix_);
    read_raster(socket_grid_, socket_helix_);
  }

  const RadialTable<Rsid>& ball_grid() const { return ball_grid_; }  // as filled last, mm
  const RadialTable<Rsid>& socket_grid() const { return socket_grid_; }
  const RadialTable<Usid>& ball_helix() const { return ball_helix_; }
  const RadialTable<Usid>& socket_helix() const { return socket_helix_; }

 private:
  const BallSocketPair* pair_;
  RadialTable<Rsid> ball_grid_;
  RadialTable<Rsid> socket_grid_;
  RadialTable<Usid> ball_helix_;
  RadialTable<Usid> socket_helix_;
};

// Fills the tables. Throws std::runtime_error, as require_filling(), if a grid is off by more than
// thesis_raster_bound() or a helix by more than resampling_bound().
inline void require_kept(KeptTables& kept, const BallSocketPair& pair, std::size_t entries) {
  kept.fill_helices();
  const double precision = kept.ball_helix().scheme().precision_deg();
  const auto check = [&](const auto& table, const TriangleMesh& mesh, Layer layer, double tolerance) {
    require_radii(table, mesh, layer, {entries, tolerance, false});
  };
  check(kept.ball_grid(), pair.ball, Layer::farthest, thesis_raster_bound(pair.ball));
  check(kept.socket_grid(), pair.socket, Layer::nearest, thesis_raster_bound(pair.socket));
  check(kept.ball_helix(), pair.ball, Layer::farthest, resampling_bound(pair.ball, precision));
  check(kept.socket_helix(), pair.socket, Layer::nearest, resampling_bound(pair.socket, precision));
}

}  // namespace impinge::lab
