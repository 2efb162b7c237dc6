// SPDX-License-Identifier: GPL-3.0-or-later
// How far the surface of a scene is, point by point: tables, rays, closest points and distance
// grids.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "methods/benchmark_scene.hpp"
#include "methods/method.hpp"
#include "table/table_bound.hpp"

namespace impinge::lab {

/// What a table keeps, entry by entry, in the order of its scheme.
struct StoredRadii {
  std::vector<Vec3> directions;  // unit
  std::vector<double> radii;     // mm, NaN where there is no surface
  double reach = 0.0;            // largest angle from a direction to an entry that its look-up reads, radians
};

/// A method that is built for a surface and ready to ask.
struct PointQuery {
  /// One answer for each point; NaN where there is no surface. Points in the socket's frame, mm, not at the
  /// centre.
  std::function<void(std::span<const Vec3>, std::span<double>)> answer;
  double bytes = 0.0;                        // of everything that was built; NaN where it cannot be known
  double storage_bound = 0.0;                // bound on the error added by storing fewer bytes a number, mm
  std::function<StoredRadii()> stored = {};  // every entry, of a table
};

/// A query that answers one point after the other.
template <class Answer>
PointQuery one_by_one(Answer answer, double bytes) {
  return {[answer = std::move(answer)](std::span<const Vec3> points, std::span<double> out) {
            for (std::size_t i = 0; i < points.size(); ++i) out[i] = answer(points[i]);
          },
          bytes};
}

/// What is proven of a method's error, mm; NaN where nothing is.
struct MethodBound {
  double bound_mm = std::numeric_limits<double>::quiet_NaN();     // no answer is off by more
  double attained_mm = std::numeric_limits<double>::quiet_NaN();  // largest error that the proof met
};

/// One setting, and how it comes to be.
struct PointCase : Case {
  std::string kind = "library";                                     // ours, thesis, library, grid or brute
  std::string scheme = {};                                          // of a table
  double precision_deg = std::numeric_limits<double>::quiet_NaN();  // of a table
  std::string interpolant = "none";                                 // smooth, mesh_exact or none
  std::string storage = "none";                                     // double, float, uint16 or none
  Measure measure = Measure::radial;                                // what the answers are
  std::string stability = {};  // its name in the stability experiment; empty: it is not in that
  bool in_float = false;       // is its rounding that of float?
  /// Everything that is done once for a surface. The scene outlives both.
  std::function<PointQuery()> make = {};
  /// The proven bound; empty if nothing is proven, apart from rounding.
  std::function<MethodBound(const PointQuery&)> bound = {};
};

/// Which tables are made, and how tightly they are bounded.
struct TableBenchmark {
  std::vector<double> precisions;  // degrees
  // Tables of at most this many entries, of surfaces of at most most_faces, are bounded by branch and bound
  // (table/table_bound.hpp). Other tables of radii get the first-order bound, which costs little and is
  // loose; other tables of inverse depths get none.
  std::size_t most_entries = 0;
  std::size_t most_faces = 0;  // see most_entries
  BoundOptions search = {};    // of branch and bound
};

/// At which sizes methods are tried.
struct PointSizes {
  TableBenchmark tables = {};                // of every scheme
  std::vector<std::size_t> grid_nodes = {};  // of distance grids, a side
};

/// A case of a library.
inline PointCase library_case(std::string name, std::string label, Measure measure,
                              std::function<PointQuery()> make) {
  PointCase one;
  one.name = std::move(name);
  one.label = std::move(label);
  one.measure = measure;
  one.make = std::move(make);
  return one;
}

}  // namespace impinge::lab
