// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of a scene with everything that its report says about it.
#pragma once

#include <filesystem>
#include <vector>

#include "joint/gap_levels.hpp"
#include "scene/joint.hpp"
#include "scene/measurement.hpp"

namespace impinge {

// What it refers to outlives it.
struct ReportedSurface {
  Surface surface;
  const std::filesystem::path& file;
  const JointPart& part;
  const SurfaceGaps& gaps;
  std::vector<Vec3> posed;  // socket's centre frame, mm
  std::vector<double> area;
  std::vector<double> against_cartilage;  // gaps in mm, or as shares of a map's thickness
  double touching = 0.0;                  // of these, where the layers of cartilage touch
};

ReportedSurface reported(Surface surface, const SceneOptions& options, const Joint& joint,
                         const Measurement& measurement);

}  // namespace impinge
