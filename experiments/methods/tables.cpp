// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points gaps
// @links   gap gap_queries
//
// Every scheme at every precision it can have, in double, float and 16 bits. Schemes whose entries lie on a
// solid also have inverse depths, as SCHEME_mesh_exact. Filled exactly. Two answer all gaps of a pose.

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "methods/gaps.hpp"
#include "methods/table_query.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/stored_table.hpp"

namespace impinge::lab {
namespace {

// The bound of a table in double, worked out at first use and shared by all storages.
using SharedBound = std::function<MethodBound()>;
SharedBound once(std::function<MethodBound()> work) {
  return [work = std::move(work), known = std::make_shared<std::optional<MethodBound>>()] {
    if (!*known) *known = work();
    return **known;
  };
}

// What the cases of one table share.
struct TableCase {
  const TriangleMesh& mesh;
  Layer layer;
  TableBenchmark bench;
  double precision = 0.0;
  std::string_view scheme;
  bool mesh_exact = false;
  SharedBound bound;

  template <class Table, class Source>
  PointCase stored(std::string_view storage, const Source& fill) const {
    PointCase one;
    one.name = std::string(scheme) + (mesh_exact ? "_mesh_exact" : "");
    one.setting = degrees_text(precision) + (storage == "double" ? "" : " " + std::string(storage));
    one.place = 1000;
    one.kind = "ours";
    one.scheme = scheme;
    one.precision_deg = precision;
    one.interpolant = mesh_exact ? "mesh_exact" : "smooth";
    one.storage = storage;
    one.in_float = storage == FloatValues::name;
    // Steps of equal size have no relative error bound.
    if (storage != Uint16Values::name) one.stability = one.name;
    one.make = [&mesh = mesh, layer = layer, precision = precision, fill] {
      return table_query(Table(fill(mesh, precision, layer)));
    };
    one.bound = [bound = bound](const PointQuery& query) {
      MethodBound of_double = bound();
      of_double.bound_mm += query.storage_bound;
      return of_double;
    };
    return one;
  }
};

template <class Table, class Float, class Uint16, class Source>
void add_storages(std::vector<PointCase>& cases, TableCase now, const Source& fill) {
  now.bound = once([&mesh = now.mesh, layer = now.layer, precision = now.precision, bench = now.bench, fill] {
    return bound_of(mesh, layer, Table(fill(mesh, precision, layer)), bench);
  });
  cases.push_back(now.stored<Table>("double", fill));
  cases.push_back(now.stored<Float>(FloatValues::name, fill));
  cases.push_back(now.stored<Uint16>(Uint16Values::name, fill));
}

template <SamplingScheme S>
void add_scheme(std::vector<PointCase>& cases, TableCase now) {
  now.scheme = S::name;
  add_storages<RadialTable<S>, FloatTable<S>, Uint16Table<S>>(cases, now, exact_radii_of<S>);
  if constexpr (PlaneExactScheme<S>) {
    now.mesh_exact = true;
    add_storages<InverseDepthTable<S>, FloatInverseDepthTable<S>, Uint16InverseDepthTable<S>>(
        cases, now, exact_radii_of<S>);
  }
}

}  // namespace

Method tables_method() {
  Method method;
  method.points = [](const BenchmarkScene& scene, const PointSizes& sizes) {
    std::vector<PointCase> cases;
    for_each_scheme([&]<class S>() {
      for (const double precision : sizes.tables.precisions) {
        if (scheme_of_precision<S>(precision))
          add_scheme<S>(cases,
                        {scene.surface(), BenchmarkScene::kLayer, sizes.tables, precision, {}, false, {}});
      }
    });
    return cases;
  };
  method.gaps = [](const AskedSurface& surface, const GapSizes& sizes) {
    std::vector<PointCase> cases;
    for (const double precision : sizes.degrees) {
      const TableCase now{surface.mesh, surface.layer, sizes.bounds, precision, {}, false, {}};
      add_scheme<Conchoid>(cases, now);
      add_scheme<IcosahedralGnomonic>(cases, now);
    }
    std::erase_if(cases, [](const PointCase& one) {
      const bool flat = one.scheme == IcosahedralGnomonic::name;
      return one.storage != "double" || (one.interpolant == "mesh_exact") != flat;
    });
    return table_gaps(surface, cases);
  };
  return method;
}

}  // namespace impinge::lab
