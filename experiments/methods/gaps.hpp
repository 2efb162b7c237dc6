// SPDX-License-Identifier: GPL-3.0-or-later
// The gap at every vertex of one surface in a pose.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "gap/simd/packed_vertices.hpp"
#include "gap/surface.hpp"
#include "methods/points.hpp"

namespace impinge::lab {

/// Test points, in the forms that the methods need.
struct AskedPoints {
  explicit AskedPoints(std::vector<Vec3> asked);  // rounds them to float as well

  std::vector<Vec3> points;        // mm, in the frame of their own mesh
  PackedVertices<float> floats;    // the same points
  PackedVertices<double> doubles;  // the same points
};

/// The surface to measure against, and whose vertices are measured. The mesh must outlive the methods.
struct AskedSurface {
  const TriangleMesh& mesh;  // centre frame
  Layer layer;               // layer of the mesh that counts
  Surface scanned;           // whose vertices are measured
};

/// Memory of one thread for moved points and answers. It grows at first use.
struct GapScratch {
  std::vector<Vec3> moved;      // mm, in the frame of the surface
  std::vector<double> doubles;  // answers of methods that work in double, mm
  std::vector<float> floats;    // answers of methods that work in float, mm

  double gap(std::size_t i) const;  // answer i, mm; NaN where there is none
};

/// A method that is ready to answer. Several threads may call it, each with its own scratch.
struct GapQuery {
  /// Finds the gap of every point with the ball in a pose; this is timed.
  std::function<void(const AskedPoints&, const Pose&, GapScratch&)> scan;
  double bytes = 0.0;                 // memory of everything that was built
  Measure measure = Measure::radial;  // what the answers are
  bool answers = true;                // do the answers mean anything?
};

/// Moves the points to the frame of the surface and asks there. Radii become gaps; distances have no sign.
GapQuery gaps_by_points(PointQuery query, Measure measure, Surface scanned);

/// One setting of a method, and how it is prepared.
struct GapCase : Case {
  std::string storage = "none";    // double, float, uint16 or none
  bool kernel = false;             // does its time depend on the instruction set?
  bool few = false;                // so slow that only some of the points are tested
  bool maskless = false;           // does it answer beyond the rim on purpose?
  bool widely = false;             // also timed with two threads and with every instruction set
  std::function<GapQuery()> make;  // builds the table or tree
  /// Proven bound on its radii, mm, at points as far from the centre as the surface; empty if there is none.
  std::function<double()> bound = {};
};

/// A case that answers point by point. `few` is set until the caller knows that it is fast.
GapCase point_gaps(const AskedSurface& surface, const PointCase& of);

/// Tables that answer point by point, in double.
std::vector<GapCase> table_gaps(const AskedSurface& surface, const std::vector<PointCase>& tables);

/// Cells along an edge of a cube map. It takes just less than 1 MiB with 16 bits per entry, and less than
/// half of RSID in double at half a degree.
inline constexpr std::size_t kMainCells = 291;

/// The sizes at which methods are tried.
struct GapSizes {
  std::vector<std::size_t> cube_cells;  // of cube maps: cells along an edge of the cube
  std::vector<double> stored_degrees;   // precisions of RSID in every storage, and for the scalar scan
  std::vector<double> degrees = {};     // precisions of all lines of the work-precision diagram
  TableBenchmark bounds = {};           // how tightly tables are bounded; its precisions are ignored

  TableBenchmark of_lines() const {
    TableBenchmark lines = bounds;
    lines.precisions = degrees;
    return lines;
  }
};

/// A number as text without trailing zeros.
std::string trimmed(double value);

}  // namespace impinge::lab
