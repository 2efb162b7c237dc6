// SPDX-License-Identifier: GPL-3.0-or-later
// The methods with which the thesis compares its own (Section 3.6), each at several resolutions.
#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>

#include "methods/method.hpp"

namespace impinge::lab {

/// The resolutions at which each method is tried.
struct BaselineSizes {
  std::vector<double> voxels_mm;       // hu_voxels: side of a voxel
  std::vector<std::size_t> rays;       // maciel_triangles: rays per side
  std::vector<std::size_t> nodes;      // cartesian_field: nodes per side
  std::vector<double> precisions_deg;  // rsid
  double most_pairs = 1e8;             // largest rays times faces for which filling by all pairs is timed
};

/// One method at one resolution, ready to use. The joint must outlive it.
struct BaselineCase : Case {
  double size = 0.0;            // side of a voxel (mm), rays or nodes per side, or precision (degrees)
  Touch touches = {};           // whether a pose touches
  bool gives_distance = false;  // does the same work yield distances, everywhere?
  double bytes = 0.0;           // memory for both surfaces
  std::function<void()> build =
      {};             // everything done once for a joint; empty where it takes too long to be timed
  double work = 1.0;  // the time of `build` is proportional to this
  double missed_faces = std::numeric_limits<double>::quiet_NaN();  // faces of the ball that no entry samples
  std::function<double(const Vec3&)> radius = {};    // of the ball, along a point in its frame, mm
  std::function<double(const Vec3&)> distance = {};  // of a point from the socket, in the socket's frame, mm
  double slack_mm = std::numeric_limits<double>::infinity();  // answers exceed the exact one by no more
};

/// Throws std::runtime_error: a proven property of a method does not hold.
[[noreturn]] inline void broken(const std::string& method, const std::string& what) {
  throw std::runtime_error(method + ": " + what + ": its results mean nothing until that is resolved");
}

}  // namespace impinge::lab
