// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of one hip, as the cells of a row.
#pragma once

#include <vector>

#include "cohort/member.hpp"
#include "cohort/study.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// Prefix of what a second look at a finer mesh found.
inline constexpr const char* kFine = "fine_";

// The columns of a row behind the description of its hip. Of each motion M (hip/named_motion.hpp):
//   M_state   limited, free, blocked or unknown (limits/turn_limit.hpp)
//   M_deg     lower end of the bracket of its limit; the largest angle looked at where free, 0 where blocked
//   M_low_deg, M_high_deg   hold for every common centre within half a millimetre
//   M_clock   hours, where the bones touch
//   M_zone_from, M_zone_to, M_zone_mm2   the stretch of the socket's dial with the largest area of gaps up to
//             the threshold, at the limit
// of the shape measured_NAME (hip/hip_measures.hpp); of the motion volume (rotations/volume.hpp), to its
// width of 0.05, volume_free_low, volume_free_high, volume_reach_low and volume_reach_high, shares of all
// rotations; and fine_NAME, M_deg and the shape of the finer mesh.
std::vector<Column> answer_columns(const Study& study);

// The cells of that hip. Empty what a joint does not have, as a neck, or a side.
std::vector<Cell> answers(const Study& study, const Member& member);

}  // namespace impinge::lab
