// SPDX-License-Identifier: GPL-3.0-or-later
// Roughly how far a surface reaches over a whole cap of directions: sampled, to guess where to look for a
// proof. No proof relies on it.
//
// Cube grids, one for each half octave of radii. The finest has the radius of the surface along each of its
// directions, and the face there; each wider one the least of the one before over eight directions round it.
#pragma once

#include <cstdint>
#include <vector>

#include "rotations/seen_surface.hpp"
#include "sphere/cube_faces.hpp"

namespace impinge {

class CapFloor {
 public:
  /// The values are least radii for a ball (Layer::farthest), and largest radii times -1 for a socket: the
  /// larger a value, the farther the surface reaches into the other one.
  explicit CapFloor(const SeenSurface& surface);

  /// The value over about `angle` radians round x, mm; -infinity where a part of that meets no face.
  float within(const Vec3& x, double angle) const;
  /// Has the sample nearest to x no face?
  bool uncovered(const Vec3& x) const {
    return face_[cube_entry(x, levels_.front().cells)] == DirectionFace::kNone;
  }
  /// A face that holds the direction of unit u, found across sides from the nearest sample; kNone if none is
  /// found.
  std::uint32_t face_along(const Vec3& u) const;

 private:
  struct Level {
    std::size_t cells;
    double radius;  // radians, of the caps
    std::vector<float> values;
    Vec3 direction(std::size_t entry) const;
  };
  void sample();
  static Level wider(const Level& level, double radius);

  const SeenSurface& surface_;
  std::vector<Level> levels_;
  std::vector<std::uint32_t> face_;  // of the finest level
};

}  // namespace impinge
