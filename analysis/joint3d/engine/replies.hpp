// SPDX-License-Identifier: GPL-3.0-or-later
// What the session found, as the page reads it.
#pragma once

#include "joint/limits.hpp"
#include "js_values.hpp"

namespace impinge {

val joint_reply(const SessionJoint& joint);
val tables_reply(const SessionTables& tables);
val pose_reply(const SessionJoint& joint, const PoseRequest& request, const PoseAnswer& found);
val points_reply(const Session& session);
val verdicts_reply(const PoseVerdicts& found);
val sweep_reply(const SessionJoint& joint, const std::string& motion, const LimitRequest& request,
                const Sweep& found, const LimitAnswers& limits);

}  // namespace impinge
