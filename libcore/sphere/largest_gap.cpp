// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/largest_gap.hpp"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace impinge {
namespace {

using Vec2 = Eigen::Vector2d;

// Entries on the seam of a map may be one direction, up to rounding.
bool is_same(const Vec3& a, const Vec3& b) { return (a - b).squaredNorm() < 1e-24; }

// The directions equally far from a and b form a circle, x = u p + v q. Those within 90 degrees of a, and no
// farther from a than from any other entry, form an arc of it or nothing. The arc goes counter-clockwise from
// one ray in the plane of (p, q) to another.
class Bisector {
 public:
  Bisector(const Vec3& a, const Vec3& b) : a_(a), u_((a - b).unitOrthogonal()), v_((a - b).cross(u_)) {
    const Vec2 inwards(a.dot(u_), a.dot(v_));
    end_ = ends_of(inwards);
    for (Vec2& end : end_) end += 1e-9 * inwards;  // opposite rays would have no certain side between them
  }

  // Takes away what is nearer to c. Returns whether anything is left.
  bool cut(const Vec3& c) {
    const Vec2 inwards((a_ - c).dot(u_), (a_ - c).dot(v_));
    const std::array<bool, 2> off{inwards.dot(end_[0]) < 0.0, inwards.dot(end_[1]) < 0.0};
    if (off[0] && off[1]) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      if (!off[k]) continue;
      met_[k] = &c;
      end_[k] = ends_of(inwards)[k];
    }
    return true;
  }

  // The entry that cut off each end of the arc, and is as far from it as a and b; or nullptr.
  const std::array<const Vec3*, 2>& met() const { return met_; }

 private:
  // The two ends of the half plane on the side of `inwards`.
  static std::array<Vec2, 2> ends_of(const Vec2& inwards) {
    return {Vec2(inwards.y(), -inwards.x()), Vec2(-inwards.y(), inwards.x())};
  }

  const Vec3& a_;
  Vec3 u_;
  Vec3 v_;
  std::array<Vec2, 2> end_;
  std::array<const Vec3*, 2> met_{};
};

}  // namespace

double largest_gap(std::span<const Vec3> entries, double z_min, double reach) {
  // Angles are compared by the squares of their chords.
  const auto chord = [](double angle) { return 4.0 * std::pow(std::sin(0.5 * std::min(angle, kPi)), 2); };
  const double chord_reach = chord(reach);
  const double chord_around = chord(2.0 * reach);
  double largest = 0.0;
  std::vector<std::pair<double, std::size_t>> around;  // entries within 2 reach of one, nearest first
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Vec3& a = entries[i];
    around.clear();
    for (std::size_t j = 0; j < entries.size(); ++j) {
      const double apart = (entries[j] - a).squaredNorm();
      if (!is_same(entries[j], a) && apart <= chord_around) around.emplace_back(apart, j);
    }
    std::ranges::sort(around);
    for (const auto& [apart, j] : around) {
      if (j < i) continue;
      const Vec3& b = entries[j];
      Bisector bisector(a, b);
      const auto cut = [&](const auto& c) {
        return is_same(entries[c.second], b) || bisector.cut(entries[c.second]);
      };
      if (!std::ranges::all_of(around, cut)) continue;
      for (const Vec3* c : bisector.met()) {
        if (!c) continue;
        const Vec3 centre = circumcentre(a, b, *c);
        const double radius = (centre - a).squaredNorm();
        if (centre.z() >= z_min && radius <= chord_reach) largest = std::max(largest, radius);
      }
    }
  }
  return 2.0 * std::asin(std::min(0.5 * std::sqrt(largest), 1.0));
}

}  // namespace impinge
