// SPDX-License-Identifier: GPL-3.0-or-later
// What the two halves of CellSearch have in common: cell_test.cpp, which decides about whole cells, and
// cell_parts.cpp, which takes open ones apart.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rotations/cap_search.hpp"
#include "rotations/cell_test.hpp"

namespace impinge {

/// The square round a cap, on the plane across its axis.
struct CapSquare {
  CapSquare(const Vec3& along, const CapAngle& angle)
      : axis(along), half(angle.tangent), across(axis.unitOrthogonal()), up(axis.cross(across)) {}
  void clip(DirectionPolygon& polygon) const {
    for (const Vec3& side : {across, up}) {
      polygon.clip(half * axis + side, -kSideSlack);
      polygon.clip(half * axis - side, -kSideSlack);
    }
  }
  Vec3 axis;
  double half;      // of a side's length
  Vec3 across, up;  // unit vectors along the sides
};

// A question for faces that come near a cap and are, somewhere, at least `least` from the centre.
struct NearCap {
  Eigen::Vector3f axis;
  float radius;  // radians
  float least;   // mm
};

// Which nodes of a block may hold such faces? In floats, for which the slack of nodes allows.
inline std::array<std::int32_t, CapBlock::kLanes> near_nodes(const CapBlock& block, const NearCap& cap) {
  std::array<std::int32_t, CapBlock::kLanes> near;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const float x = block.x[k] - cap.axis.x();
    const float y = block.y[k] - cap.axis.y();
    const float z = block.z[k] - cap.axis.z();
    const float room = cap.radius + block.angle[k];
    const bool is = x * x + y * y + z * z <= room * room;
    near[k] = static_cast<std::int32_t>(is) & static_cast<std::int32_t>(block.high[k] >= cap.least);
  }
  return near;
}

// Calls found(face) for faces of a tree that come near the cap until it is true; returns whether it was.
template <class Found>
bool any_near(const CapTree& faces, const NearCap& cap, const Found& found) {
  PendingBlocks pending;
  pending.push(0);
  while (pending.count > 0) {
    const CapBlock& block = faces.blocks()[pending.pop()];
    const auto may_hold = near_nodes(block, cap);
    for (std::size_t k = 0; k < block.nodes; ++k) {
      if (may_hold[k] == 0) continue;
      if (!block.leaf(k)) pending.push(block.first[k]);
      for (std::uint32_t f = block.first[k]; f < block.first[k] + block.items[k]; ++f)
        if (found(f)) return true;
    }
  }
  return false;
}

// Calls found(face) for faces of the socket that the ball may reach until it is true; returns whether it was.
template <class Found>
bool CellSearch::any_socket_face(const Asked& asked, const Found& found) const {
  const CapLimits& farthest = test_.side(Surface::ball).limits;
  const double turn = asked.angle.radius + asked.aside + kTurnSlack;
  const double nearer = asked.shift + asked.offset.norm();
  const auto depth_of = [&](const CapBlock& block, std::size_t k) {
    const float wide = std::nextafter(block.angle[k] + static_cast<float>(turn), HUGE_VALF);
    const double most = test_.edge_on_ ? HUGE_VAL : farthest.within(asked.inverse * axis_of(block, k), wide);
    return most + nearer - block.low[k];
  };
  return search_deepest(test_.surface(Surface::socket).face_tree(), SIZE_MAX, depth_of, found);
}

// Calls found(cap round a hole of the ball, face of the socket) where these may meet until it is true;
// returns whether it was.
template <class Found>
bool CellSearch::any_hole(const Asked& asked, const Found& found) const {
  const MeshHoles& holes = test_.side(Surface::ball).holes;
  const SeenSurface& socket = test_.surface(Surface::socket);
  if (holes.tree.blocks().empty()) return false;
  const double turn = asked.hole + asked.aside;
  const auto meet = [&](std::uint32_t hole, std::uint32_t f) {
    const DirectionCap& cap = holes.caps[hole];
    DirectionFace room;
    const DirectionFace& face = seen_face(asked, f, room);
    return near(face, {asked.rotation * cap.axis, cap.radius + asked.hole}) && found(cap, face);
  };
  const auto visit = [&](const auto& self, std::uint32_t hole, std::size_t lane, std::uint32_t at) -> bool {
    const CapBlock& of = holes.tree.blocks()[hole];
    const CapBlock& block = socket.face_tree().blocks()[at];
    const Vec3 axis = asked.rotation * axis_of(of, lane);
    for (std::size_t k = 0; k < block.nodes; ++k) {
      if ((axis - axis_of(block, k)).norm() > of.angle[lane] + block.angle[k] + turn) continue;
      if (!of.leaf(lane)) {
        for (std::size_t l = 0; l < holes.tree.blocks()[of.first[lane]].nodes; ++l)
          if (self(self, of.first[lane], l, at)) return true;
        return false;  // the children of the hole were compared with all of the block
      }
      if (!block.leaf(k) && self(self, hole, lane, block.first[k])) return true;
      for (std::uint32_t f = block.first[k]; f < block.first[k] + block.items[k]; ++f)
        for (std::uint32_t h = of.first[lane]; h < of.first[lane] + of.items[lane]; ++h)
          if (meet(h, f)) return true;
    }
    return false;
  };
  for (std::size_t lane = 0; lane < holes.tree.blocks()[0].nodes; ++lane)
    if (visit(visit, 0, lane, 0)) return true;
  return false;
}

// A cell that is taken apart: what is left of it, in which nothing is known yet.
struct CellSearch::Parted {
  Asked asked;
  CellFrame frame;
  double enough;  // the least share of all rotations that is worth to be found free
  CellPart part{};
  CellPolytope left{};
  std::vector<CellPlane> planes{};  // planes that bound `left`
  std::size_t pairs = 0;            // pairs of faces that needed planes
  CapAngle about{0.0};              // about a face's axis: directions that a face of the socket may come to

  bool clip(const CellPlane& plane) {
    planes.push_back(plane);
    return left.clip(plane, static_cast<std::uint32_t>(5 + planes.size()));
  }
  bool keep(const FormOverCell& form) {
    return left.depth_below(form) == 0.0 || (clip(form.plane()) && !left.empty());
  }
};

}  // namespace impinge
