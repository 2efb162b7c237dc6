// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/culled_overlay.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/touch_search.hpp"
#include "files/thread_team.hpp"
#include "gap/face_overlay.hpp"
#include "sphere/orientation.hpp"
#include "sphere/vector_clones.hpp"
#include "table/face_cap.hpp"

namespace impinge {
namespace {

// Cap and radii of a moved face, in floats, for the comparison with nodes. The kNodeSlack of nodes covers the
// rounding.
struct OverlayReach {
  float x, y, z;    // axis
  float wide;       // radians; pi if the face may be seen in all directions
  float low, high;  // mm
  bool of_ball;     // it is the ball's: it reaches what is no farther than it is

  OverlayReach(const OverlayFace& face, bool of_the_ball);
};

// Chords between corners and axis give the radius of the cap without an arc cosine: an angle is 2 asin(c / 2)
// = c (1 + c^2 / 24 + ...), the terms after the first at most 0.0472 c^2 together for chords c <= 1. Then the
// sum of the three unit vectors is 1.5 long at least.
OverlayReach::OverlayReach(const OverlayFace& face, bool of_the_ball) : of_ball(of_the_ball) {
  constexpr double kNoDirection = 1e-100;  // mm; shorter corners have no certain direction
  std::array<Vec3, 3> unit;
  Vec3 axis = Vec3::Zero();
  double least = HUGE_VAL;
  double most = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = face.corner[k].norm();
    least = std::min(least, length);
    most = std::max(most, length);
    unit[k] = face.corner[k] / length;
    axis += unit[k];
  }
  const bool gathered = axis.norm() > 1.4;
  axis.normalize();
  double chord = 0.0;
  double along = HUGE_VAL;  // x . axis is linear on the face and no larger than |x|
  for (std::size_t k = 0; k < 3; ++k) {
    chord = std::max(chord, (unit[k] - axis).norm());
    along = std::min(along, face.corner[k].dot(axis));
  }
  const bool small = least > kNoDirection && gathered && chord <= 1.0;
  if (!small) axis = Vec3::UnitZ();
  x = static_cast<float>(axis.x());
  y = static_cast<float>(axis.y());
  z = static_cast<float>(axis.z());
  wide = small ? static_cast<float>(chord * (1.0 + 0.0473 * chord * chord) + kCapSlack)
               : static_cast<float>(kPi);
  low = small ? static_cast<float>(along) : 0.0F;
  high = static_cast<float>(most);
}

// A bit for each node of the block that may share a direction with the face and be reached by it.
[[gnu::flatten]] IMPINGE_VECTOR_CLONES std::uint32_t reached_nodes(const OverlayReach& reach,
                                                                   const CapBlock& block) {
  std::array<std::int32_t, CapBlock::kLanes> near;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const float dx = block.x[k] - reach.x;
    const float dy = block.y[k] - reach.y;
    const float dz = block.z[k] - reach.z;
    const float within = reach.wide + block.angle[k];  // a chord is below its angle
    const float above = reach.of_ball ? reach.high - block.low[k] : block.high[k] - reach.low;
    near[k] = ((dx * dx + dy * dy + dz * dz <= within * within) & (above >= 0.0F)) ? 1 << k : 0;
  }
  std::int32_t all = 0;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) all |= near[k];
  return static_cast<std::uint32_t>(all) & ((1U << block.nodes) - 1U);
}

// Calls visit(item) for the items from block `at` on that may share a direction with the face and be reached
// by it, until it returns true.
template <class Visit>
bool visit_reached(const OverlayReach& reach, const CapTree& tree, std::uint32_t at, const Visit& visit) {
  const CapBlock& block = tree.blocks()[at];
  for (std::uint32_t left = reached_nodes(reach, block); left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    if (!block.leaf(k)) {
      if (visit_reached(reach, tree, block.first[k], visit)) return true;
      continue;
    }
    for (std::uint32_t item = block.first[k]; item < block.first[k] + block.items[k]; ++item) {
      if (visit(item)) return true;
    }
  }
  return false;
}

}  // namespace

CulledOverlay::Faces CulledOverlay::faces_of(const TriangleMesh& mesh) {
  std::vector<CapItem> items;
  std::vector<Face> kept;
  for (const Face& face : mesh.faces) {
    const auto item = cap_item(mesh, face);
    if (!item) continue;
    items.push_back(*item);
    kept.push_back(face);
  }
  Faces found{CapTree(items), {}, {}};
  for (const std::uint32_t f : found.tree.order()) {
    const Face& face = kept[f];
    found.faces.push_back(face);
    found.sides.push_back(orientation(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
  }
  return found;
}

CulledOverlay::CulledOverlay(const BallSocketPair& joint) : joint_(joint) {
  on_threads(surfaces_.size(), [this](std::size_t k) { surfaces_[k] = faces_of(moved(k)); });
}

bool CulledOverlay::reaches_any(std::size_t scan, const CapMove& move, const Face& face) const {
  OverlayFace moving;
  for (std::size_t k = 0; k < 3; ++k) moving.corner[k] = move.place(corner(moved(scan), face, k));
  const Faces& rest = surfaces_[1 - scan];
  if (rest.faces.empty()) return false;
  bool oriented = false;
  return visit_reached(OverlayReach(moving, scan == 0), rest.tree, 0, [&](std::uint32_t item) {
    if (!oriented) moving.side = orientation(moving.corner[0], moving.corner[1], moving.corner[2]);
    oriented = true;
    OverlayFace resting;
    for (std::size_t k = 0; k < 3; ++k) resting.corner[k] = corner(at_rest(scan), rest.faces[item], k);
    resting.side = rest.sides[item];
    return scan == 0 ? reaches(moving, resting) : reaches(resting, moving);
  });
}

bool CulledOverlay::impinged(const Pose& pose) const {
  std::atomic<bool> found = false;
  on_threads(surfaces_.size(), [&](std::size_t scan) {
    const CapMove move(scan == 0 ? Surface::ball : Surface::socket, pose);
    for (const Face& face : surfaces_[scan].faces) {
      if (found) return;
      if (reaches_any(scan, move, face)) found = true;
    }
  });
  return found;
}

bool CulledOverlay::impinged(const Pose& pose, const CulledJoint& limits) const {
  const std::array<CulledScan, 2>& scans = limits.scans();
  const PosedTrees posed{PosedTree{surfaces_[0].tree, scans[0].limits(), CapMove(Surface::ball, pose)},
                         PosedTree{surfaces_[1].tree, scans[1].limits(), CapMove(Surface::socket, pose)}};
  const auto touches = [&](const ScannedItem& at) {
    return reaches_any(at.scan, posed[at.scan].move, surfaces_[at.scan].faces[at.item]);
  };
  return limits.impinged(pose) || touching_item(posed, touches);
}

std::size_t CulledOverlay::bytes() const {
  std::size_t bytes = 0;
  for (const Faces& of : surfaces_) bytes += of.tree.bytes() + of.faces.size() * (sizeof(Face) + sizeof(int));
  return bytes;
}

}  // namespace impinge
