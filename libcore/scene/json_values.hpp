// SPDX-License-Identifier: GPL-3.0-or-later
// Points and numbers as summary.json writes them.
#pragma once

#include <cmath>

#include <nlohmann/json.hpp>

#include "sphere/direction.hpp"

namespace impinge {

/// Object of x, y and z, in the frame and unit of `x`.
inline nlohmann::json point_json(const Vec3& x) { return {{"x", x.x()}, {"y", x.y()}, {"z", x.z()}}; }

/// The number; null if it is infinite or NaN, which JSON lacks.
inline nlohmann::json number_json(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

/// Array [low, high], each as by number_json().
inline nlohmann::json interval_json(double low, double high) {
  return nlohmann::json::array({number_json(low), number_json(high)});
}

}  // namespace impinge
