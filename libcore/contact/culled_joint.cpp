// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/culled_joint.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "contact/gap_bounds.hpp"
#include "contact/touch_search.hpp"
#include "files/thread_team.hpp"
#include "gap/exact_side.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

// Searches both scans in depth, of each block the node first that may hold the smallest gap. A heap would
// open a few nodes less, and take longer than all else.
class LeastGapSearch {
 public:
  LeastGapSearch(const CulledJoint& joint, const Pose& pose)
      : joint_(joint), moves_{CapMove(Surface::ball, pose), CapMove(Surface::socket, pose)} {}

  std::optional<LeastGap> run() {
    for (std::uint32_t scan = 0; scan < 2; ++scan) {
      if (!joint_.scans()[scan].tree().blocks().empty()) add(scan, 0);
    }
    while (count_ > 0) {
      const Pending next = pending_[--count_];
      if (!(next.gap > limit())) open(next);
    }
    return best_;
  }

 private:
  struct Pending {
    float gap;
    std::uint32_t scan;
    CapNode node;
  };

  double limit() const { return best_ ? best_->gap_mm : kInfinity; }

  void add(std::uint32_t scan, std::uint32_t at) {
    const CulledScan& culled = joint_.scans()[scan];
    const float enough = std::nextafter(static_cast<float>(limit()), HUGE_VALF);
    const GapBounds bounds = gap_bounds(culled.tree().blocks()[at], moves_[scan], culled.limits(), enough);
    const std::size_t first = count_;
    for (std::uint32_t open = bounds.open; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(open));
      const float gap = bounds.gap[lane];
      if (gap == HUGE_VALF) continue;
      std::size_t place = count_++;  // sorted by insertion, the least gap last
      for (; place > first && pending_[place - 1].gap < gap; --place) pending_[place] = pending_[place - 1];
      pending_[place] = {gap, scan, {at, lane}};
    }
  }

  void open(const Pending& next) {
    const CulledScan& scan = joint_.scans()[next.scan];
    const CapBlock& block = scan.tree().blocks()[next.node.block];
    const std::uint32_t first = block.first[next.node.lane];
    if (!block.leaf(next.node.lane)) return add(next.scan, first);
    for (std::uint32_t k = 0; k < block.items[next.node.lane]; ++k) ask(scan, moves_[next.scan], first + k);
  }

  void ask(const CulledScan& scan, const CapMove& move, std::size_t item) {
    const Vec3 x = move.place(scan.position(item));
    if (joint_.gap_bound(scan.scanned(), x) > limit()) return;
    const double gap = joint_.gap(scan.scanned(), x);
    const ScannedVertex at{scan.scanned(), scan.vertex(item)};
    const bool earlier = best_ && gap == best_->gap_mm && before(at, best_->at);
    if (gap < limit() || earlier) best_ = LeastGap{gap, at};
  }

  static bool before(const ScannedVertex& a, const ScannedVertex& b) {
    if (a.scanned != b.scanned) return a.scanned == Surface::ball;
    return a.vertex < b.vertex;
  }

  const CulledJoint& joint_;
  std::array<CapMove, 2> moves_;
  std::array<Pending, 2 * CapTree::kMostPending> pending_;  // a stack
  std::size_t count_ = 0;
  std::optional<LeastGap> best_;
};

}  // namespace

// The parts that take time to make, one thread for each surface.
struct CulledJoint::Parts {
  explicit Parts(const BallSocketPair& joint) {
    on_threads(kSurfaces.size(), [&](std::size_t k) {
      const TriangleMesh& mesh = mesh_of(joint, kSurfaces[k]);
      scans[k].emplace(kSurfaces[k], mesh, mesh_of(joint, other(kSurfaces[k])));
      faces[k].emplace(mesh, 0.0);
    });
  }
  std::array<std::optional<CulledScan>, 2> scans;
  std::array<std::optional<NearFaces>, 2> faces;
};

CulledJoint::CulledJoint(const BallSocketPair& joint) : CulledJoint(joint, Parts(joint)) {}
CulledJoint::CulledJoint(const BallSocketPair& joint, Parts&& parts)
    : joint_(joint),
      ball_(std::move(*parts.faces[0])),
      socket_(std::move(*parts.faces[1])),
      scans_{std::move(*parts.scans[0]), std::move(*parts.scans[1])} {}

bool CulledJoint::exactly_impinged(Surface scanned, const Vec3& x) const {
  return impinge::exactly_impinged(scanned, faces(other(scanned)), x);
}

std::optional<ScannedVertex> CulledJoint::impinged(const Pose& pose) const {
  const PosedTrees posed{PosedTree{scans_[0].tree(), scans_[0].limits(), CapMove(Surface::ball, pose)},
                         PosedTree{scans_[1].tree(), scans_[1].limits(), CapMove(Surface::socket, pose)}};
  const auto touches = [&](const ScannedItem& at) {
    const CulledScan& scan = scans_[at.scan];
    return exactly_impinged(scan.scanned(), posed[at.scan].move.place(scan.position(at.item)));
  };
  const auto found = touching_item(posed, touches);
  if (!found) return std::nullopt;
  return ScannedVertex{scans_[found->scan].scanned(), scans_[found->scan].vertex(found->item)};
}

std::optional<LeastGap> CulledJoint::least_gap(const Pose& pose) const {
  return LeastGapSearch(*this, pose).run();
}

double CulledJoint::gap(Surface scanned, const Vec3& x) const {
  if (x.isZero(0.0)) return kNoSurface;
  const Surface facing = other(scanned);
  return signed_gap(scanned, faces(facing).radius(x.normalized(), facing_layer(facing)), x.norm());
}

double CulledJoint::gap_bound(Surface scanned, const Vec3& x) const {
  const Surface facing = other(scanned);
  const double length = x.norm();
  if (length == 0.0) return -kInfinity;
  return signed_gap(scanned, faces(facing).radius_bound(x / length, facing_layer(facing)), length);
}

std::size_t CulledJoint::bytes() const {
  return ball_.bytes() + socket_.bytes() + scans_[0].bytes() + scans_[1].bytes();
}

}  // namespace impinge
