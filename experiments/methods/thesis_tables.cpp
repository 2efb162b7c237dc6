// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points gaps
// @links   gap gap_queries thesis_forms
//
// Methods rsid_thesis and usid_thesis: the thesis' tables, filled as in the thesis, in double.

#include <utility>

#include "mesh/star_shape.hpp"
#include "methods/gaps.hpp"
#include "methods/table_query.hpp"
#include "methods/thesis_fills.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge::lab {
namespace {

// A way of the thesis to fill a table. Where the surface continues across each edge its entries are off by at
// most `entry_bound`; a look-up mixes them with weights that sum to 1.
template <SamplingScheme S>
PointCase thesis_case(const TriangleMesh& mesh, Layer layer, const TableBenchmark& bench, double precision,
                      RadialTable<S> (*fill)(const TriangleMesh&, const S&, Layer),
                      std::function<double()> entry_bound) {
  PointCase one;
  one.name = std::string(S::name) + "_thesis";
  one.setting = degrees_text(precision);
  one.place = 16;
  one.kind = "thesis";
  one.scheme = S::name;
  one.precision_deg = precision;
  one.interpolant = "smooth";
  one.storage = "double";
  one.make = [&mesh, layer, precision, fill] {
    return table_query(fill(mesh, S::with_precision(precision), layer));
  };
  one.bound = [&mesh, layer, bench, precision, entry_bound = std::move(entry_bound)](const PointQuery&) {
    if (!star_shape(mesh).star_shaped) return MethodBound{};
    MethodBound bound = bound_of(mesh, layer, exact_radii_of<S>(mesh, precision, layer), bench);
    bound.bound_mm += entry_bound();
    bound.attained_mm = MethodBound{}.attained_mm;  // from an exact filling, not from this one
    return bound;
  };
  return one;
}

std::vector<PointCase> thesis_cases(const TriangleMesh& mesh, Layer layer, const TableBenchmark& bench) {
  std::vector<PointCase> cases;
  for (const double precision : bench.precisions) {
    cases.push_back(thesis_case<Rsid>(mesh, layer, bench, precision, fill_thesis,
                                      [&mesh] { return thesis_raster_bound(mesh); }));
    cases.push_back(thesis_case<Usid>(mesh, layer, bench, precision, fill_resampled<Usid>,
                                      [&mesh, precision] { return resampling_bound(mesh, precision); }));
  }
  return cases;
}

}  // namespace

Method thesis_tables_method() {
  Method method;
  method.points = [](const BenchmarkScene& scene, const PointSizes& sizes) {
    return thesis_cases(scene.surface(), BenchmarkScene::kLayer, sizes.tables);
  };
  method.gaps = [](const AskedSurface& surface, const GapSizes& sizes) {
    return table_gaps(surface, thesis_cases(surface.mesh, surface.layer, sizes.of_lines()));
  };
  return method;
}

}  // namespace impinge::lab
