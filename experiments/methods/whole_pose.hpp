// SPDX-License-Identifier: GPL-3.0-or-later
// A library that answers once for a whole pose, among the methods that are asked point by point.
#pragma once

#include "methods/heap_use.hpp"
#include "methods/points.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {

/// make(pair) gives the smallest distance in a pose, mm, 0 where the surfaces touch. Bytes are those of the
/// heap.
template <class Make>
PointCase pose_case(const char* name, const char* label, const BenchmarkScene& scene, const Make& make) {
  PointCase one = library_case(name, label, Measure::pose, [&scene, make] {
    const double before = heap_bytes();
    const auto of = make(scene.pair);
    return PointQuery{
        [of, pose = scene.pose](std::span<const Vec3>, std::span<double> out) { out[0] = of(pose); },
        heap_bytes() - before};
  });
  one.place = 13;
  return one;
}

/// make(pair) gives a Touch, which says no more than whether they do: 0 mm where they touch, else NaN.
template <class Make>
PointCase touch_case(const char* name, const char* label, const BenchmarkScene& scene, const Make& make) {
  PointCase one = pose_case(name, label, scene, [make](const BallSocketPair& pair) {
    return [touches = make(pair)](const Pose& pose) { return touches(pose) ? 0.0 : kNoSurface; };
  });
  one.says_how_far = false;
  return one;
}

}  // namespace impinge::lab
