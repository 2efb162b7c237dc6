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

/// Points to ask, in the forms that the methods need.
struct AskedPoints {
  explicit AskedPoints(std::vector<Vec3> asked);  // rounds them to float as well

  std::vector<Vec3> points;        // mm, in the frame of the mesh that they are of
  PackedVertices<float> floats;    // the same points
  PackedVertices<double> doubles;  // the same points
};

/// The surface that is asked, and whose vertices ask. The mesh outlives the methods.
struct AskedSurface {
  const TriangleMesh& mesh;  // centre frame
  Layer layer;               // of the mesh that counts
  Surface scanned;           // whose vertices ask
};

/// Memory of one thread: the points as moved, and the answers. It grows on its first use.
struct GapScratch {
  std::vector<Vec3> moved;      // mm, in the frame of the surface
  std::vector<double> doubles;  // answers of methods that work in double, mm
  std::vector<float> floats;    // answers of methods that work in float, mm

  double gap(std::size_t i) const;  // answer i, mm; NaN where there is none
};

/// A method that is built and ready to ask. Threads may ask at the same time, each with its own scratch.
struct GapQuery {
  /// The gap of every point with the ball in that pose; what is timed.
  std::function<void(const AskedPoints&, const Pose&, GapScratch&)> scan;
  double bytes = 0.0;                 // of everything that was built
  Measure measure = Measure::radial;  // what the answers are
  bool answers = true;                // do the answers mean anything?
};

/// The points moved to the frame of the surface and asked there; radii become gaps, distances stay without a
/// sign.
GapQuery gaps_by_points(PointQuery query, Measure measure, Surface scanned);

/// One setting, and how it comes to be.
struct GapCase : Case {
  std::string storage = "none";    // double, float, uint16 or none
  bool kernel = false;             // does its time depend on the instruction set?
  bool few = false;                // so slow that only some of the points are asked
  bool maskless = false;           // does it answer beyond the rim, on purpose?
  bool widely = false;             // also timed with two threads and with every instruction set
  std::function<GapQuery()> make;  // builds the table or tree
  /// What is proven of its radii, mm, at points as far from the centre as the surface; empty if nothing is.
  std::function<double()> bound = {};
};

/// A case that is asked point by point; few of them, until the caller knows that it is fast.
GapCase point_gaps(const AskedSurface& surface, const PointCase& of);

/// Tables that are asked point by point, in double.
std::vector<GapCase> table_gaps(const AskedSurface& surface, const std::vector<PointCase>& tables);

/// Cells along an edge of a cube map that takes just less than 1 MiB with 16 bits an entry, and less than
/// half of what RSID takes in double at half a degree.
inline constexpr std::size_t kMainCells = 291;

/// At which sizes methods are tried.
struct GapSizes {
  std::vector<std::size_t> cube_cells;  // of cube maps: cells along an edge of the cube
  std::vector<double> stored_degrees;   // precisions of RSID in every storage, and by the scalar scan
  std::vector<double> degrees = {};     // precisions of every line of the work-precision diagram
  TableBenchmark bounds = {};           // how tightly tables are bounded; its precisions are not read

  TableBenchmark of_lines() const {
    TableBenchmark lines = bounds;
    lines.precisions = degrees;
    return lines;
  }
};

/// A number as text without trailing zeros.
std::string trimmed(double value);

}  // namespace impinge::lab
