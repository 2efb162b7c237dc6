// SPDX-License-Identifier: GPL-3.0-or-later
// How far a hip turns, and where it is close then.
#pragma once

#include <optional>
#include <vector>

#include "cohort/study.hpp"
#include "files/csv.hpp"
#include "hip/anatomy.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// Columns of all motions; see answers.hpp.
std::vector<Column> limit_columns(const CohortQuestions& asked);

// Their cells. Meshes in the joint frame about the centre, mm.
std::vector<Cell> limit_cells(const CohortQuestions& asked, const BallSocketPair& meshes,
                              const std::optional<Side>& side);

// M_deg alone, of each motion.
std::vector<Column> plain_limit_columns();
std::vector<Cell> plain_limit_cells(const BallSocketPair& meshes, const std::optional<Side>& side);

}  // namespace impinge::lab
