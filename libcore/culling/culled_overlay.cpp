// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/culled_overlay.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "culling/face_item.hpp"
#include "culling/touch_search.hpp"
#include "detection/face_overlay.hpp"
#include "sampling/face_index.hpp"
#include "sphere/orientation.hpp"

namespace impinge {
namespace {

// One that is edge-on at rest may not be so where rounding moves it: it is always asked.
std::vector<CapItem> items_of_all(const TriangleMesh& mesh) {
  std::vector<CapItem> items;
  items.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    const auto item = face_item(mesh, face);
    const double high =
        std::max({corner(mesh, face, 0).norm(), corner(mesh, face, 1).norm(), corner(mesh, face, 2).norm()});
    items.push_back(item ? *item : CapItem{{Vec3::UnitZ(), kPi}, {0.0, high}});
  }
  return items;
}

// A moved face and the tree of the other surface.
struct OverlayReach {
  const CapTree& tree;
  const FaceIndex::SeenFace& seen;
  bool of_ball;  // that is moved: it reaches what is no farther than it is
};

// Calls visit(item) for the items from block `at` on that may share a direction with the face and be reached
// by it, until it returns true.
template <class Visit>
bool visit_reached(const OverlayReach& reach, std::uint32_t at, const Visit& visit) {
  const CapBlock& block = reach.tree.blocks()[at];
  const double wide = reach.seen.cap.radius < 0.5 * kPi ? reach.seen.cap.radius : kPi;
  for (std::size_t k = 0; k < block.nodes; ++k) {
    if (reach.of_ball ? reach.seen.range.high < block.low[k] : reach.seen.range.low > block.high[k]) continue;
    const Vec3 axis(block.x[k], block.y[k], block.z[k]);
    if ((axis - reach.seen.cap.axis).norm() > wide + block.angle[k]) continue;  // no longer than the angle
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

// Orientations of the corners, in the order of the tree: exact ones take their time where a face is edge-on.
std::vector<int> sides_of(const TriangleMesh& mesh, const CapTree& tree) {
  std::vector<int> sides;
  sides.reserve(mesh.faces.size());
  for (const std::uint32_t f : tree.order()) {
    const Face& face = mesh.faces[f];
    sides.push_back(orientation(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
  }
  return sides;
}

}  // namespace

CulledOverlay::CulledOverlay(const CulledJoint& joint)
    : joint_(joint),
      trees_{CapTree(items_of_all(joint.meshes().ball)), CapTree(items_of_all(joint.meshes().socket))},
      sides_{sides_of(joint.meshes().ball, trees_[0]), sides_of(joint.meshes().socket, trees_[1])} {}

const TriangleMesh& CulledOverlay::moved(std::size_t scan) const {
  return scan == 0 ? joint_.meshes().ball : joint_.meshes().socket;
}

bool CulledOverlay::reaches_any(std::size_t scan, const CapMove& move, const Face& face) const {
  OverlayFace moving;
  for (std::size_t k = 0; k < 3; ++k) moving.corner[k] = move.place(corner(moved(scan), face, k));
  const FaceIndex::SeenFace seen = see_face(moving.corner);
  moving.side = seen.side;
  if (seen.side == 0) return false;
  const CapTree& tree = trees_[1 - scan];
  if (tree.blocks().empty()) return false;
  return visit_reached({tree, seen, scan == 0}, 0, [&](std::uint32_t item) {
    if (sides_[1 - scan][item] == 0) return false;
    OverlayFace resting;
    const Face& other = at_rest(scan).faces[tree.order()[item]];
    for (std::size_t k = 0; k < 3; ++k) resting.corner[k] = corner(at_rest(scan), other, k);
    resting.side = sides_[1 - scan][item];
    return scan == 0 ? reaches(moving, resting) : reaches(resting, moving);
  });
}

bool CulledOverlay::impinged(const Pose& pose) const {
  const std::array<CulledScan, 2>& scans = joint_.scans();
  const PosedTrees posed{PosedTree{trees_[0], scans[0].limits(), CapMove(ScannedSurface::ball, pose)},
                         PosedTree{trees_[1], scans[1].limits(), CapMove(ScannedSurface::socket, pose)}};
  const auto touches = [&](const ScannedItem& at) {
    const Face& face = moved(at.scan).faces[trees_[at.scan].order()[at.item]];
    return reaches_any(at.scan, posed[at.scan].move, face);
  };
  return joint_.impinged(pose) || touching_item(posed, ItemQuestion(touches));
}

std::size_t CulledOverlay::bytes() const {
  return trees_[0].bytes() + trees_[1].bytes() + sides_[0].size() + sides_[1].size();
}

}  // namespace impinge
