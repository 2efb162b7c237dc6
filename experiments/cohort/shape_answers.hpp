// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of a hip, measured from its meshes alone.
#pragma once

#include <optional>
#include <vector>

#include "files/csv.hpp"
#include "hip/anatomy.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// measured_NAME, where NAME is the parameter that is measured, or alpha_H at H o'clock about the neck.
std::vector<Column> shape_columns();

// Their cells; empty what the meshes do not show, all without a side. Joint frame, mm.
std::vector<Cell> shape_cells(const BallSocketPair& meshes, const std::optional<Side>& side);

}  // namespace impinge::lab
