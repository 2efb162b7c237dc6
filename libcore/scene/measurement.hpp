// SPDX-License-Identifier: GPL-3.0-or-later
// The gaps of a joint in one pose.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gap/euclidean_bracket.hpp"
#include "gap/measured_gap.hpp"
#include "gap/pose.hpp"
#include "planning/scene_answer.hpp"
#include "scene/certificate.hpp"
#include "scene/joint.hpp"
#include "scene/options.hpp"

namespace impinge {

/// One scan: the vertices of one surface against the table of the other. What was not asked for is empty.
struct SurfaceGaps {
  std::vector<double> gap;    // mm, NaN where the other surface is not met
  std::vector<double> bound;  // mm, proven bound on the error of the gap, NaN with it, infinite where none is
  std::vector<DistanceBracket> distance;  // Euclidean, to any point of the other surface, of every vertex
};

struct Measurement {
  Pose pose;                               // of the ball, in the centre frame
  SurfaceGaps ball;                        // vertices of the ball against the socket
  SurfaceGaps socket;                      // vertices of the socket against the ball
  double precision_deg = 0.0;              // of both tables; 0 with --max-error
  std::size_t entries = 0;                 // of each table; worked out in both, with --max-error
  std::size_t bytes = 0;                   // of both tables
  double fill_ms = 0.0;                    // both tables
  double bound_ms = 0.0;                   // the bounds of all gaps
  double scan_ms = 0.0;                    // both scans
  double distance_ms = 0.0;                // the brackets of all Euclidean distances
  SmallestBetween smallest;                // of all gaps, where their bounds are asked for
  std::optional<Certificate> certificate;  // exact verdicts on vertices and surfaces
  std::string way;                         // how the gaps were found, and why so, in one clause
  std::vector<LeftOut> left_out;           // work and memory that the scene did not need
};

/// Fills a table for each surface at the precision asked for, and scans both. Where neither bounds nor
/// verdicts are asked for, only what the gaps need is done (planning/scene_plan.hpp). With --max-error, gaps
/// that no table is proven to keep that accurate are measured on the faces, and bounds, where they are asked
/// for, are those of holding each gap against the faces (gap/measured_gap.hpp).
///
/// Tables are filled and scanned in double, without the kernels of libcore/kernels. Those have tables of the
/// cube map, RSID and USID in fewer bits, whose bounds are wider, and there is little that they could save:
/// 0.8 to 1.4 % of a run with default options, of a generated hip of 12,000 faces a surface, a femoral head
/// of as many in its acetabulum, and a whole femur of 73,000. The bounds of all gaps take 50 to 64 % of it,
/// reading, fit and checks of the meshes and writing 24 to 35 %, Euclidean distances 9 to 14 %, verdicts
/// below 1 %. A summary has those times of its own run.
///
/// std::runtime_error, one line, if the tables do not fit in memory (with the bytes that they would take) or
/// --max-error is below what rounding leaves.
Measurement measure(const Joint& joint, const SceneOptions& options);

/// The pose that the options name, of the ball in the centre frame.
Pose scene_pose(const SceneOptions& options);

}  // namespace impinge
