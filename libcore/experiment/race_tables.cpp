// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "contenders/table_method.hpp"
#include "experiment/csv.hpp"
#include "experiment/race_bound.hpp"
#include "experiment/race_methods.hpp"
#include "mesh/star_shape.hpp"
#include "sampling/exact_raster.hpp"
#include "sampling/resampled.hpp"
#include "sphere/quantised_table.hpp"
#include "sphere/scheme_list.hpp"

namespace impinge {
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

// What the makers of one table share.
struct TableCase {
  const RaceScene& scene;
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
  return fill_exact(mesh, S::with_precision(precision), RaceScene::kLayer);
}

template <PlaneExactScheme S>
InverseDepthTable<S> inverse_depths(const TriangleMesh& mesh, double precision) {
  return InverseDepthTable<S>(radii<S>(mesh, precision));
}

template <class Table, class Float, class Uint16, class Source>
void add_storages(std::vector<MethodMaker>& makers, TableCase now, const Source& fill) {
  now.bound = once([&mesh = now.scene.surface(), precision = now.precision, fill] {
    return table_method_bound(mesh, Table(fill(mesh, precision)), RaceScene::kLayer);
  });
  makers.push_back(now.maker<Table>("double", fill));
  makers.push_back(now.maker<Float>(FloatValues::name, fill));
  makers.push_back(now.maker<Uint16>(Uint16Values::name, fill));
}

template <SamplingScheme S>
void add_scheme(std::vector<MethodMaker>& makers, const RaceScene& scene, double precision) {
  add_storages<RadialTable<S>, FloatTable<S>, Uint16Table<S>>(makers, {scene, precision, S::name, false, {}},
                                                              radii<S>);
  if constexpr (PlaneExactScheme<S>) {
    add_storages<InverseDepthTable<S>, FloatInverseDepthTable<S>, Uint16InverseDepthTable<S>>(
        makers, {scene, precision, S::name, true, {}}, inverse_depths<S>);
  }
}

// Has the scheme entries so far apart?
template <SamplingScheme S>
bool has_precision(double precision) {
  try {
    static_cast<void>(S::with_precision(precision));
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// One of the thesis' ways of filling. Its entries are off by at most `entry_bound` inside of a surface that
// continues across each edge, and a look-up mixes them with weights that sum to 1.
template <SamplingScheme S>
MethodMaker thesis_maker(const RaceScene& scene, double precision,
                         RadialTable<S> (*fill)(const TriangleMesh&, const S&, Layer),
                         std::function<double()> entry_bound) {
  const TriangleMesh& mesh = scene.surface();
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
        fill(mesh, S::with_precision(precision), RaceScene::kLayer));
  };
  maker.bound = [&mesh, precision, entry_bound = std::move(entry_bound)](const RadiusMethod& /*method*/) {
    if (!star_shape(mesh).star_shaped) return MethodBound{};
    MethodBound bound = table_method_bound(mesh, radii<S>(mesh, precision), RaceScene::kLayer);
    bound.bound_mm += entry_bound();
    bound.attained_mm = MethodBound{}.attained_mm;  // by an exact filling, not by this one
    return bound;
  };
  return maker;
}

}  // namespace

std::vector<MethodMaker> table_methods(const RaceScene& scene, const std::vector<double>& precisions) {
  std::vector<MethodMaker> makers;
  for_each_scheme([&]<class S>() {
    for (const double precision : precisions) {
      if (has_precision<S>(precision)) add_scheme<S>(makers, scene, precision);
    }
  });
  return makers;
}

std::vector<MethodMaker> thesis_methods(const RaceScene& scene, const std::vector<double>& precisions) {
  std::vector<MethodMaker> makers;
  const TriangleMesh& mesh = scene.surface();
  for (const double precision : precisions) {
    makers.push_back(
        thesis_maker<Rsid>(scene, precision, fill_thesis, [&mesh] { return thesis_raster_bound(mesh); }));
    makers.push_back(thesis_maker<Usid>(scene, precision, fill_resampled<Usid>,
                                        [&mesh, precision] { return resampling_bound(mesh, precision); }));
  }
  return makers;
}

}  // namespace impinge
