// SPDX-License-Identifier: GPL-3.0-or-later
// The table of one surface, whatever its scheme and storage, behind one type, and what is proven about it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gap/pose.hpp"
#include "gap/simd/packed_vertices.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"
#include "table/partial_table.hpp"

namespace impinge {

/// What a table is made with.
struct TableSettings {
  std::string scheme = "cube_gnomonic";     // its name
  double precision_deg = 0.35;              // of the scheme
  Storage storage = Storage::sixteen_bits;  // of the numbers
  bool flat_cube = true;                    // does `cube_gnomonic` interpolate inverse depths (`mesh_exact`)?
  /// Of the search for the bound of the whole table, the most. Enough for a hip made from parameters: of a
  /// whole bone, part of which is seen edge-on from the centre, the search takes minutes, and its cells are
  /// bounded without it.
  std::size_t halvings = 20'000;
};

/// Vertices that are scanned: in double for look-ups one by one, and as the kernels read them.
struct ScannedVertices {
  explicit ScannedVertices(std::span<const Vec3> vertices)
      : points(vertices.begin(), vertices.end()), packed(packed_vertices<float>(vertices)) {}

  std::vector<Vec3> points;      // mm
  PackedVertices<float> packed;  // the same
};

/// What is proven about one table. Keeps what it needs of it.
class SurfaceBounds {
 public:
  SurfaceBounds() = default;
  SurfaceBounds(const SurfaceBounds&) = delete;
  SurfaceBounds& operator=(const SurfaceBounds&) = delete;
  virtual ~SurfaceBounds() = default;

  /// On the error of an answer along x, in the frame of the table, mm: of the interpolation there
  /// (table/direction_bounds.hpp) and of the storage (sphere/stored_table.hpp). The kernels' own
  /// roundings, below a micrometre, come on top (gap/simd/gap_kernels.hpp). NaN where there is no answer,
  /// infinite where nothing is proven.
  virtual double at(const Vec3& x) const = 0;

  /// The same over all directions.
  virtual double everywhere() const = 0;
};

/// All entries of a scheme.
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

  /// Of the table that fill_table() makes of these. May take some seconds.
  virtual std::unique_ptr<SurfaceBounds> bounds(const TableSettings& settings, const TriangleMesh& mesh,
                                                Layer layer) const = 0;
};

/// `cube_gnomonic` with flat_cube and `rsid` in float and 16 bits are scanned by the kernels
/// (gap/simd/gap_kernels.hpp), all else vertex by vertex. std::invalid_argument for a scheme or a precision
/// that there is not. mesh in the centre frame.
std::unique_ptr<SurfaceTable> fill_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer);

/// Where the entries of that table meet the surface: x, y, z of each in turn (centre frame, mm).
std::vector<float> sample_points(const TableSettings& settings, const TriangleMesh& mesh, Layer layer);

}  // namespace impinge
