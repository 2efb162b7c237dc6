// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/surface_kink.hpp"

#include <algorithm>
#include <cmath>

#include "table/surface_plane.hpp"

namespace impinge {

std::optional<SurfaceKink> surface_kink(const Vec3& from, const Vec3& to, const Vec3& jump) {
  if (from.cross(to).squaredNorm() == 0.0) return std::nullopt;
  const Vec3 across = edge_normal(from, to);
  const double nearest = std::min(from.norm(), to.norm());
  const double line_distance = across.isZero(0.0) ? std::max(nearest - (to - from).norm(), 0.0)
                                                  : from.cross(to - from).norm() / (to - from).norm();
  return SurfaceKink{across,
                     from.normalized(),
                     to.normalized(),
                     jump,
                     line_distance * (1.0 - kDirectionSlack),
                     std::max(from.norm(), to.norm()) * (1.0 + kDirectionSlack)};
}

bool meets(const SurfaceKink& kink, const DirectionCap& cap) {
  if (cap.radius >= 0.5 * kPi) return true;
  const double sine = std::sin(cap.radius) + kDirectionSlack;
  if (std::abs(kink.across.dot(cap.axis)) > sine) return false;
  const double cosine = std::cos(cap.radius) - kDirectionSlack;
  if (kink.from.dot(cap.axis) >= cosine || kink.to.dot(cap.axis) >= cosine) return true;
  // Is the point of the great circle nearest to the axis between the ends?
  return kink.across.cross(kink.from).dot(cap.axis) >= -kDirectionSlack &&
         kink.across.cross(kink.to).dot(cap.axis) <= kDirectionSlack;
}

}  // namespace impinge
