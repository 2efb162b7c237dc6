// SPDX-License-Identifier: GPL-3.0-or-later
// The step of a plan that decides which vertices and which scans matter, and how these are found.
#pragma once

#include "planning/plan_draft.hpp"

namespace impinge {

/// Chooses between looking at each vertex and at whole caps of them, and leaves out the vertices, and with
/// them maybe the second scan, that cannot change the answer. Sets the plan's limit.
void choose_vertices(PlanDraft& draft);

}  // namespace impinge
