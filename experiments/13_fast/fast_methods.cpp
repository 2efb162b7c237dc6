// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_fast/fast_methods.hpp"

#include <array>
#include <utility>

#include "13_fast/gap_methods.hpp"
#include "kernels/corner_table.hpp"
#include "kernels/exact_cells.hpp"
#include "methods/cgal_distances.hpp"
#include "methods/embree_closest.hpp"
#include "methods/embree_rays.hpp"
#include "methods/vdb_distances.hpp"
#include "methods/vtk_distances.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

// The floor's tables are as large as those of such cubes in 16 bits, or of kMainCells with corners.
constexpr std::array<std::size_t, 2> kFloorCells{kMainCells, 412};
constexpr double kVoxelReach = 5.0;  // mm

template <class Table>
std::unique_ptr<GapMethod> kernel(Table table, Surface scanned) {
  return std::make_unique<KernelScan<Table>>(std::move(table), scanned);
}

std::string trimmed(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

constexpr const char* kCubeName = "cube_gnomonic_mesh_exact";

RadialTable<CubeGnomonic> filled_cube(const AskedSurface& s, std::size_t cells) {
  const auto scheme = CubeGnomonic::with_precision(90.0 / static_cast<double>(cells));
  return fill_exact(s.mesh, scheme, s.layer);
}

void add_cubes(const AskedSurface& s, std::size_t cells, std::vector<GapMethodMaker>& makers) {
  const auto filled = [s, cells] { return filled_cube(s, cells); };
  const std::string name = kCubeName;
  const std::string setting = "n=" + std::to_string(cells);
  makers.push_back({name, setting, "uint16", true,
                    [=] { return kernel(packed_table<std::uint16_t>(filled()), s.scanned); }});
  makers.push_back(
      {name, setting, "float", true, [=] { return kernel(packed_table<float>(filled()), s.scanned); }});
}

void add_corners(const AskedSurface& s, std::size_t cells, std::vector<GapMethodMaker>& makers) {
  makers.push_back({kCubeName, "n=" + std::to_string(cells), kCorners, true, [=] {
                      return kernel(corner_table(packed_table<float>(filled_cube(s, cells))), s.scanned);
                    }});
}

// A grid of radii: the library's scan and the kernels.
template <SamplingScheme S>
void add_scheme(const AskedSurface& s, double precision, std::vector<GapMethodMaker>& makers) {
  const auto filled = [s, precision] { return fill_exact(s.mesh, S::with_precision(precision), s.layer); };
  const std::string name(S::name);
  const std::string setting = trimmed(precision) + "deg";
  makers.push_back({name + "_scalar", setting, "double", false,
                    [=] { return std::make_unique<ScalarScan<S>>(filled(), s.scanned); }});
  makers.push_back(
      {name, setting, "double", true, [=] { return kernel(packed_table<double>(filled()), s.scanned); }});
  makers.push_back(
      {name, setting, "float", true, [=] { return kernel(packed_table<float>(filled()), s.scanned); }});
  makers.push_back({name, setting, "uint16", true,
                    [=] { return kernel(packed_table<std::uint16_t>(filled()), s.scanned); }});
}

using PeerMaker = std::unique_ptr<RadiusMethod> (*)(const TriangleMesh&);

// Trees and buckets that are asked point by point.
void add_peers(const AskedSurface& s, std::vector<GapMethodMaker>& makers) {
  const auto rays = [&](const char* name, const char* setting, PeerMaker make) {
    makers.push_back({name, setting, "none", false,
                      [s, make] { return std::make_unique<RayScan>(make(s.mesh), s.scanned); }, true});
  };
  const auto closest = [&](const char* name, const char* setting, PeerMaker make) {
    makers.push_back({name, setting, "none", false,
                      [s, make] { return std::make_unique<ClosestScan>(make(s.mesh), s.scanned); }, true});
  };
  rays("cgal_first_hit", "tree", make_cgal_first_hit);
  rays("vtk_first_hit", "buckets", make_vtk_first_hit);
  closest("cgal_closest", "tree", make_cgal_closest);
  closest("vtk_closest", "buckets", make_vtk_closest);
  closest("embree_closest", "robust", make_embree_closest);
}

// Distances of vertices in the joint space and a little beyond, which is what a grid of voxels keeps.
void add_voxels(const AskedSurface& s, double voxel_mm, std::vector<GapMethodMaker>& makers) {
  makers.push_back(
      {"vdb_grid", trimmed(voxel_mm) + "mm", "float", false, [s, voxel_mm] {
         return std::make_unique<ClosestScan>(make_vdb_distances(s.mesh, {voxel_mm, kVoxelReach}), s.scanned);
       }});
}

}  // namespace

AskedPoints::AskedPoints(std::vector<Vec3> asked)
    : points(std::move(asked)),
      floats(packed_vertices<float>(points)),
      doubles(packed_vertices<double>(points)) {}

std::vector<GapMethodMaker> fast_methods(const AskedSurface& surface, const FastSizes& sizes) {
  std::vector<GapMethodMaker> makers;
  for (const int width : {1, 8, 16}) {
    makers.push_back({"embree_ray" + std::to_string(width), "fast", "none", false, [surface, width] {
                        return std::make_unique<RayScan>(
                            make_embree_rays(surface.mesh, {width, EmbreeQuality::fast}), surface.scanned);
                      }});
  }
  for (const std::size_t cells : kFloorCells) {
    makers.push_back({"floor", "n=" + std::to_string(cells), "uint16", true, [cells] {
                        const double precision = 90.0 / static_cast<double>(cells);
                        return std::make_unique<FloorScan>(2 *
                                                           CubeGnomonic::with_precision(precision).size());
                      }});
  }
  for (const int cells : {4, 1}) {
    makers.push_back({"cube_cells_exact", std::to_string(cells) + "/face", "float", true, [surface, cells] {
                        return kernel(exact_cells(surface.mesh, surface.layer, cells), surface.scanned);
                      }});
  }
  if (sizes.certified) {
    makers.push_back({"cube_certified", "n=" + std::to_string(kMainCells), "uint16", true, [surface] {
                        return std::make_unique<CertifiedScan>(
                            certified_table(surface.mesh, surface.layer, kMainCells), surface.scanned);
                      }});
  }
  for (const std::size_t cells : sizes.cube_cells) add_cubes(surface, cells, makers);
  for (const std::size_t cells : sizes.corner_cells) add_corners(surface, cells, makers);
  for (const double precision : sizes.rsid_degrees) add_scheme<Rsid>(surface, precision, makers);
  for (const double precision : sizes.usid_degrees) add_scheme<Usid>(surface, precision, makers);
  for (const double voxel : sizes.voxels_mm) add_voxels(surface, voxel, makers);
  add_peers(surface, makers);
  return makers;
}

}  // namespace impinge::lab
