// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/gap_bounds.hpp"

#include <cmath>

#include "contact/cap_lanes.hpp"
#include "sphere/vector_clones.hpp"

namespace impinge {
namespace {

using namespace lanes;

// The work on a block, once for each scan.
template <Surface kScanned>
inline void bound_lanes(const CapBlock& block, const CapMove& move, const CapLevels& levels, float enough,
                        GapBounds& __restrict bounds) {
  const MovedCaps caps = moved_lanes<kScanned>(block, move);
  const WholeLanes level = levels_of(caps.angle, levels);
  WholeLanes steps;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) steps[k] = levels.steps[level[k]];
  const WholeLanes entry = entries_of(caps, steps);
  CapLanes limit;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) limit[k] = levels.limits[entry[k]];
  constexpr bool kBall = kScanned == Surface::ball;
  WholeLanes open;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const float gap = signed_gap(kScanned, limit[k], caps.length[k]);
    const float middle = dot(move.own, block, k) + (kBall ? block.low[k] : block.high[k]);
    bounds.gap[k] = gap;
    bounds.likely[k] = signed_gap(kScanned, limit[k], middle);
    open[k] = gap > enough ? 0 : 1 << k;
  }
  std::int32_t some = 0;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) some |= open[k];
  bounds.open = static_cast<std::uint32_t>(some) & ((1U << block.nodes) - 1U);
}

[[gnu::flatten]] IMPINGE_VECTOR_CLONES void bound_ball(const CapBlock& block, const CapMove& move,
                                                       const CapLevels& levels, float enough,
                                                       GapBounds& bounds) {
  bound_lanes<Surface::ball>(block, move, levels, enough, bounds);
}

[[gnu::flatten]] IMPINGE_VECTOR_CLONES void bound_socket(const CapBlock& block, const CapMove& move,
                                                         const CapLevels& levels, float enough,
                                                         GapBounds& bounds) {
  bound_lanes<Surface::socket>(block, move, levels, enough, bounds);
}

}  // namespace

CapMove::CapMove(Surface surface, const Pose& at)
    : scanned(surface), pose(at), shift(static_cast<float>(at.translation.norm())) {
  const Vec3 in_ball_frame = at.rotation.transpose() * at.translation;
  const bool ball = scanned == Surface::ball;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto row = static_cast<std::size_t>(k);
    for (Eigen::Index l = 0; l < 3; ++l)
      rotation[row][static_cast<std::size_t>(l)] =
          static_cast<float>(ball ? at.rotation(k, l) : at.rotation(l, k));
    translation[row] = static_cast<float>(ball ? at.translation[k] : -in_ball_frame[k]);
    own[row] = static_cast<float>(ball ? in_ball_frame[k] : -at.translation[k]);
  }
}

MovedCaps moved(const CapBlock& block, const CapMove& move) {
  return move.scanned == Surface::ball ? moved_lanes<Surface::ball>(block, move)
                                       : moved_lanes<Surface::socket>(block, move);
}

GapBounds gap_bounds(const CapBlock& block, const CapMove& move, const CapLimits& limits, float enough) {
  GapBounds bounds;
  const bool ball = move.scanned == Surface::ball;
  (ball ? bound_ball : bound_socket)(block, move, limits.levels(), enough, bounds);
  return bounds;
}

}  // namespace impinge
