// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "10_error_against_time/methods.hpp"
#include "files/csv.hpp"
#include "mesh/star_shape.hpp"
#include "methods/resampled.hpp"
#include "methods/table_method.hpp"
#include "sphere/scheme.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/stored_table.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

std::string degrees_text(double precision) { return Cell(precision).text() + "deg"; }

// The bound of a table in double, worked out when it is first asked for and shared by the ways to store it.
using SharedBound = std::function<MethodBound()>;
SharedBound once(std::function<MethodBound()> work) {
  return [work = std::move(work), known = std::make_shared<std::optional<MethodBound>>()] {
    if (!*known) *known = work();
    return **known;
  };
}

// Of a table that was filled exactly from the surface of the scene.
template <class Table>
MethodBound bound_of(const BenchmarkScene& scene, const Table& table, const TableBenchmark& bench) {
  if (table.scheme().size() <= bench.most_entries && scene.surface().faces.size() <= bench.most_faces) {
    const TableBound found = table_bound(scene.surface(), table, BenchmarkScene::kLayer, bench.search);
    return {found.bound_mm, found.attained_mm};
  }
  MethodBound bound;
  bound.bound_mm = first_order_bound(scene.surface(), table).bound_mm;
  return bound;
}

// What the makers of one table share.
struct TableCase {
  const BenchmarkScene& scene;
  TableBenchmark bench;
  double precision = 0.0;
  std::string_view scheme;
  bool mesh_exact = false;
  SharedBound bound;

  template <class Table, class Source>
  MethodMaker maker(std::string_view storage, const Source& fill) const {
    MethodMaker maker;
    maker.name = std::string(scheme) + (mesh_exact ? "_mesh_exact" : "");
    maker.setting = degrees_text(precision) + (storage == "double" ? "" : " " + std::string(storage));
    maker.kind = "ours";
    maker.scheme = scheme;
    maker.precision_deg = precision;
    maker.interpolant = mesh_exact ? "mesh_exact" : "smooth";
    maker.storage = storage;
    maker.make = [&mesh = scene.surface(), precision = precision, fill] {
      return std::make_unique<TableMethod<Table>>(Table(fill(mesh, precision)));
    };
    maker.bound = [bound = bound](const RadiusMethod& method) {
      MethodBound of_double = bound();
      of_double.bound_mm += method.storage_bound();
      return of_double;
    };
    return maker;
  }
};

template <SamplingScheme S>
RadialTable<S> radii(const TriangleMesh& mesh, double precision) {
  return fill_exact(mesh, S::with_precision(precision), BenchmarkScene::kLayer);
}

template <class Table, class Float, class Uint16, class Source>
void add_storages(std::vector<MethodMaker>& makers, TableCase now, const Source& fill) {
  now.bound = once([&scene = now.scene, precision = now.precision, bench = now.bench, fill] {
    return bound_of(scene, Table(fill(scene.surface(), precision)), bench);
  });
  makers.push_back(now.maker<Table>("double", fill));
  makers.push_back(now.maker<Float>(FloatValues::name, fill));
  makers.push_back(now.maker<Uint16>(Uint16Values::name, fill));
}

template <SamplingScheme S>
void add_scheme(std::vector<MethodMaker>& makers, TableCase now) {
  now.scheme = S::name;
  add_storages<RadialTable<S>, FloatTable<S>, Uint16Table<S>>(makers, now, radii<S>);
  if constexpr (PlaneExactScheme<S>) {
    now.mesh_exact = true;
    add_storages<InverseDepthTable<S>, FloatInverseDepthTable<S>, Uint16InverseDepthTable<S>>(makers, now,
                                                                                              radii<S>);
  }
}

// One of the thesis' ways of filling. Its entries are off by at most `entry_bound` inside of a surface that
// continues across each edge, and a look-up mixes them with weights that sum to 1.
template <SamplingScheme S>
MethodMaker thesis_maker(const TableCase& now, RadialTable<S> (*fill)(const TriangleMesh&, const S&, Layer),
                         std::function<double()> entry_bound) {
  const TriangleMesh& mesh = now.scene.surface();
  const double precision = now.precision;
  MethodMaker maker;
  maker.name = std::string(S::name) + "_thesis";
  maker.setting = degrees_text(precision);
  maker.kind = "thesis";
  maker.scheme = S::name;
  maker.precision_deg = precision;
  maker.interpolant = "smooth";
  maker.storage = "double";
  maker.make = [&mesh, precision, fill] {
    return std::make_unique<TableMethod<RadialTable<S>>>(
        fill(mesh, S::with_precision(precision), BenchmarkScene::kLayer));
  };
  maker.bound = [now, entry_bound = std::move(entry_bound)](const RadiusMethod& /*method*/) {
    const TriangleMesh& surface = now.scene.surface();
    if (!star_shape(surface).star_shaped) return MethodBound{};
    MethodBound bound = bound_of(now.scene, radii<S>(surface, now.precision), now.bench);
    bound.bound_mm += entry_bound();
    bound.attained_mm = MethodBound{}.attained_mm;  // by an exact filling, not by this one
    return bound;
  };
  return maker;
}

}  // namespace

std::vector<MethodMaker> table_methods(const BenchmarkScene& scene, const TableBenchmark& bench) {
  std::vector<MethodMaker> makers;
  for_each_scheme([&]<class S>() {
    for (const double precision : bench.precisions) {
      if (scheme_of_precision<S>(precision)) add_scheme<S>(makers, {scene, bench, precision, {}, false, {}});
    }
  });
  return makers;
}

std::vector<MethodMaker> thesis_methods(const BenchmarkScene& scene, const TableBenchmark& bench) {
  std::vector<MethodMaker> makers;
  const TriangleMesh& mesh = scene.surface();
  for (const double precision : bench.precisions) {
    const TableCase now{scene, bench, precision, {}, false, {}};
    makers.push_back(thesis_maker<Rsid>(now, fill_thesis, [&mesh] { return thesis_raster_bound(mesh); }));
    makers.push_back(thesis_maker<Usid>(now, fill_resampled<Usid>,
                                        [&mesh, precision] { return resampling_bound(mesh, precision); }));
  }
  return makers;
}

}  // namespace impinge::lab
