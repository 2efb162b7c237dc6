// SPDX-License-Identifier: GPL-3.0-or-later
// @can     gaps
// @links   gap gap_simd gap_queries memory_floor
//
// The library's scans: kernels with vector instructions on tables of several kinds and storages, the scalar
// scan in double, and the least work of a look-up.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <utility>

#include "gap/gap_scan.hpp"
#include "gap/simd/exact_cells.hpp"
#include "methods/floor_scan.hpp"
#include "methods/gaps.hpp"
#include "methods/kernel_bound.hpp"
#include "methods/table_query.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

// The floor's tables are as large as such cubes in 16 bits, or as kMainCells in float.
constexpr std::array<std::size_t, 2> kFloorCells{kMainCells, 412};
constexpr double kReach = 64.0;  // mm, beyond every vertex of the pair

struct Kind {
  std::string name;
  std::string label;
};
const Kind kCube{"cube_gnomonic_mesh_exact", "cube kernel"};

GapCase kernel_case(const Kind& kind, std::string setting, std::string storage,
                    std::function<GapQuery()> make) {
  GapCase one;
  static_cast<Case&>(one) = {kind.name, kind.label, std::move(setting), 20};
  one.storage = std::move(storage);
  one.kernel = true;
  one.widely = one.storage != "float" && one.setting == "n=" + std::to_string(kMainCells);
  one.make = std::move(make);
  return one;
}

template <class Table>
GapQuery kernel(Table filled, Surface scanned) {
  const auto table = std::make_shared<const Table>(std::move(filled));
  return {[table, scanned](const AskedPoints& asked, const Pose& pose, GapScratch& scratch) {
            if constexpr (std::same_as<typename Table::Real, float>) {
              scratch.floats.resize(asked.points.size());
              scan_gaps(*table, asked.floats, pose, scanned, scratch.floats);
            } else {
              scratch.doubles.resize(asked.points.size());
              scan_gaps(*table, asked.doubles, pose, scanned, scratch.doubles);
            }
          },
          static_cast<double>(table->bytes())};
}

std::string cells_text(std::size_t cells) { return "n=" + std::to_string(cells); }

CubeGnomonic cube_of(std::size_t cells) {
  return CubeGnomonic::with_precision(90.0 / static_cast<double>(cells));
}

RadialTable<CubeGnomonic> filled_cube(const AskedSurface& s, std::size_t cells) {
  return fill_exact(s.mesh, cube_of(cells), s.layer);
}

// Its answers mean nothing.
GapCase floor_case(std::size_t cells) {
  return kernel_case({"floor", "memory-bound baseline"}, cells_text(cells), "uint16", [cells] {
    const auto table = std::make_shared<const FloorTable>(2 * cube_of(cells).size(), kReach);
    const auto scan = [table](const AskedPoints& asked, const Pose& pose, GapScratch& scratch) {
      scratch.floats.resize(asked.points.size());
      floor_scan(*table, asked.floats, pose, Surface::ball, scratch.floats);
    };
    return GapQuery{scan, static_cast<double>(sizeof(float) * table->values.size()), Measure::radial,
                    /*answers=*/false};
  });
}

KernelReach reach_of(const TriangleMesh& mesh) {
  double radius = 0.0;
  for (const Vec3& v : mesh.vertices) radius = std::max(radius, v.norm());
  return {radius, std::max(radius, kReach)};
}

// Bound u (18 r + 8 |gap|) of exact_cells.hpp; it does not hold for steeper faces.
constexpr double kSteepest = 1e8;

GapCase exact_case(const AskedSurface& s, int cells) {
  GapCase one = kernel_case({"cube_cells_exact", "exact cells"}, std::to_string(cells) + "/face", "float",
                            [s, cells] { return kernel(exact_cells(s.mesh, s.layer, cells), s.scanned); });
  one.bound = [s] {
    const bool steep = std::ranges::any_of(s.mesh.faces, [&](const Face& face) {
      const TriangleCone cone = cone_of(s.mesh, face);
      return !cone.edge_on() && cone.largest_slope() > kSteepest;
    });
    const KernelReach reach = reach_of(s.mesh);
    return steep ? MethodBound{}.bound_mm : 0x1p-24 * (26.0 * reach.radius + 8.0 * reach.point);
  };
  return one;
}

// A kernel on a table, with the proven bound of both.
template <class Value, SamplingScheme S>
GapCase bounded_case(const AskedSurface& s, const GapSizes& sizes, const Kind& kind, std::string setting,
                     const S& scheme) {
  const auto filled = [s, scheme] { return fill_exact(s.mesh, scheme, s.layer); };
  const char* const storage = std::same_as<Value, double>  ? "double"
                              : std::same_as<Value, float> ? FloatValues::name.data()
                                                           : Uint16Values::name.data();
  GapCase one = kernel_case(kind, std::move(setting), storage,
                            [=] { return kernel(packed_table<Value>(filled()), s.scanned); });
  one.bound = [s, scheme, filled, bounds = sizes.bounds] {
    const RadialTable<S> table = filled();
    double bound = 0.0;
    if constexpr (std::same_as<S, CubeGnomonic>)
      bound = bound_of(s.mesh, s.layer, InverseDepthTable<S>(table), bounds).bound_mm;
    else
      bound = bound_of(s.mesh, s.layer, table, bounds).bound_mm;
    return bound + kernel_doubt(packed_table<Value>(table), 90.0 / scheme.precision_deg(), reach_of(s.mesh));
  };
  return one;
}

// Without the mask of its rim, to show what the mask costs and what goes wrong without it.
GapCase maskless_case(const AskedSurface& s, std::size_t cells) {
  const auto make = [s, cells] {
    auto table = packed_table<std::uint16_t>(filled_cube(s, cells));
    table.none.clear();
    return kernel(std::move(table), s.scanned);
  };
  GapCase one = kernel_case({"cube_no_mask", "cube kernel without mask"}, cells_text(cells), "uint16", make);
  one.maskless = true;
  return one;
}

void add_cubes(const AskedSurface& s, const GapSizes& sizes, std::vector<GapCase>& cases) {
  for (const std::size_t cells : sizes.cube_cells) {
    cases.push_back(bounded_case<std::uint16_t>(s, sizes, kCube, cells_text(cells), cube_of(cells)));
    cases.push_back(bounded_case<float>(s, sizes, kCube, cells_text(cells), cube_of(cells)));
  }
  for (const double precision : sizes.degrees) {
    const auto cells = static_cast<std::size_t>(std::round(90.0 / precision));
    if (std::ranges::find(sizes.cube_cells, cells) == sizes.cube_cells.end())
      cases.push_back(bounded_case<std::uint16_t>(s, sizes, kCube, cells_text(cells), cube_of(cells)));
    if (std::ranges::find(sizes.stored_degrees, precision) != sizes.stored_degrees.end())
      cases.push_back(maskless_case(s, cells));
  }
}

// A grid of radii: the library's scan of one vertex at a time, and the kernels.
template <SamplingScheme S>
GapCase scalar_case(const AskedSurface& s, const std::string& label, const S& scheme, std::string setting) {
  const Kind kind{std::string(S::name) + "_scalar", label + ", scalar"};
  GapCase one = kernel_case(kind, std::move(setting), "double", [=] {
    const auto table = std::make_shared<const RadialTable<S>>(fill_exact(s.mesh, scheme, s.layer));
    const auto scan = [table, scanned = s.scanned](const AskedPoints& asked, const Pose& pose,
                                                   GapScratch& scratch) {
      scratch.doubles.resize(asked.points.size());
      scan_gaps(*table, asked.points, pose, scanned, scratch.doubles);
    };
    return GapQuery{scan, static_cast<double>(table->bytes())};
  });
  one.kernel = false;
  return one;
}

template <SamplingScheme S>
void add_scheme(const AskedSurface& s, const std::string& label, const GapSizes& sizes,
                std::vector<GapCase>& cases) {
  std::vector<double> all = sizes.degrees;
  for (const double precision : sizes.stored_degrees)
    if (std::ranges::find(all, precision) == all.end()) all.push_back(precision);
  const Kind kind{std::string(S::name), label + " kernel"};
  for (const double precision : all) {
    const S scheme = S::with_precision(precision);
    const std::string setting = trimmed(precision) + "deg";
    cases.push_back(bounded_case<float>(s, sizes, kind, setting, scheme));
    if (std::ranges::find(sizes.stored_degrees, precision) == sizes.stored_degrees.end()) continue;
    cases.push_back(scalar_case(s, label, scheme, setting));
    cases.push_back(bounded_case<double>(s, sizes, kind, setting, scheme));
    cases.push_back(bounded_case<std::uint16_t>(s, sizes, kind, setting, scheme));
  }
}

std::vector<GapCase> kernel_cases(const AskedSurface& surface, const GapSizes& sizes) {
  std::vector<GapCase> cases;
  cases.reserve(kFloorCells.size() + 2);
  for (const std::size_t cells : kFloorCells) cases.push_back(floor_case(cells));
  for (const int cells : {4, 1}) cases.push_back(exact_case(surface, cells));
  add_cubes(surface, sizes, cases);
  add_scheme<Rsid>(surface, "RSID", sizes, cases);
  if (!sizes.degrees.empty()) add_scheme<Usid>(surface, "USID", sizes, cases);
  return cases;
}

}  // namespace

Method kernels_method() {
  Method method;
  method.gaps = kernel_cases;
  return method;
}

}  // namespace impinge::lab
