// SPDX-License-Identifier: GPL-3.0-or-later
// What a session says of one pose: gaps, what they mean, and what is proven about them.
#pragma once

#include <optional>
#include <vector>

#include "gap/certified_gap.hpp"
#include "gap/gap_histogram.hpp"
#include "gap/gap_summary.hpp"
#include "gap/measured_gap.hpp"
#include "motion/euclidean_distance.hpp"
#include "session/session.hpp"

namespace impinge {

/// A pose, and where the cartilage begins.
struct PoseRequest {
  Motion motion;                    // degrees
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 4.0;        // both layers together; without a map of it
};

/// Of the vertices of one surface. What was not asked for is empty.
struct SurfaceAnswer {
  std::vector<double> gap;    // mm, NaN where the other surface is not met; empty if it was not scanned
  std::vector<double> bound;  // mm, proven bound on the error of the gap, NaN with it, infinite where none is
  std::vector<DistanceBracket> distance;  // Euclidean, to any point of the other surface, of every vertex

  std::vector<double> against_cartilage;   // gaps in mm, or as shares of a map's thickness
  double touching = 0.0;                   // of these, where the layers of cartilage touch
  GapSummary all;                          // of the gaps
  GapSummary bone;                         // impinged at 0
  GapSummary cartilage;                    // impinged where the layers of cartilage touch
  std::vector<ClockZone> bone_zones;       // of the dial, with such gaps; empty without a dial
  std::vector<ClockZone> cartilage_zones;  // the same
  GapHistogram histogram;                  // of the gaps
};

/// The vertex with the smallest gap of a pose.
struct SmallestOfPose {
  Surface surface = Surface::ball;  // whose vertex it is
  std::size_t vertex = 0;           // place among those of its mesh
  double gap_mm = 0.0;              // its gap
  Vec3 place = Vec3::Zero();        // posed, centre frame of the socket, mm
  std::optional<double> hours;      // on the dial
};

/// Both scans.
struct PoseAnswer {
  Pose pose;             // of the ball, with its shift; gaps are those of its rotation alone
  SurfaceAnswer ball;    // vertices of the ball against the socket
  SurfaceAnswer socket;  // vertices of the socket against the ball
  std::optional<SmallestOfPose> smallest;  // none where the surfaces do not face each other
  double scan_ms = 0.0;                    // both scans

  const SurfaceAnswer& of(Surface surface) const { return surface == Surface::ball ? ball : socket; }
  SurfaceAnswer& of(Surface surface) { return surface == Surface::ball ? ball : socket; }
};

/// What the gaps and their bounds prove about a pose.
struct PoseVerdicts {
  VerdictCount vertices;      // of those that have a gap, on both surfaces
  std::size_t unbounded = 0;  // of the undecided ones, those about which nothing is proven
  double largest_mm = 0.0;    // the largest bound of the others
  double median_mm = 0.0;     // and their median, the upper one of two
  SmallestBetween smallest;   // of all that have a gap
};

/// The pose that a motion names, of the ball in the centre frame of the socket.
Pose pose_of(const SessionJoint& joint, const Motion& motion, const Vec3& translation = Vec3::Zero());

/// By the tables, which have been filled.
PoseAnswer answer_pose(Session& session, const PoseRequest& request);

/// What these gaps mean, of the vertices of both surfaces, mm; none of a surface that was not scanned.
PoseAnswer answer_of_gaps(const SessionJoint& joint, const Pose& pose, std::vector<double> ball_gap,
                          std::vector<double> socket_gap, double cartilage_mm);

/// Vertices of a surface in a pose, in the frame of the other one, about the centre of the ball, mm.
std::vector<Vec3> places_in_other(const SessionJoint& joint, const Pose& pose, Surface of);

/// The same in the centre frame of the socket.
std::vector<Vec3> posed_places(const SessionJoint& joint, const Pose& pose, Surface of);

/// Gives each gap the bound of the cell that it reads. Bounds the tables when that has not been done.
void bound_gaps(Session& session, PoseAnswer& answer);

/// Of gaps that have their bounds; those whose bound leaves open where the smallest is are measured on the
/// faces.
PoseVerdicts verdicts_of(SessionJoint& joint, const PoseAnswer& answer);

/// All three: the verdicts of session/certificate.hpp before its exact look.
PoseVerdicts answer_verdicts(Session& session, const PoseRequest& request);

}  // namespace impinge
