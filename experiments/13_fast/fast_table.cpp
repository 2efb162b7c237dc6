// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_fast/fast_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace impinge::lab {
namespace {

constexpr double kNanoseconds = 1e6;  // in a millisecond

std::string text_of(const std::vector<Cell>& key, std::size_t i) { return key[i].text(); }

// Triangles, direction and state.
std::string scene_of(const std::vector<Cell>& key) {
  return text_of(key, 3) + text_of(key, 4) + text_of(key, 7);
}

// Fastest Embree variant on the same surface, ms a vertex.
std::map<std::string, double> fastest_rays(const TimingRun& run) {
  std::map<std::string, double> fastest;
  for (const Timing& timing : run.timings) {
    if (!text_of(timing.key, 0).starts_with("embree_ray")) continue;
    double& best = fastest.try_emplace(scene_of(timing.key), HUGE_VAL).first->second;
    best = std::min(best, timing.summary.median);
  }
  return fastest;
}

}  // namespace

std::vector<Column> fast_keys() {
  return {{"method", "",
           "embree_rayN: N rays at a time; floor: the least a look-up does; rsid_scalar, usid_scalar: the "
           "library in double; cgal_, embree_closest: trees; vtk_: buckets; vdb_grid: distances on voxels; "
           "others: kernels of that scheme"},
          {"setting", "",
           "cells along an edge of the cube (n=) or for a face, degrees of the grid, or Embree's quality, or "
           "OpenVDB's voxels"},
          {"storage", "", "double, float, uint16, corners (15 bits, the corners of a cell together) or none"},
          {"triangles", "1", "of each of the two models"},
          {"direction", "", "whose vertices are looked up -> in whose surface"},
          {"instruction_set", "", "of a kernel, in Highway's names; none: as compiled"},
          {"threads", "1", "that ask at the same time"},
          {"state", "",
           "warm: pose after pose; cold: after a block larger than all caches was overwritten, each pose "
           "timed alone"}};
}

Table fast_table(const std::vector<FastCase>& cases, const TimingRun& run) {
  Table table{fast_keys(), {}};
  const std::vector<Column> more{
      {"ns_vertex", "ns",
       "median time of one vertex, its share of the pose included; of all threads together"},
      {"iqr_ns", "ns", "interquartile range of it over the rounds"},
      {"rounds", "1", "rounds measured"},
      {"measure", "", "radial gaps, or Euclidean distances, whose errors are those of distances"},
      {"error_um", "um", "largest error of a gap against the exact mesh over the probes; none for the floor"},
      {"misses", "1",
       "probes without an answer where there is a surface: cells of the rim, or too far for the voxels"},
      {"false_hits", "1", "probes with an answer where there is no surface"},
      {"undecided", "1", "probes that a certified table has sent to its exact cells"},
      {"probes", "1", "directions in which errors were measured"},
      {"bytes", "B", "of table and mask, or of Embree's tree"},
      {"times_embree", "1", "median of the fastest Embree variant over this one"}};
  table.columns.insert(table.columns.end(), more.begin(), more.end());
  const auto fastest = fastest_rays(run);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Timing& timing = run.timings[i];
    const FastErrors& errors = cases[i].errors;
    std::vector<Cell> row = timing.key;
    const double rays = fastest.at(scene_of(timing.key));
    row.insert(row.end(),
               {kNanoseconds * timing.summary.median, kNanoseconds * timing.summary.iqr, timing.summary.count,
                name_of(cases[i].measure), 1e3 * errors.largest_mm, errors.misses, errors.false_hits,
                errors.undecided, errors.probes, cases[i].bytes, rays / timing.summary.median});
    table.add_row(std::move(row));
  }
  return table;
}

}  // namespace impinge::lab
