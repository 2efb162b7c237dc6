// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points
// @links   gap thesis_forms
//
// Methods rsid_thesis and usid_thesis: the tables of the thesis, filled as the thesis does, in double.

#include <utility>

#include "mesh/star_shape.hpp"
#include "methods/table_query.hpp"
#include "methods/thesis_fills.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge::lab {
namespace {

// One of the thesis' ways of filling. Its entries are off by at most `entry_bound` inside of a surface that
// continues across each edge, and a look-up mixes them with weights that sum to 1.
template <SamplingScheme S>
PointCase thesis_case(const BenchmarkScene& scene, const TableBenchmark& bench, double precision,
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
  one.make = [&mesh = scene.surface(), precision, fill] {
    return table_query(fill(mesh, S::with_precision(precision), BenchmarkScene::kLayer));
  };
  one.bound = [&scene, bench, precision, entry_bound = std::move(entry_bound)](const PointQuery&) {
    const TriangleMesh& surface = scene.surface();
    if (!star_shape(surface).star_shaped) return MethodBound{};
    MethodBound bound = bound_of(scene, exact_radii_of<S>(surface, precision), bench);
    bound.bound_mm += entry_bound();
    bound.attained_mm = MethodBound{}.attained_mm;  // by an exact filling, not by this one
    return bound;
  };
  return one;
}

}  // namespace

Method thesis_tables_method() {
  Method method;
  method.points = [](const BenchmarkScene& scene, const PointSizes& sizes) {
    std::vector<PointCase> cases;
    const TriangleMesh& mesh = scene.surface();
    for (const double precision : sizes.tables.precisions) {
      cases.push_back(thesis_case<Rsid>(scene, sizes.tables, precision, fill_thesis,
                                        [&mesh] { return thesis_raster_bound(mesh); }));
      cases.push_back(thesis_case<Usid>(scene, sizes.tables, precision, fill_resampled<Usid>,
                                        [&mesh, precision] { return resampling_bound(mesh, precision); }));
    }
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
