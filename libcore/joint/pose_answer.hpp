// SPDX-License-Identifier: GPL-3.0-or-later
// A session's answer for one pose: gaps, summaries of them, and what is proven about them.
#pragma once

#include <optional>
#include <vector>

#include "contact/euclidean_distance.hpp"
#include "gap/certified_gap.hpp"
#include "gap/gap_histogram.hpp"
#include "gap/gap_summary.hpp"
#include "gap/measured_gap.hpp"
#include "joint/session.hpp"

namespace impinge {

/// A pose, and the thickness of the cartilage.
struct PoseRequest {
  Motion motion;                    // degrees
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 4.0;        // both layers together; ignored if the joint has a cartilage map
};

/// Results for the vertices of one surface, one value a vertex; empty if not asked for.
struct SurfaceAnswer {
  std::vector<double> gap;    // mm, NaN where the other surface is not met; empty if it was not scanned
  std::vector<double> bound;  // mm, proven bound on the gap's error; NaN without a gap, infinite if unproven
  std::vector<DistanceBracket> distance;  // Euclidean, to any point of the other surface, of every vertex

  std::vector<double> against_cartilage;   // gaps in mm, or as shares of the map's thickness if there is one
  double touching = 0.0;                   // value of against_cartilage at which the layers touch
  GapSummary all;                          // of `gap`
  GapSummary bone;                         // of against_cartilage, impinged at 0
  GapSummary cartilage;                    // of against_cartilage, impinged at `touching`
  std::vector<ClockZone> bone_zones;       // of the dial, impinged as in `bone`; empty without a dial
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

/// What the gaps and their bounds prove about a pose. Counts the vertices of both surfaces that have a gap.
struct PoseVerdicts {
  VerdictCount vertices;      // clear, impinged or undecided by their bounds
  std::size_t unbounded = 0;  // undecided vertices without a finite bound
  double largest_mm = 0.0;    // largest finite bound
  double median_mm = 0.0;     // median of the finite bounds, the upper one of two
  SmallestBetween smallest;   // interval of the smallest gap
};

/// The pose that a motion names, of the ball in the centre frame of the socket.
Pose pose_of(const SessionJoint& joint, const Motion& motion, const Vec3& translation = Vec3::Zero());

/// Answers by the tables, which must have been filled. Shifts the ball by request.translation.
PoseAnswer answer_pose(Session& session, const PoseRequest& request);

/// Summaries of given gaps (mm, by vertex); empty for a surface that was not scanned.
PoseAnswer answer_of_gaps(const SessionJoint& joint, const Pose& pose, std::vector<double> ball_gap,
                          std::vector<double> socket_gap, double cartilage_mm);

/// Vertices of a surface in a pose, in the frame of the other one, about the centre of the ball, mm.
std::vector<Vec3> places_in_other(const SessionJoint& joint, const Pose& pose, Surface of);

/// The same in the centre frame of the socket.
std::vector<Vec3> posed_places(const SessionJoint& joint, const Pose& pose, Surface of);

/// Adds to each gap its bound, that of the table's cell it was read from; bounds the tables first if needed.
void bound_gaps(Session& session, PoseAnswer& answer);

/// The verdicts of gaps that have their bounds. Where the bounds leave open which gap is the smallest, these
/// gaps are measured on the faces.
PoseVerdicts verdicts_of(SessionJoint& joint, const PoseAnswer& answer);

/// answer_pose(), bound_gaps() and verdicts_of() in turn.
PoseVerdicts answer_verdicts(Session& session, const PoseRequest& request);

}  // namespace impinge
