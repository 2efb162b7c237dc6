// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>

#include "table/fill/tile_triangle.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "table/fill/tile_set_up.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "table/fill/tile_planes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

constexpr double kUlp = 0x1p-24;

// Where the numbers of some faces are stored.
struct Slot {
  TileTriangles& drawn;
  std::size_t first;
};

HWY_INLINE void store(Wide v, float* out) {
  const hn::Rebind<float, Doubles> narrow;
  hn::StoreU(hn::DemoteTo(narrow, v), narrow, out);
}
HWY_INLINE void store(Wide v, std::int32_t* out) {
  const hn::Rebind<std::int32_t, Doubles> narrow;
  hn::StoreU(hn::DemoteTo(narrow, v), narrow, out);
}

// The inverse depth from the first entry on; says where float serves.
HWY_INLINE Flags set_depth(const SomeFaces& f, const Slot& to) {
  const Doubles d;
  const Wide along_x = hn::Mul(f.q_x, hn::Sub(f.columns.first, f.x[0]));
  const Wide along_y = hn::Mul(f.q_y, hn::Sub(f.rows.first, f.y[0]));
  const Wide q = hn::Add(hn::Add(f.q[0], along_x), along_y);
  const Wide terms = hn::Add(hn::Add(hn::Abs(q), hn::Mul(hn::Abs(f.q_x), f.columns.count)),
                             hn::Mul(hn::Abs(f.q_y), f.rows.count));
  store(q, to.drawn.q.data() + to.first);
  store(f.q_x, to.drawn.q_x.data() + to.first);
  store(f.q_y, to.drawn.q_y.data() + to.first);
  return hn::Le(terms, hn::Mul(hn::Set(d, kMostTerms), least(f.q)));
}

// Edge e from the first entry on; returns what its terms add up to at most.
HWY_INLINE Wide set_edge(const SomeFaces& f, std::size_t e, const Slot& to) {
  const std::size_t next = (e + 1) % 3;
  const Wide along_x = hn::Mul(f.side, hn::Sub(f.y[e], f.y[next]));
  const Wide along_y = hn::Mul(f.side, hn::Sub(f.x[next], f.x[e]));
  const Wide first = hn::Add(hn::Mul(along_x, hn::Sub(f.columns.first, f.x[e])),
                             hn::Mul(along_y, hn::Sub(f.rows.first, f.y[e])));
  store(first, to.drawn.edge[e].data() + to.first);
  store(along_x, to.drawn.edge_x[e].data() + to.first);
  store(along_y, to.drawn.edge_y[e].data() + to.first);
  return hn::Add(hn::Add(hn::Abs(first), hn::Mul(hn::Abs(along_x), f.columns.count)),
                 hn::Mul(hn::Abs(along_y), f.rows.count));
}

HWY_INLINE void set_edges(const SomeFaces& f, double error, const Slot& to) {
  const Doubles d;
  const Wide terms = hn::Max(hn::Max(set_edge(f, 0, to), set_edge(f, 1, to)), set_edge(f, 2, to));
  const Wide rounding = hn::Mul(hn::Set(d, 8.0 * kUlp), terms);
  const Wide place = hn::Mul(hn::Set(d, error), hn::Add(hn::Mul(hn::Set(d, 5.0), f.extent), hn::Set(d, 4.0)));
  const Wide still_above_as_float = hn::Mul(hn::Add(rounding, place), hn::Set(d, 1.0 + 2.0 * kUlp));
  store(still_above_as_float, to.drawn.doubt.data() + to.first);
}

HWY_INLINE void set_window(const SomeFaces& f, const CubeTile& tile, const Slot& to) {
  const Doubles d;
  const Wide column = hn::Sub(f.columns.first, hn::Set(d, static_cast<double>(tile.first_column)));
  const Wide row = hn::Sub(f.rows.first, hn::Set(d, static_cast<double>(tile.first_row)));
  store(column, to.drawn.first_column.data() + to.first);
  store(row, to.drawn.first_row.data() + to.first);
  store(f.columns.count, to.drawn.columns.data() + to.first);
  store(f.rows.count, to.drawn.rows.data() + to.first);
}

HWY_INLINE std::uint64_t bits_of(Flags flags) {
  const Doubles d;
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, flags, bytes);
  return bytes[0];
}

void set_up_all(const CornerBatch& corners, const CubeTile& tile, std::size_t divisions,
                TileTriangles& drawn) {
  const Doubles d;
  const double error = place_error(divisions);
  drawn.seen = 0;
  drawn.clear = 0;
  for (std::size_t k = 0; k < corners.count; k += hn::Lanes(d)) {
    const Slot to{drawn, k};
    SomeFaces some;
    load(corners, k, some);
    some.columns = lines_of(some.x, tile.first_column, tile.seen_columns);
    some.rows = lines_of(some.y, tile.first_row, tile.seen_rows);
    const Flags clear = find_planes(error, some);
    const Flags float_serves = set_depth(some, to);
    set_edges(some, error, to);
    set_window(some, tile, to);
    drawn.seen |= bits_of(hn::Gt(hn::Min(some.columns.count, some.rows.count), hn::Zero(d))) << k;
    drawn.clear |= bits_of(hn::And(clear, float_serves)) << k;
  }
}

}  // namespace
}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace impinge {
namespace {

HWY_EXPORT(set_up_all);

}  // namespace

void set_up(const CornerBatch& corners, const CubeTile& tile, std::size_t divisions, TileTriangles& drawn) {
  HWY_DYNAMIC_DISPATCH(set_up_all)(corners, tile, divisions, drawn);
  const std::uint64_t used = corners.count == 0 ? 0U : ~std::uint64_t{0} >> (64U - corners.count);
  drawn.faces = corners.faces;
  drawn.seen &= used;
  drawn.clear &= drawn.seen;
}

}  // namespace impinge
#endif
