// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of a scene with everything that its report says about it.
#pragma once

#include <filesystem>
#include <vector>

#include "hip/gap_levels.hpp"
#include "scene/joint.hpp"
#include "scene/measurement.hpp"

namespace impinge {

/// What it refers to outlives it.
struct ReportedSurface {
  Surface surface;                        // which of the two
  const std::filesystem::path& file;      // that it was read from
  const JointPart& part;                  // its mesh and what was found out about it
  const SurfaceGaps& gaps;                // of its vertices
  std::vector<Vec3> posed;                // socket's centre frame, mm
  std::vector<double> area;               // of each vertex, mm^2; empty where it was not scanned
  std::vector<double> against_cartilage;  // gaps in mm, or as shares of a map's thickness
  double touching = 0.0;                  // of these, where the layers of cartilage touch
};

/// Of the ball or the socket, in the pose of the measurement.
ReportedSurface reported(Surface surface, const SceneOptions& options, const Joint& joint,
                         const Measurement& measurement);

}  // namespace impinge
