// SPDX-License-Identifier: GPL-3.0-or-later
// What the page reads: documents, and arrays beside them.
#pragma once

#include "joint/gaps.hpp"
#include "joint/orient.hpp"
#include "joint/resect.hpp"
#include "joint/volume.hpp"
#include "js_values.hpp"

namespace impinge {

/// What there is to choose from: hips, their parameters, motions, schemes and precisions.
Json catalogue();
/// {head_radius: 24, ...}, without the side.
Json parameters_document(const HipParameters& parameters);

val joint_reply(const SessionJoint& joint);
Json tables_reply(const SessionTables& tables);
val pose_reply(const SessionJoint& joint, const GapsAnswer& found);
val points_reply(const Session& session);
Json verdicts_reply(const PoseVerdicts& found);

/// What README.md says of `resect`, `orient` and `volume` beside their documents.
void add_arrays(const SessionJoint& joint, const ResectAnswer& found, val& reply);
void add_arrays(const SessionJoint& joint, const OrientAnswer& found, val& reply);
void add_arrays(const SessionJoint& joint, const VolumeAnswer& found, val& reply);

}  // namespace impinge
