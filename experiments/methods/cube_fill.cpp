// SPDX-License-Identifier: GPL-3.0-or-later
// @can     fill
// @links   gap table_fill
//
// Methods cube_at_once: a cube map drawn and stored at once; cube_in_double: the rasteriser of all schemes,
// in double.

#include "table/fill/cube_fill.hpp"

#include <concepts>
#include <memory>
#include <optional>
#include <utility>

#include "methods/fill.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

constexpr double kReach = 64.0;       // mm, beyond every corner of the pair
constexpr double kFloatShare = 1e-5;  // of a radius, far above what float takes

template <class Value>
TableFilling at_once(const FilledSurface& surface, int threads) {
  const auto table = std::make_shared<PackedTable<CubeGnomonic, Value>>();
  const CubeFill how{surface.scheme, surface.layer, threads};
  return {[table, how, &mesh = surface.mesh] { fill_cube(mesh, how, *table); }, [table] { *table = {}; },
          [table, scheme = surface.scheme](std::size_t entry) {
            const double q = table->smallest + table->step * static_cast<double>(table->values[entry]);
            return 1.0 / (q * scheme.depth(scheme.direction(entry)));
          },
          [table] {  // dr = r^2 depth dq, depth <= 1
            return kFloatShare * kReach +
                   (std::same_as<Value, std::uint16_t> ? kReach * kReach * table->step : 0.0);
          }};
}

TableFilling in_double(const FilledSurface& surface, int /*threads*/) {
  const auto table = std::make_shared<std::optional<RadialTable<CubeGnomonic>>>();
  return {[table, surface] { table->emplace(fill_exact(surface.mesh, surface.scheme, surface.layer)); },
          [table] { table->reset(); }, [table](std::size_t entry) { return (*table)->radius_of(entry); },
          [] { return 0.0; }};
}

FillCase fill_case(const char* name, const char* label, const char* storage, int threads,
                   decltype(FillCase::make) make) {
  FillCase one;
  static_cast<Case&>(one) = {name, label, "", 0};
  one.storage = storage;
  one.threads = threads;
  one.make = std::move(make);
  return one;
}

}  // namespace

Method cube_fill_method() {
  Method method;
  method.fill = [] {
    return std::vector{fill_case("cube_at_once", "at once", "uint16", 1, at_once<std::uint16_t>),
                       fill_case("cube_at_once", "at once", "uint16", 2, at_once<std::uint16_t>),
                       fill_case("cube_at_once", "at once", "float", 1, at_once<float>),
                       fill_case("cube_in_double", "entry by entry, double", "double", 1, in_double)};
  };
  return method;
}

}  // namespace impinge::lab
