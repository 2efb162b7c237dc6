// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of a ray from the centre.
#pragma once

#include <algorithm>
#include <vector>

#include "table/face_cap.hpp"

namespace impinge {

/// Radii in mm, in order and apart.
class RaySpans {
 public:
  /// Adds [from, to], nothing if that is empty.
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
  /// Is all of [from, to] within?
  bool holds(double from, double to) const {
    return std::ranges::any_of(spans_, [&](const RadiusRange& s) { return s.low <= from && to <= s.high; });
  }
  /// Is some of it?
  bool meets(double from, double to) const {
    return std::ranges::any_of(spans_, [&](const RadiusRange& s) { return s.low <= to && from <= s.high; });
  }
  /// How much of [from, to] is, mm.
  double length(double from, double to) const {
    return sum(from, to, [](double radius) { return radius; });
  }
  /// Of [0, to], for each steradian, mm^3.
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
  RaySpans certain;   // within, along every one
  RaySpans possible;  // nothing else is, along any
};

}  // namespace impinge
