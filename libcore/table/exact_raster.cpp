// SPDX-License-Identifier: GPL-3.0-or-later
// Filling, compiled once for every scheme of the library: each program that asked for all of them compiled it
// again.
#include "table/exact_raster.hpp"

namespace impinge {

#define IMPINGE_FILL(S) template RadialTable<S> fill_exact(const TriangleMesh&, const S&, Layer);
IMPINGE_SCHEMES(IMPINGE_FILL)

}  // namespace impinge
