// SPDX-License-Identifier: GPL-3.0-or-later
// Apart, since the proof takes long to compile.
#include <concepts>

#include "sampling/exact_raster.hpp"
#include "sampling/table_bound.hpp"
#include "session.hpp"
#include "sphere/quantised_table.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge {
namespace {

template <class Floats, class Sixteen, class Table>
double storage_bound(const Table& table, Storage storage) {
  if (storage == Storage::double_precision) return 0.0;
  return storage == Storage::single_precision ? Floats(table).storage_bound()
                                              : Sixteen(table).storage_bound();
}

template <SamplingScheme S>
double bound_of(const S& scheme, Storage storage, const TriangleMesh& mesh, Layer layer) {
  const RadialTable<S> table = fill_exact(mesh, scheme, layer);
  if constexpr (std::same_as<S, CubeGnomonic>) {
    const InverseDepthTable inverse(table);
    return table_bound(mesh, inverse, layer).bound_mm +
           storage_bound<FloatInverseDepthTable<S>, Uint16InverseDepthTable<S>>(inverse, storage);
  } else {
    return table_bound(mesh, table, layer).bound_mm +
           storage_bound<FloatTable<S>, Uint16Table<S>>(table, storage);
  }
}

}  // namespace

void bound_tables(Session& session) {
  const TableSettings& settings = session.tables.settings;
  const Joint& joint = session.joint->joint;
  double bound = 0.0;
  with_scheme(settings.scheme, [&]<class S>() {
    const S scheme = S::with_precision(settings.precision_deg);
    bound = std::max(bound_of(scheme, settings.storage, joint.ball.mesh, Layer::farthest),
                     bound_of(scheme, settings.storage, joint.socket.mesh, Layer::nearest));
  });
  session.tables.bound_mm = bound;
}

}  // namespace impinge
