// SPDX-License-Identifier: GPL-3.0-or-later
// The table of one surface, whatever its scheme and storage, behind one type.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gap/pose.hpp"
#include "kernels/packed_vertices.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"
#include "table/partial_table.hpp"

namespace impinge {

struct TableSettings {
  std::string scheme = "cube_gnomonic";
  double precision_deg = 0.35;
  Storage storage = Storage::sixteen_bits;
};

// Vertices that are scanned: in double for look-ups one by one, and as the kernels read them.
struct ScannedVertices {
  explicit ScannedVertices(std::span<const Vec3> vertices)
      : points(vertices.begin(), vertices.end()), lanes(packed_vertices<float>(vertices)) {}

  std::vector<Vec3> points;
  PackedVertices<float> lanes;
};

class SurfaceTable {
 public:
  SurfaceTable() = default;
  SurfaceTable(const SurfaceTable&) = delete;
  SurfaceTable& operator=(const SurfaceTable&) = delete;
  virtual ~SurfaceTable() = default;

  // Gaps of the vertices of the other surface, mm, NaN where this one is not met; `gap` has their size.
  virtual void scan(const ScannedVertices& vertices, const Pose& pose, Surface scanned,
                    std::span<double> gap) = 0;
  virtual std::size_t bytes() const = 0;

  std::size_t entries = 0;
};

// `cube_gnomonic` and `rsid` in float and 16 bits are scanned by the kernels (kernels/gap_kernels.hpp), all
// else vertex by vertex; `cube_gnomonic` interpolates inverse depths (`mesh_exact`), the others radii.
// std::invalid_argument for a scheme or a precision that there is not. mesh in the centre frame.
std::unique_ptr<SurfaceTable> fill_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer);

// Where the entries of that table meet the surface: x, y, z of each in turn (centre frame, mm).
std::vector<float> sample_points(const TableSettings& settings, const TriangleMesh& mesh, Layer layer);

}  // namespace impinge
