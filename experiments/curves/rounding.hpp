// SPDX-License-Identifier: GPL-3.0-or-later
// How far rounding may lead past the end of a curve.
#pragma once

namespace impinge {

/// Of the whole: a length, area or angle that passes the end by no more is at the end.
inline constexpr double kCurveRounding = 1e-12;

}  // namespace impinge
