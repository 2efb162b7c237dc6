// SPDX-License-Identifier: GPL-3.0-or-later
// How much two answers to one scene differ.
#pragma once

#include "session/scene_answer.hpp"

namespace impinge::lab {

// Are the answers the same, bit for bit?
bool same_answer(const SceneAnswer& a, const SceneAnswer& b);

// Largest difference of the gaps of one pose, mm; infinite if only one has some gap.
double gap_difference(const PoseGaps& a, const PoseGaps& b);

// Largest difference of two answers' gaps, mm; infinite if only one has some gap, or if a touch differs.
double answer_difference(const SceneAnswer& a, const SceneAnswer& b);

}  // namespace impinge::lab
