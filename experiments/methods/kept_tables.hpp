// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a joint, made once and filled again and again, as in a program that keeps them. This times
// the thesis' sampling without making, emptying, masking and freeing the tables.
#pragma once

#include "mesh/ball_socket_pair.hpp"
#include "methods/resampled.hpp"
#include "methods/table_check.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge::lab {

// The grids and the helices of one joint and one precision.
class KeptTables {
 public:
  // Empty grids and helices of the precision, degrees. The pair must outlive them.
  KeptTables(const BallSocketPair& pair, double precision_deg)
      : pair_(&pair),
        ball_grid_(Rsid::with_precision(precision_deg)),
        socket_grid_(ball_grid_.scheme()),
        ball_helix_(Usid::with_precision(precision_deg)),
        socket_helix_(ball_helix_.scheme()) {}

  // Draws both surfaces over what the grids hold.
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

// Fills the tables and throws std::runtime_error, as require_filling(), if a grid is off by more than
// thesis_raster_bound(), or a helix by more than resampling_bound().
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
