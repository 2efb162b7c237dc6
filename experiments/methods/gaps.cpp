// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/gaps.hpp"

#include <utility>

namespace impinge::lab {

AskedPoints::AskedPoints(std::vector<Vec3> asked)
    : points(std::move(asked)),
      floats(packed_vertices<float>(points)),
      doubles(packed_vertices<double>(points)) {}

double GapScratch::gap(std::size_t i) const {
  return doubles.empty() ? static_cast<double>(floats[i]) : doubles[i];
}

GapQuery gaps_by_points(PointQuery query, Measure measure, Surface scanned) {
  const double bytes = query.bytes;
  const auto scan = [query = std::move(query), measure, scanned](const AskedPoints& asked, const Pose& pose,
                                                                 GapScratch& scratch) {
    const std::size_t count = asked.points.size();
    scratch.moved.resize(count);
    scratch.doubles.resize(count);
    for (std::size_t i = 0; i < count; ++i) scratch.moved[i] = to_other(scanned, pose, asked.points[i]);
    query.answer(scratch.moved, scratch.doubles);
    if (measure == Measure::euclidean) return;
    for (std::size_t i = 0; i < count; ++i)
      scratch.doubles[i] = signed_gap(scanned, scratch.doubles[i], scratch.moved[i].norm());
  };
  return {scan, bytes, measure};
}

GapCase point_gaps(const AskedSurface& surface, const PointCase& of) {
  GapCase one;
  one.name = of.name;
  one.label = of.label + (of.measure == Measure::euclidean ? " (Euclidean)" : "");
  one.setting = of.setting;
  one.place = of.place;
  one.few = true;
  one.make = [make = of.make, measure = of.measure, scanned = surface.scanned] {
    return gaps_by_points(make(), measure, scanned);
  };
  return one;
}

std::vector<GapCase> table_gaps(const AskedSurface& surface, const std::vector<PointCase>& tables) {
  std::vector<GapCase> cases;
  for (const PointCase& table : tables) {
    cases.push_back(point_gaps(surface, table));
    cases.back().storage = "double";
    cases.back().few = false;
    if (table.bound) cases.back().bound = [bound = table.bound] { return bound({}).bound_mm; };
  }
  return cases;
}

std::string trimmed(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace impinge::lab
