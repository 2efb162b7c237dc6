// SPDX-License-Identifier: GPL-3.0-or-later
// The methods that the thesis compares itself with in Section 3.6, each at several resolutions, beside its
// own.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "18_baselines/baseline_points.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "methods/touch_method.hpp"

namespace impinge::lab {

// At which resolutions each method is tried.
struct BaselineSizes {
  std::vector<double> voxels_mm;       // hu_voxels: side of a voxel
  std::vector<std::size_t> rays;       // maciel_triangles: rays a side
  std::vector<std::size_t> nodes;      // cartesian_field: nodes a side
  std::vector<double> precisions_deg;  // rsid
  double most_pairs = 1e8;             // rays times faces up to which filling by all pairs is timed
};

// One method at one resolution, with what it takes and what it answered.
struct BaselineMethod {
  std::string name;                    // in the results
  std::string setting;                 // the resolution in words
  double size = 0.0;                   // mm of a voxel, rays or nodes a side, degrees
  std::unique_ptr<TouchMethod> touch;  // answers whether a pose touches
  double bytes = 0.0;                  // kept for both surfaces
  std::function<void()> build;  // everything done once for a joint; empty where it takes too long to be timed
  double work = 1.0;            // of build, by which its time grows
  double missed_faces = std::numeric_limits<double>::quiet_NaN();  // of the ball, that no entry samples
  BaselineAnswers answers;  // its distances or radii against the exact ones
};

// Every method at every size, built, checked and asked. Throws std::runtime_error for one that breaks what is
// proven of it. The joint must outlive the methods.
std::vector<BaselineMethod> baseline_methods(const BallSocketPair& joint, const BaselineSizes& sizes,
                                             const BaselinePoints& points);

}  // namespace impinge::lab
