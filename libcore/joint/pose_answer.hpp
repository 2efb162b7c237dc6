// SPDX-License-Identifier: GPL-3.0-or-later
// Answers for one pose: gaps, summaries of them, and what is proven about them.
#pragma once

#include <vector>

#include "joint/gaps.hpp"

namespace impinge {

/// A pose, and the thickness of the cartilage.
struct PoseRequest {
  Motion motion;                    // degrees
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 4.0;        // both layers together; ignored if the joint has a cartilage map
};

/// Answers by the tables, which must be filled. Shifts the ball by request.translation.
GapsAnswer answer_pose(Session& session, const PoseRequest& request);

/// Summaries of given gaps (mm, by vertex); a surface that was not scanned has an empty list.
GapsAnswer answer_of_gaps(const SessionJoint& joint, const Pose& pose, std::vector<double> ball_gap,
                          std::vector<double> socket_gap, double cartilage_mm);

/// Vertices of a surface in a pose, in the frame of the other surface, about the centre of the ball, mm.
std::vector<Vec3> places_in_other(const SessionJoint& joint, const Pose& pose, Surface of);

/// Vertices of a surface in a pose, in the centre frame of the socket, mm.
std::vector<Vec3> posed_places(const SessionJoint& joint, const Pose& pose, Surface of);

/// Adds to each gap the bound of the table's cell that it was read from; bounds the tables first if needed.
void bound_gaps(Session& session, GapsAnswer& answer);

/// The verdicts for gaps with bounds. Where the bounds leave open which gap is the smallest, these gaps are
/// measured on the faces.
PoseVerdicts verdicts_of(SessionJoint& joint, const GapsAnswer& answer);

/// answer_pose(), bound_gaps() and verdicts_of() in turn.
PoseVerdicts answer_verdicts(Session& session, const PoseRequest& request);

}  // namespace impinge
