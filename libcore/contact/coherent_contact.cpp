// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/coherent_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sphere/infinity.hpp"

namespace impinge {
namespace {

constexpr double kKept = 1.0 - 1e-6;   // of what is to spare, for the rounding of the clock
constexpr std::size_t kFewProofs = 8;  // no beginning anew for so few more
constexpr double kLongStep = 2.0;      // mm of the clock, after which little is left of any proof

double least_radius(const CapTree& tree) {
  double least = kInfinity;
  if (tree.blocks().empty()) return least;
  const CapBlock& root = tree.blocks().front();
  for (std::size_t k = 0; k < root.nodes; ++k) least = std::min(least, static_cast<double>(root.low[k]));
  return least;
}

// o, in double.
Vec3 own_shift(Surface scanned, const Pose& pose) {
  if (scanned == Surface::socket) return -pose.translation;
  return pose.rotation.transpose() * pose.translation;
}

// When a proof is due that has so much to spare, mm and radians.
double due_after(double clock, double gap, double angle) {
  return clock + kKept * std::min(gap, CoherentContact::kLever * angle);
}

// The angle q from |R1 - R0| = 2 sqrt(2) sin(q / 2), Frobenius.
double turn_between(const Pose& a, const Pose& b) {
  const double half = (b.rotation - a.rotation).norm() / (2.0 * std::numbers::sqrt2);
  return 2.0 * std::asin(std::min(half, 1.0));
}

}  // namespace

CoherentContact::CoherentContact(const CulledJoint& joint) : joint_(joint) {
  for (std::size_t k = 0; k < 2; ++k) {
    scans_[k].culled = &joint.scans()[k];
    scans_[k].least_radius = least_radius(joint.scans()[k].tree());
  }
}

std::optional<ScannedVertex> CoherentContact::impinged(const Pose& pose) {
  if (impinging_) {
    const Surface of = impinging_->scanned;
    const Vec3& v = mesh_of(joint_.meshes(), of).vertices[impinging_->vertex];
    if (joint_.exactly_impinged(of, to_other(of, pose, v))) return impinging_;
  }
  impinging_.reset();
  // Without proofs a search that goes straight for a touch comes first: making them goes through all that is
  // open.
  if (!last_ && (impinging_ = joint_.impinged(pose))) return impinging_;
  const bool anew = !last_ || scans_[0].proofs.size() + scans_[1].proofs.size() > most_proofs_;
  const double turn = anew ? kInfinity : turn_between(*last_, pose);
  for (Scan& scan : scans_) {
    advance(scan, pose, turn);
    if (scan.clock < scan.due) continue;
    if (const auto vertex = look_at_due(scan, CapMove(scan.culled->scanned(), pose))) {
      last_.reset();
      return impinging_ = ScannedVertex{scan.culled->scanned(), *vertex};
    }
  }
  if (anew) most_proofs_ = kFewProofs + 3 * (scans_[0].proofs.size() + scans_[1].proofs.size()) / 2;
  last_ = pose;
  return std::nullopt;
}

double CoherentContact::certified_step() const {
  if (!last_) return 0.0;
  return std::max(std::min(scans_[0].due - scans_[0].clock, scans_[1].due - scans_[1].clock), 0.0);
}

void CoherentContact::advance(Scan& scan, const Pose& pose, double turn) {
  const Vec3 own = own_shift(scan.culled->scanned(), pose);
  const double way = (own - scan.own).norm();
  const double room = scan.least_radius - std::max(own.norm(), scan.own.norm());
  scan.own = own;
  const double step = room > 0.0 ? kLever * (turn + way / room) + way : kInfinity;
  if (step < kLongStep) {
    scan.clock += step;
  } else {
    begin(scan);
  }
}

void CoherentContact::begin(Scan& scan) {
  scan.clock = 0.0;
  scan.due = 0.0;
  scan.proofs.clear();
  if (!scan.culled->tree().blocks().empty()) scan.proofs.push_back({0.0, 0, 0, false, 0});
}

std::optional<std::uint32_t> CoherentContact::look_at_due(Scan& scan, const CapMove& move) const {
  scan.due = kInfinity;
  for (std::size_t k = 0; k < scan.proofs.size(); ++k) {  // new ones come at the end
    if (scan.proofs[k].due <= scan.clock) {
      Proof proof = scan.proofs[k];
      if (!proof.leaf) {
        prove_nodes(scan, move, proof);
      } else if (const auto vertex = prove_vertices(scan, move, proof)) {
        return vertex;
      }
      scan.proofs[k] = proof;
    }
    scan.due = std::min(scan.due, scan.proofs[k].due);
  }
  return std::nullopt;
}

// Opens what is not clear: it is due now.
void CoherentContact::prove_nodes(Scan& scan, const CapMove& move, Proof& proof) {
  const CapBlock& block = scan.culled->tree().blocks()[proof.block];
  const GapBounds bounds = gap_bounds(block, move, scan.culled->limits(), {0.0F, true});
  proof.due = kInfinity;
  for (std::uint32_t lane = 0; lane < block.nodes; ++lane) {
    if (((proof.open >> lane) & 1U) != 0) continue;
    if (bounds.gap[lane] > 0.0F) {
      proof.due = std::min(proof.due, due_after(scan.clock, bounds.gap[lane], bounds.spare[lane]));
    } else {
      proof.open |= 1U << lane;
      const bool leaf = block.leaf(lane);
      scan.proofs.push_back({scan.clock, leaf ? proof.block : block.first[lane], 0, leaf, lane});
    }
  }
}

std::optional<std::uint32_t> CoherentContact::prove_vertices(Scan& scan, const CapMove& move,
                                                             Proof& proof) const {
  const CulledScan& culled = *scan.culled;
  const CapBlock& block = culled.tree().blocks()[proof.block];
  proof.due = kInfinity;
  for (std::uint32_t k = 0; k < block.items[proof.lane]; ++k) {
    const std::uint32_t item = block.first[proof.lane] + k;
    const Vec3 x = move.place(culled.position(item));
    const CapLimits::Limit limit = culled.limits().within(x, x.isZero(0.0) ? HUGE_VALF : 0.0F);
    const double gap = signed_gap(culled.scanned(), static_cast<double>(limit.radius), x.norm());
    if (gap > 0.0) {
      proof.due = std::min(proof.due, due_after(scan.clock, gap, limit.reach));
      continue;
    }
    proof.due = scan.clock;
    const auto beside = static_cast<double>(culled.limits().beside(x));
    if (signed_gap(culled.scanned(), beside, x.norm()) > 0.0) continue;
    if (joint_.exactly_impinged(culled.scanned(), x)) return culled.vertex(item);
  }
  return std::nullopt;
}

}  // namespace impinge
