// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of radii along a ray from the centre, or along all rays of a cap.
#pragma once

#include <algorithm>
#include <vector>

#include "table/face_cap.hpp"

namespace impinge {

/// Closed spans of radii, mm, in rising order and disjoint.
class RaySpans {
 public:
  /// Adds [from, to], mm; nothing if from > to.
  void add(double from, double to) {
    if (!(from <= to)) return;
    const auto first = std::ranges::find_if(spans_, [&](const RadiusRange& s) { return s.high >= from; });
    auto last = first;
    for (; last != spans_.end() && last->low <= to; ++last) {
      from = std::min(from, last->low);
      to = std::max(to, last->high);
    }
    spans_.insert(spans_.erase(first, last), RadiusRange{from, to});
  }

  const std::vector<RadiusRange>& spans() const { return spans_; }  // mm
  /// Does the set hold all of [from, to]?
  bool holds(double from, double to) const {
    return std::ranges::any_of(spans_, [&](const RadiusRange& s) { return s.low <= from && to <= s.high; });
  }
  /// Does it hold some of [from, to]?
  bool meets(double from, double to) const {
    return std::ranges::any_of(spans_, [&](const RadiusRange& s) { return s.low <= to && from <= s.high; });
  }
  /// The length of [from, to] that it holds, mm.
  double length(double from, double to) const {
    return sum(from, to, [](double radius) { return radius; });
  }
  /// The volume that it holds up to the radius `to`, mm^3 per steradian.
  double volume(double to) const {
    return sum(0.0, to, [](double radius) { return radius * radius * radius / 3.0; });
  }

 private:
  double sum(double from, double to, const auto& of) const {
    double all = 0.0;
    for (const RadiusRange& s : spans_) {
      const double low = std::max(from, s.low);
      const double high = std::min(to, s.high);
      if (low < high) all += of(high) - of(low);
    }
    return all;
  }

  std::vector<RadiusRange> spans_;
};

/// What is known of the rays of a cap of directions.
struct SpansOverCap {
  RaySpans certain;   // in the set along every ray
  RaySpans possible;  // no other radius is in it along any ray
};

}  // namespace impinge
