// SPDX-License-Identifier: GPL-3.0-or-later
// The gaps of a hip in many poses, by tables that are filled once.
#pragma once

#include <string>
#include <vector>

#include "detection/gap_summary.hpp"
#include "detection/pose.hpp"
#include "joint/anatomy.hpp"
#include "joint/close_zones.hpp"
#include "kernels/joint_scan.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

// A hip in the joint frame, mm, the centre of rotation as origin.
struct ReplayedHip {
  std::string name;
  Side side = Side::right;
  TriangleMesh ball;
  TriangleMesh socket;  // that has a dial: std::invalid_argument otherwise (joint/clock.hpp)
};

// All that the poses of one hip share; the hip must outlive it.
struct HipScanner {
  const ReplayedHip& hip;
  ClockFace dial;
  JointLanes<LaneTable<Rsid, double>> lanes;
  std::vector<double> ball_area;  // vertex_areas(), mm^2
  std::vector<double> socket_area;
};
HipScanner hip_scanner(const ReplayedHip& hip, double precision_deg);

// One surface in one pose.
struct PosedSurface {
  std::vector<Vec3> vertices;  // as posed
  std::vector<double> gap;     // mm, NaN where the other surface is not met
  const std::vector<double>& area;

  PosedGaps gaps() const { return {vertices, gap, area}; }
  GapSummary within(double threshold) const { return summarise(gap, area, threshold); }
};

struct PosedHip {
  Pose pose;
  PosedSurface ball;
  PosedSurface socket;
};
PosedHip scan(const HipScanner& scanner, const Pose& pose);

}  // namespace impinge
