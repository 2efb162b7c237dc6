// SPDX-License-Identifier: GPL-3.0-or-later
// A point as summary.json writes it.
#pragma once

#include <nlohmann/json.hpp>

#include "sphere/direction.hpp"

namespace impinge {

// Object of x, y and z, in the frame and unit of `x`.
inline nlohmann::json point_json(const Vec3& x) { return {{"x", x.x()}, {"y", x.y()}, {"z", x.z()}}; }

}  // namespace impinge
