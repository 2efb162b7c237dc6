// SPDX-License-Identifier: GPL-3.0-or-later
// Which crossing is kept where a direction meets a surface more than once.
#pragma once

namespace impinge {

/// A star-shaped surface is met once and the choice does not matter. A socket with both sides of its wall
/// keeps the nearest, the one that faces the ball; a ball keeps the farthest, its outer skin.
enum class Layer { nearest, farthest };

/// Puts a radius (mm) into an entry that is empty (NaN) or holds that of another face. The result does
/// not depend on the order of faces.
inline void keep(double& entry, double radius, Layer layer) {
  const bool replaces = layer == Layer::nearest ? !(entry <= radius) : !(entry >= radius);
  if (replaces) entry = radius;
}

}  // namespace impinge
