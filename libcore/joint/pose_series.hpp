// SPDX-License-Identifier: GPL-3.0-or-later
// One joint in many poses: touch and the smallest gap of each, without looking at most vertices and faces,
// and impinged areas by the kernel of exact cells (gap/simd/exact_cells.hpp).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/culled_joint.hpp"
#include "gap/pose.hpp"
#include "gap/simd/exact_cells.hpp"
#include "gap/simd/joint_scan.hpp"
#include "hip/joint.hpp"
#include "joint/posed_gap.hpp"
#include "limits/body_pairs.hpp"

namespace impinge {

/// What is worked out of each pose.
struct SeriesOutputs {
  bool touch = true;
  bool smallest_gap = true;
  bool areas = false;         // of all gaps
  double cartilage_mm = 4.0;  // both layers together
};

/// Impinged area of one surface, by the vertices' gaps in float, mm^2.
struct SeriesArea {
  double bone = 0.0;       // where the gap is 0 or less
  double cartilage = 0.0;  // where the gap is the cartilage's thickness or less
};

struct SeriesAnswer {
  std::optional<BodyPairs::Verdict> touch;         // exact; none if not asked for
  std::optional<PosedGap> smallest;                // none also where the surfaces do not face each other
  std::optional<std::array<SeriesArea, 2>> areas;  // of ball and socket; none if not asked for
};

class PoseSeries {
 public:
  /// std::invalid_argument for lengths that CulledScan refuses. Gaps are those between the main surfaces.
  PoseSeries(const Joint& joint, const SeriesOutputs& outputs);
  PoseSeries(const PoseSeries&) = delete;
  PoseSeries& operator=(const PoseSeries&) = delete;

  /// Several threads may ask at the same time.
  SeriesAnswer answer(const Pose& pose) const;

 private:
  /// One surface's vertices, and the faces that they meet.
  struct Scan {
    Scan(const TriangleMesh& scanned, const TriangleMesh& facing, Layer layer);
    SeriesArea area(const Pose& pose, Surface of, double cartilage_mm) const;

    ExactCells cells;  // of the other surface
    PackedVertices<float> vertices;
    std::vector<double> areas;  // mm^2
  };

  SeriesOutputs outputs_;
  BallSocketPair meshes_;            // the main surfaces
  std::optional<BodyPairs> bodies_;  // if touch is asked for
  CulledJoint joint_;
  std::vector<Scan> scans_;  // of ball and socket, if areas are
};

/// The pose in the centre frame for a motion x' = rotation x + translation of the ball in the input frame
/// (mm), which also has `centre`.
Pose pose_about(const Vec3& centre, const Eigen::Matrix3d& rotation, const Vec3& translation);

}  // namespace impinge
