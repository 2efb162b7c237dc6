// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps by whole tables of both surfaces, each with the proven bound of its error.
#pragma once

#include "scene/measurement.hpp"

namespace impinge {

/// Gaps, bounds, times and memory, of the scheme and precision of the options. std::runtime_error, one line,
/// if the tables do not fit in memory.
Measurement measure_whole_tables(const Joint& joint, const SceneOptions& options, const Pose& pose);

}  // namespace impinge
