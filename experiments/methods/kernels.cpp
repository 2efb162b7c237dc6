// SPDX-License-Identifier: GPL-3.0-or-later
// @can     gaps
// @links   gap gap_simd gap_queries memory_floor
//
// The library's scans: kernels with vector instructions on tables of several kinds and storages, the scalar
// scan in double, and the least that a look-up can do.

#include <array>
#include <concepts>
#include <utility>

#include "gap/gap_scan.hpp"
#include "gap/simd/exact_cells.hpp"
#include "methods/floor_scan.hpp"
#include "methods/gaps.hpp"
#include "methods/table_query.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

// The floor's tables are as large as those of such cubes in 16 bits, or of kMainCells in float.
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

GapCase exact_case(const AskedSurface& s, int cells) {
  return kernel_case({"cube_cells_exact", "exact cells"}, std::to_string(cells) + "/face", "float",
                     [s, cells] { return kernel(exact_cells(s.mesh, s.layer, cells), s.scanned); });
}

void add_cubes(const AskedSurface& s, std::size_t cells, std::vector<GapCase>& cases) {
  const auto filled = [s, cells] { return filled_cube(s, cells); };
  cases.push_back(kernel_case(kCube, cells_text(cells), "uint16",
                              [=] { return kernel(packed_table<std::uint16_t>(filled()), s.scanned); }));
  cases.push_back(kernel_case(kCube, cells_text(cells), "float",
                              [=] { return kernel(packed_table<float>(filled()), s.scanned); }));
}

// A grid of radii: the library's scan, one vertex at a time, and the kernels.
template <SamplingScheme S>
void add_scheme(const AskedSurface& s, const std::string& label, double precision,
                std::vector<GapCase>& cases) {
  const auto filled = [s, precision] { return fill_exact(s.mesh, S::with_precision(precision), s.layer); };
  const std::string name(S::name);
  const std::string setting = trimmed(precision) + "deg";
  const auto add = [&](const Kind& kind, const char* storage, std::function<GapQuery()> make) {
    cases.push_back(kernel_case(kind, setting, storage, std::move(make)));
  };
  add({name + "_scalar", label + ", scalar"}, "double", [=] {
    const auto table = std::make_shared<const RadialTable<S>>(filled());
    const auto scan = [table, scanned = s.scanned](const AskedPoints& asked, const Pose& pose,
                                                   GapScratch& scratch) {
      scratch.doubles.resize(asked.points.size());
      scan_gaps(*table, asked.points, pose, scanned, scratch.doubles);
    };
    return GapQuery{scan, static_cast<double>(table->bytes())};
  });
  cases.back().kernel = false;
  const Kind kind{name, label + " kernel"};
  add(kind, "double", [=] { return kernel(packed_table<double>(filled()), s.scanned); });
  add(kind, "float", [=] { return kernel(packed_table<float>(filled()), s.scanned); });
  add(kind, "uint16", [=] { return kernel(packed_table<std::uint16_t>(filled()), s.scanned); });
}

std::vector<GapCase> kernel_cases(const AskedSurface& surface, const GapSizes& sizes) {
  std::vector<GapCase> cases;
  cases.reserve(kFloorCells.size() + 2);
  for (const std::size_t cells : kFloorCells) cases.push_back(floor_case(cells));
  for (const int cells : {4, 1}) cases.push_back(exact_case(surface, cells));
  for (const std::size_t cells : sizes.cube_cells) add_cubes(surface, cells, cases);
  for (const double precision : sizes.rsid_degrees) add_scheme<Rsid>(surface, "RSID", precision, cases);
  for (const double precision : sizes.usid_degrees) add_scheme<Usid>(surface, "USID", precision, cases);
  return cases;
}

}  // namespace

Method kernels_method() {
  Method method;
  method.gaps = kernel_cases;
  return method;
}

}  // namespace impinge::lab
