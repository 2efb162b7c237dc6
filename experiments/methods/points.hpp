// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that give the distance to a scene's surface, point by point: tables, rays, closest points, grids.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "methods/benchmark_scene.hpp"
#include "methods/method.hpp"
#include "table/table_bound.hpp"

namespace impinge::lab {

/// The entries of a table, in the order of its scheme.
struct StoredRadii {
  std::vector<Vec3> directions;  // unit
  std::vector<double> radii;     // mm, NaN where there is no surface
  double reach = 0.0;            // largest angle from a direction to an entry that its look-up reads, radians
};

/// A method that is ready to answer for a surface.
struct PointQuery {
  /// Gives one answer per point; NaN where there is no surface. Points are in the socket's frame, mm, and not
  /// at the centre.
  std::function<void(std::span<const Vec3>, std::span<double>)> answer;
  double bytes = 0.0;                        // memory of everything that was built; NaN if it cannot be known
  double storage_bound = 0.0;                // bound on the error added by storing fewer bytes per number, mm
  std::function<StoredRadii()> stored = {};  // every entry, for a table
};

/// A query that answers the points one by one.
template <class Answer>
PointQuery one_by_one(Answer answer, double bytes) {
  return {[answer = std::move(answer)](std::span<const Vec3> points, std::span<double> out) {
            for (std::size_t i = 0; i < points.size(); ++i) out[i] = answer(points[i]);
          },
          bytes};
}

/// The proven error of a method, mm; NaN if nothing is proven.
struct MethodBound {
  double bound_mm = std::numeric_limits<double>::quiet_NaN();     // no answer is off by more
  double attained_mm = std::numeric_limits<double>::quiet_NaN();  // largest error that the proof encountered
};

/// One setting of a method, and how it is prepared.
struct PointCase : Case {
  std::string kind = "library";                                     // ours, thesis, library, grid or brute
  std::string scheme = {};                                          // for a table
  double precision_deg = std::numeric_limits<double>::quiet_NaN();  // for a table
  std::string interpolant = "none";                                 // smooth, mesh_exact or none
  std::string storage = "none";                                     // double, float, uint16 or none
  Measure measure = Measure::radial;                                // what the answers are
  std::string stability = {};  // its name in the stability experiment; empty: it takes no part
  bool in_float = false;       // does it round as float does?
  /// Does everything that is done once for a surface. The scene must outlive case and query.
  std::function<PointQuery()> make = {};
  /// The proven bound, apart from rounding; empty if nothing is proven.
  std::function<MethodBound(const PointQuery&)> bound = {};
};

/// The tables that are made, and how tightly they are bounded.
struct TableBenchmark {
  std::vector<double> precisions;  // degrees
  // Tables with at most this many entries, of surfaces with at most most_faces, are bounded by branch and
  // bound (table/table_bound.hpp). Other tables of radii get the first-order bound, which is cheap and loose;
  // other tables of inverse depths get none.
  std::size_t most_entries = 0;
  std::size_t most_faces = 0;  // see most_entries
  BoundOptions search = {};    // of branch and bound
};

/// The sizes at which methods are tried.
struct PointSizes {
  TableBenchmark tables = {};                // for every scheme
  std::vector<std::size_t> grid_nodes = {};  // nodes per side of distance grids
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
