// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/face_cap.hpp"

#include "sphere/orientation.hpp"

namespace impinge {

FaceCap face_cap(const std::array<Vec3, 3>& corners) {
  constexpr double kRounding = 1e-12;  // as a share of lengths
  FaceCap seen;
  seen.side = orientation(corners[0], corners[1], corners[2]);
  seen.cap.axis = Vec3::Zero();
  for (const Vec3& v : corners) seen.cap.axis += v.stableNormalized();
  const double length = seen.cap.axis.norm();
  seen.cap.axis = length > 0.0 ? Vec3(seen.cap.axis / length) : Vec3::UnitZ();
  // x . axis is linear on the face and no larger than |x|, which is convex.
  for (const Vec3& v : corners) {
    seen.cap.radius = std::max(seen.cap.radius, v.isZero(0.0) ? kPi : angle_between(seen.cap.axis, v));
    seen.range.low = std::min(seen.range.low, seen.cap.axis.dot(v));
    seen.range.high = std::max(seen.range.high, v.norm());
  }
  seen.cap.radius += kCapSlack;
  seen.range.low = std::max(0.0, seen.range.low - kRounding * seen.range.high);
  seen.range.high *= 1.0 + kRounding;
  return seen;
}

}  // namespace impinge
