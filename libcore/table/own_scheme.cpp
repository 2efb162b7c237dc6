// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/own_scheme.hpp"

namespace impinge {

#define IMPINGE_OF_SCHEME(S)                                                 \
  template RadialTable<S> fill_exact(const TriangleMesh&, const S&, Layer);  \
  template std::vector<float> largest_slopes(const TriangleMesh&, const S&); \
  template TableBound table_bound(const TriangleMesh&, const RadialTable<S>&, Layer, const BoundOptions&);
IMPINGE_SCHEMES(IMPINGE_OF_SCHEME)

}  // namespace impinge
