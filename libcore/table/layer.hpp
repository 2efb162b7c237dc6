// SPDX-License-Identifier: GPL-3.0-or-later
// Which radius a table keeps where a direction meets a surface more than once.
#pragma once

namespace impinge {

/// A socket keeps the nearest, the side of its wall that faces the ball; a ball keeps the farthest, its outer
/// skin. A star-shaped surface is met once, and the choice does not matter.
enum class Layer { nearest, farthest };

/// Puts a radius (mm) into an entry that is empty (NaN) or has the radius of another face. The result does
/// not depend on the order of faces.
inline void keep(double& entry, double radius, Layer layer) {
  const bool replaces = layer == Layer::nearest ? !(entry <= radius) : !(entry >= radius);
  if (replaces) entry = radius;
}

}  // namespace impinge
