// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps by whole tables of both surfaces, each with the proven bound of its error.
#pragma once

#include "scene/measurement.hpp"

namespace impinge {

// Gaps, bounds, times and memory, of the scheme of the options: at their precision, or with --max-error at
// the coarsest of 1, 0.5, 0.25, 0.1, 0.05 and 0.025 degrees whose bound keeps that at every vertex.
// std::runtime_error, one line, if the tables do not fit in memory or none of these is fine enough.
Measurement measure_whole_tables(const Joint& joint, const SceneOptions& options, const Pose& pose);

}  // namespace impinge
