// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of one hip, as the cells of a row.
#pragma once

#include <optional>
#include <vector>

#include "cohort/member.hpp"
#include "cohort/study.hpp"
#include "files/csv.hpp"
#include "hip/anatomy.hpp"
#include "mesh/ball_socket_pair.hpp"

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

// How far a hip turns, and where it is close then.

// Columns of all motions; see answer_columns().
std::vector<Column> limit_columns(const CohortQuestions& asked);

// Their cells. Meshes in the joint frame about the centre, mm.
std::vector<Cell> limit_cells(const CohortQuestions& asked, const BallSocketPair& meshes,
                              const std::optional<Side>& side);

// M_deg alone, of each motion.
std::vector<Column> plain_limit_columns();
std::vector<Cell> plain_limit_cells(const BallSocketPair& meshes, const std::optional<Side>& side);

// The shape of a hip, measured from its meshes alone.

// measured_NAME, where NAME is the parameter that is measured, or alpha_H at H o'clock about the neck.
std::vector<Column> shape_columns();

// Their cells; empty what the meshes do not show, all without a side. Joint frame, mm.
std::vector<Cell> shape_cells(const BallSocketPair& meshes, const std::optional<Side>& side);

}  // namespace impinge::lab
