// SPDX-License-Identifier: GPL-3.0-or-later
// One type for the table of a surface, whatever its scheme and storage, and for the bounds on its error.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gap/pose.hpp"
#include "gap/simd/packed_vertices.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sphere/stored_values.hpp"
#include "table/layer.hpp"

namespace impinge {

/// How a table is made.
struct TableSettings {
  std::string scheme = "cube_gnomonic";     // its name
  double precision_deg = 0.35;              // of the scheme
  Storage storage = Storage::sixteen_bits;  // of the numbers
  bool flat_cube = true;                    // does `cube_gnomonic` interpolate inverse depths (`mesh_exact`)?
  /// Largest number of halvings in the search for the bound of the whole table. Enough for a hip made from
  /// parameters. For a whole bone, part of which is seen edge-on from the centre, a full search takes
  /// minutes; bounds of single cells do not need it.
  std::size_t halvings = 20'000;
};

/// Vertices to scan: in double for look-ups one by one, and packed in float for the kernels.
struct ScannedVertices {
  explicit ScannedVertices(std::span<const Vec3> vertices)
      : points(vertices.begin(), vertices.end()), packed(packed_vertices<float>(vertices)) {}

  std::vector<Vec3> points;      // mm
  PackedVertices<float> packed;  // the same
};

/// Proven bounds on the error of one table, which need not outlive them.
class SurfaceBounds {
 public:
  SurfaceBounds() = default;
  SurfaceBounds(const SurfaceBounds&) = delete;
  SurfaceBounds& operator=(const SurfaceBounds&) = delete;
  virtual ~SurfaceBounds() = default;

  /// Bound on the error of the table's radius along x (frame of the table), mm: interpolation
  /// (table/direction_bounds.hpp) plus storage (sphere/stored_table.hpp). Not included are the kernels' own
  /// roundings, below a micrometre (gap/simd/gap_kernels.hpp). NaN where the table has no radius, infinite
  /// where nothing is proven.
  virtual double at(const Vec3& x) const = 0;

  /// The same over all directions.
  virtual double everywhere() const = 0;
};

/// The filled table of a surface.
class SurfaceTable {
 public:
  SurfaceTable() = default;
  SurfaceTable(const SurfaceTable&) = delete;
  SurfaceTable& operator=(const SurfaceTable&) = delete;
  virtual ~SurfaceTable() = default;

  /// Gaps of the vertices of the other surface, mm, NaN where this one is not met; `gap` has their size.
  virtual void scan(const ScannedVertices& vertices, const Pose& pose, Surface scanned,
                    std::span<double> gap) = 0;
  virtual std::size_t bytes() const = 0;    // of memory
  virtual std::size_t entries() const = 0;  // of the scheme

  /// The bounds of this table; the arguments are those that fill_table() made it with. May take some seconds.
  virtual std::unique_ptr<SurfaceBounds> bounds(const TableSettings& settings, const TriangleMesh& mesh,
                                                Layer layer) const = 0;
};

/// Fills the table of a mesh in the centre frame. In float and 16 bits, `cube_gnomonic` with flat_cube and
/// `rsid` are scanned by the kernels (gap/simd/gap_kernels.hpp), all others vertex by vertex.
/// std::invalid_argument for an unknown scheme or an impossible precision.
std::unique_ptr<SurfaceTable> fill_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer);

/// Where the entries of that table meet the surface: x, y, z of each in turn (centre frame, mm).
std::vector<float> sample_points(const TableSettings& settings, const TriangleMesh& mesh, Layer layer);

}  // namespace impinge
