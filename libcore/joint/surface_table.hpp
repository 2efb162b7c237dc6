// SPDX-License-Identifier: GPL-3.0-or-later
// One type for all tables of a surface, whatever scheme and storage they have, and one for their bounds.
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
  std::string scheme = "cube_gnomonic";     // name of the scheme
  double precision_deg = 0.35;              // precision of the scheme
  Storage storage = Storage::sixteen_bits;  // of the table's numbers
  bool flat_cube = true;                    // does `cube_gnomonic` interpolate inverse depths (`mesh_exact`)?
  /// Largest number of halvings in the search for the bound of the whole table. This is enough for a hip made
  /// from parameters. For a whole bone, part of which is seen edge-on from the centre, a full search takes
  /// minutes; bounds of single cells do not need it.
  std::size_t halvings = 20'000;
};

/// Vertices to scan: in double for single look-ups, and packed in float for the kernels.
struct ScannedVertices {
  explicit ScannedVertices(std::span<const Vec3> vertices)
      : points(vertices.begin(), vertices.end()), packed(packed_vertices<float>(vertices)) {}

  std::vector<Vec3> points;      // mm
  PackedVertices<float> packed;  // the same
};

/// Proven bounds on the error of one table; they stay valid without it.
class SurfaceBounds {
 public:
  SurfaceBounds() = default;
  SurfaceBounds(const SurfaceBounds&) = delete;
  SurfaceBounds& operator=(const SurfaceBounds&) = delete;
  virtual ~SurfaceBounds() = default;

  /// Bound on the error of the table's radius along x (frame of the table), mm: interpolation
  /// (table/direction_bounds.hpp) plus storage (sphere/stored_table.hpp). It leaves out the rounding of the
  /// kernels, below a micrometre (gap/simd/gap_kernels.hpp). NaN where the table has no radius, infinite
  /// where nothing is proven.
  virtual double at(const Vec3& x) const = 0;

  /// The largest bound over all directions, mm.
  virtual double everywhere() const = 0;
};

/// The filled table of a surface.
class SurfaceTable {
 public:
  SurfaceTable() = default;
  SurfaceTable(const SurfaceTable&) = delete;
  SurfaceTable& operator=(const SurfaceTable&) = delete;
  virtual ~SurfaceTable() = default;

  /// Gaps of the vertices of the other surface, mm; NaN where a vertex does not meet this surface. `gap` has
  /// one element for each vertex.
  virtual void scan(const ScannedVertices& vertices, const Pose& pose, Surface scanned,
                    std::span<double> gap) = 0;
  virtual std::size_t bytes() const = 0;    // memory
  virtual std::size_t entries() const = 0;  // of the scheme

  /// The bounds of this table, made with the arguments of fill_table(). May take some seconds.
  virtual std::unique_ptr<SurfaceBounds> bounds(const TableSettings& settings, const TriangleMesh& mesh,
                                                Layer layer) const = 0;
};

/// Fills the table of a mesh in the centre frame. In float and 16 bits, `cube_gnomonic` with flat_cube and
/// `rsid` are scanned by the kernels (gap/simd/gap_kernels.hpp), all others vertex by vertex. Throws
/// std::invalid_argument for an unknown scheme or an impossible precision.
std::unique_ptr<SurfaceTable> fill_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer);

/// The points where the table's entries meet the surface: x, y, z of each in turn (centre frame, mm).
std::vector<float> sample_points(const TableSettings& settings, const TriangleMesh& mesh, Layer layer);

}  // namespace impinge
