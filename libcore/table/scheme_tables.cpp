// SPDX-License-Identifier: GPL-3.0-or-later
// Filling and bounding of tables, compiled once for every scheme of the library: each program that asked for
// all of them spent most of its compilation on these.
#include "sphere/scheme_list.hpp"
#include "table/error_bound.hpp"
#include "table/exact_raster.hpp"
#include "table/table_bound.hpp"

namespace impinge {

#define IMPINGE_COMPILE(S)                                                   \
  template std::vector<float> largest_slopes(const TriangleMesh&, const S&); \
  template RadialTable<S> fill_exact(const TriangleMesh&, const S&, Layer);  \
  template TableBound table_bound(const TriangleMesh&, const RadialTable<S>&, Layer, const BoundOptions&);
IMPINGE_SCHEMES(IMPINGE_COMPILE)

}  // namespace impinge
