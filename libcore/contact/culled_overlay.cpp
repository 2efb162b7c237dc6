// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/culled_overlay.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

#include "contact/touch_search.hpp"
#include "files/thread_team.hpp"
#include "gap/face_overlay.hpp"
#include "sphere/orientation.hpp"

namespace impinge {
namespace {

// A moved face and the tree of the other surface.
struct OverlayReach {
  const CapTree& tree;
  const FaceCap& seen;
  bool of_ball;  // the moved face is the ball's: it reaches what is no farther than it is
};

// Calls visit(item) for the items from block `at` on that may share a direction with the face and be reached
// by it, until it returns true.
template <class Visit>
bool visit_reached(const OverlayReach& reach, std::uint32_t at, const Visit& visit) {
  const CapBlock& block = reach.tree.blocks()[at];
  const double wide = reach.seen.small() ? reach.seen.cap.radius : kPi;
  for (std::size_t k = 0; k < block.nodes; ++k) {
    if (reach.of_ball ? reach.seen.range.high < block.low[k] : reach.seen.range.low > block.high[k]) continue;
    const Vec3 axis(block.x[k], block.y[k], block.z[k]);
    if ((axis - reach.seen.cap.axis).norm() > wide + block.angle[k]) continue;  // a chord is below its angle
    if (!block.leaf(k)) {
      if (visit_reached(reach, block.first[k], visit)) return true;
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
  const FaceCap seen = face_cap(moving.corner);
  moving.side = seen.side;
  const Faces& rest = surfaces_[1 - scan];
  if (rest.faces.empty()) return false;
  return visit_reached({rest.tree, seen, scan == 0}, 0, [&](std::uint32_t item) {
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
