// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of tables, compiled once for every scheme of the library.
#include "table/table_bound.hpp"

namespace impinge {

#define IMPINGE_BOUND(S)                                                     \
  template std::vector<float> largest_slopes(const TriangleMesh&, const S&); \
  template TableBound table_bound(const TriangleMesh&, const RadialTable<S>&, Layer, const BoundOptions&);
IMPINGE_SCHEMES(IMPINGE_BOUND)

}  // namespace impinge
