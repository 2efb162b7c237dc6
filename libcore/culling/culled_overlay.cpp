// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/culled_overlay.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "culling/face_item.hpp"
#include "culling/touch_search.hpp"
#include "detection/face_overlay.hpp"
#include "sampling/face_index.hpp"

namespace impinge {
namespace {

constexpr double kWidestLookUp = 0.1;  // radians: faces of wider caps are compared with all others

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

// Of the caps that are no wider than kWidestLookUp.
double widest_cap(const TriangleMesh& mesh) {
  double widest = 0.0;
  for (const CapItem& item : items_of_all(mesh)) {
    if (item.cap.radius <= kWidestLookUp) widest = std::max(widest, item.cap.radius);
  }
  return widest * (1.0 + kCapShare) + kCapSlack;
}

}  // namespace

CulledOverlay::CulledOverlay(const CulledJoint& joint)
    : joint_(joint),
      trees_{CapTree(items_of_all(joint.meshes().ball)), CapTree(items_of_all(joint.meshes().socket))},
      near_{NearFaces(joint.meshes().socket, widest_cap(joint.meshes().ball)),
            NearFaces(joint.meshes().ball, widest_cap(joint.meshes().socket))} {}

const TriangleMesh& CulledOverlay::moved(std::size_t scan) const {
  return scan == 0 ? joint_.meshes().ball : joint_.meshes().socket;
}

bool CulledOverlay::reaches_any(std::size_t scan, const CapMove& move, const Face& face) const {
  OverlayFace moving;
  for (std::size_t k = 0; k < 3; ++k) moving.corner[k] = move.place(corner(moved(scan), face, k));
  const FaceIndex::SeenFace seen = see_face(moving.corner);
  moving.side = seen.side;
  if (seen.side == 0) return false;
  const auto reached = [&](std::uint32_t f) {
    OverlayFace resting;
    for (std::size_t k = 0; k < 3; ++k) resting.corner[k] = corner(at_rest(scan), at_rest(scan).faces[f], k);
    const FaceIndex::SeenFace other = see_face(resting.corner);
    resting.side = other.side;
    if (other.side == 0) return false;
    if (scan == 0) return seen.range.high >= other.range.low && reaches(moving, resting);
    return seen.range.low <= other.range.high && reaches(resting, moving);
  };
  if (seen.cap.radius <= near_[scan].margin())
    return std::ranges::any_of(near_[scan].near(seen.cap.axis).faces, reached);
  std::vector<std::uint32_t> all(at_rest(scan).faces.size());
  std::iota(all.begin(), all.end(), 0U);
  return std::ranges::any_of(all, reached);
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
  return trees_[0].bytes() + trees_[1].bytes() + near_[0].bytes() + near_[1].bytes();
}

}  // namespace impinge
