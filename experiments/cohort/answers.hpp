// SPDX-License-Identifier: GPL-3.0-or-later
// The questions about one hip, answered as the cells of a row.
#pragma once

#include <optional>
#include <vector>

#include "cohort/member.hpp"
#include "cohort/study.hpp"
#include "files/csv.hpp"
#include "hip/anatomy.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// Prefix of the answers of a second look, at a finer mesh.
inline constexpr const char* kFine = "fine_";

// The columns of a row after the description of its hip. For each motion M (hip/named_motion.hpp):
//   M_state   limited, free, blocked or unknown (limits/turn_limit.hpp)
//   M_deg     lower end of the bracket of its limit; the largest tested angle if free, 0 if blocked
//   M_low_deg, M_high_deg   hold for every common centre within half a millimetre; M_high_deg is empty unless
//             all of them are known to have a limit
//   M_clock   hours, where the bones touch
//   M_zone_from, M_zone_to, M_zone_mm2   at the limit, the stretch of the socket's dial that has the largest
//             area with gaps up to the threshold
// For the shape: measured_NAME (hip/hip_measures.hpp). For the motion volume (rotations/volume.hpp), with a
// width of 0.05: volume_free_low, volume_free_high, volume_reach_low and volume_reach_high, shares of all
// rotations. For the finer mesh: fine_NAME, of M_deg and of the shape.
std::vector<Column> answer_columns(const Study& study);

// The cells of a hip. Empty where the hip lacks something, such as a neck or a side.
std::vector<Cell> answers(const Study& study, const Member& member);

// How far a hip turns, and where gaps are small at its limit.

// The columns of all motions; see answer_columns().
std::vector<Column> limit_columns(const CohortQuestions& asked);

// The cells of limit_columns(). Meshes in the joint frame about the centre, mm.
std::vector<Cell> limit_cells(const CohortQuestions& asked, const BallSocketPair& meshes,
                              const std::optional<Side>& side);

// Only M_deg of each motion.
std::vector<Column> plain_limit_columns();
std::vector<Cell> plain_limit_cells(const BallSocketPair& meshes, const std::optional<Side>& side);

// The shape of a hip, measured from its meshes alone.

// measured_NAME, where NAME is the measured parameter, or alpha_H at H o'clock about the neck.
std::vector<Column> shape_columns();

// The cells of shape_columns(). Empty where the meshes do not show a measure, and all without a side. Joint
// frame, mm.
std::vector<Cell> shape_cells(const BallSocketPair& meshes, const std::optional<Side>& side);

}  // namespace impinge::lab
