// SPDX-License-Identifier: GPL-3.0-or-later
// The gaps of a hip in many poses, by tables that are filled once.
#pragma once

#include <string>
#include <vector>

#include "gap/gap_summary.hpp"
#include "gap/pose.hpp"
#include "gap/simd/joint_scan.hpp"
#include "hip/anatomy.hpp"
#include "hip/close_zones.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// A hip in the joint frame, mm, the centre of rotation as origin.
struct ReplayedHip {
  std::string name;         // in the results and of the files
  Side side = Side::right;  // of the body
  TriangleMesh ball;        // mm
  TriangleMesh socket;      // that has a dial: std::invalid_argument otherwise (hip/clock.hpp)
};

// All that the poses of one hip share; the hip must outlive it.
struct HipScanner {
  const ReplayedHip& hip;                        // borrowed
  ClockFace dial;                                // of the socket
  PackedJoint<PackedTable<Rsid, double>> lanes;  // tables and vertices of both surfaces
  std::vector<double> ball_area;                 // vertex_areas(), mm^2
  std::vector<double> socket_area;
};
HipScanner hip_scanner(const ReplayedHip& hip, double precision_deg);  // fills the tables, exactly

// One surface in one pose.
struct PosedSurface {
  std::vector<Vec3> vertices;       // as posed
  std::vector<double> gap;          // mm, NaN where the other surface is not met
  const std::vector<double>& area;  // of each vertex, mm^2

  PosedGaps gaps() const { return {vertices, gap, area}; }  // as close_zones() takes them
  // What gaps of at most so many mm come to.
  GapSummary within(double threshold) const { return impinge::summarise(gap, area, threshold); }
};

// Both surfaces in one pose.
struct PosedHip {
  PosedSurface ball;    // vertices where the pose has put them
  PosedSurface socket;  // at rest
};
PosedHip scan(const HipScanner& scanner, const Pose& pose);  // the gaps of every vertex in the pose

}  // namespace impinge::lab
