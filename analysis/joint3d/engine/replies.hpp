// SPDX-License-Identifier: GPL-3.0-or-later
// What the session found, as the page reads it.
#pragma once

#include "joint/gaps.hpp"
#include "js_values.hpp"

namespace impinge {

val joint_reply(const SessionJoint& joint);
val tables_reply(const SessionTables& tables);
val pose_reply(const SessionJoint& joint, const GapsAnswer& found);
val points_reply(const Session& session);
val verdicts_reply(const PoseVerdicts& found);

}  // namespace impinge
