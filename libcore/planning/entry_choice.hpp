// SPDX-License-Identifier: GPL-3.0-or-later
// The step of a plan that decides what is looked up: which table, and which of its entries.
#pragma once

#include "planning/plan_draft.hpp"

namespace impinge {

/// Chooses the table for the accuracy that is asked for, if one is, and for each scan the entries that its
/// look-ups read. The vertices of the plan are chosen.
void choose_entries(PlanDraft& draft);

}  // namespace impinge
