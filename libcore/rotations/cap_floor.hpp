// SPDX-License-Identifier: GPL-3.0-or-later
// Roughly how far a surface reaches over a whole cap of directions. Sampled, to guess where to look for a
// proof; no proof relies on it.
//
// Cube grids, one for each half octave of cap radii. The finest has the radius of the surface, and the face,
// along each of its directions; each wider one the least value of the grid before over eight directions.
#pragma once

#include <cstdint>
#include <vector>

#include "rotations/seen_surface.hpp"
#include "sphere/cube_faces.hpp"

namespace impinge {

class CapFloor {
 public:
  /// A value is the least radius of a ball (Layer::farthest), or the largest radius of a socket times -1, mm:
  /// the larger it is, the farther the surface reaches into the other one.
  explicit CapFloor(const SeenSurface& surface);

  /// The value over a cap of about `angle` radians round x; -infinity where some of it has no face.
  float within(const Vec3& x, double angle) const;
  /// Has the sample nearest to the direction of x no face?
  bool uncovered(const Vec3& x) const {
    return face_[cube_entry(x, levels_.front().cells)] == DirectionFace::kNone;
  }
  /// A face that holds the direction of unit u, found across sides from the nearest sample; or kNone.
  std::uint32_t face_along(const Vec3& u) const;

 private:
  struct Level {
    std::size_t cells;
    double radius;  // of the caps, radians
    std::vector<float> values;
    Vec3 direction(std::size_t entry) const;
  };
  void sample();
  static Level wider(const Level& level, double radius);

  const SeenSurface& surface_;
  std::vector<Level> levels_;
  std::vector<std::uint32_t> face_;  // for each direction of the finest level
};

}  // namespace impinge
