// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "rotations/volume.hpp"

namespace impinge {
namespace {

// Radians. A gap as narrow as this between neighbouring cells, which only rounding makes, counts as free:
// whole cells are decided for rotations up to 1e-9 rad beyond them. The ends, which may be those of parts,
// are moved in by as much.
constexpr double kJoined = 1e-10;

Quaternion4 quaternion(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

// A turn: at the half angle h its quaternion is q(h) = cos h from + sin h across.
struct HalfTurn {
  Quaternion4 from;
  Quaternion4 across;
};
struct HalfAngles {
  double low;
  double high;
  bool empty() const { return !(low <= high); }
  // Keeps the half angles h with n . q(h) >= 0: one span, since h is in [0, pi / 2].
  void keep(const HalfTurn& turn, const Quaternion4& n) {
    const double cosine = n.dot(turn.from);
    const double sine = n.dot(turn.across);
    if (std::abs(cosine) + std::abs(sine) < kJoined) return;  // the turn runs along this side
    const double phase = std::atan2(sine, cosine);
    low = std::max(low, phase - 0.5 * kPi - kJoined);
    high = std::min(high, phase + 0.5 * kPi + kJoined);
  }
};

// The half angles at which the quaternion, times sign, is in the cell.
HalfAngles within(const RotationCell& cell, const HalfTurn& turn, double sign, double largest) {
  HalfAngles found{0.0, largest};
  const auto cube = static_cast<Eigen::Index>(cell.number >> (3 * cell.level));
  const Quaternion4 low = point_of(cell, {-1.0, -1.0, -1.0});
  const Quaternion4 high = point_of(cell, {1.0, 1.0, 1.0});
  found.keep(turn, sign * Quaternion4::Unit(cube));
  for (Eigen::Index k = 0; k < 4 && !found.empty(); ++k) {
    if (k == cube) continue;
    found.keep(turn, sign * (Quaternion4::Unit(k) - low[k] * Quaternion4::Unit(cube)));
    found.keep(turn, sign * (high[k] * Quaternion4::Unit(cube) - Quaternion4::Unit(k)));
  }
  return found;
}

struct CellOnWay {
  HalfAngles angles;
  VolumeCell cell;
  void add_parts(const HalfTurn& way, double sign, std::vector<CellOnWay>& met) const;
};

// Adds the spans of the turn that are in free or blocked parts of an open cell.
void CellOnWay::add_parts(const HalfTurn& way, double sign, std::vector<CellOnWay>& met) const {
  if (cell.part == nullptr) return;
  const CellFrame frame(cell.cell);
  const auto add = [&](CellState state, std::span<const CellPlane> planes) {
    CellOnWay part{angles, cell};
    part.cell.state = state;
    for (const CellPlane& plane : planes) part.angles.keep(way, sign * plane.normal(frame));
    if (!planes.empty() && !part.angles.empty()) met.push_back(part);
  };
  add(CellState::free, cell.part->free);
  for (std::size_t k = 0; k < cell.part->blocked.size(); ++k)
    add(CellState::blocked, std::span(cell.part->blocked).subspan(k, 1));
}

}  // namespace

VolumeLimit MotionVolume::limit(const JointTurn& turn, double largest_deg) const {
  if (!(largest_deg > 0.0 && largest_deg <= 180.0))
    throw std::invalid_argument("motion volume: the largest angle of a motion must be above 0 and up to 180");
  const Eigen::Quaterniond outer(turn.outer);
  const Eigen::Quaterniond inner(turn.inner);
  const Eigen::Quaterniond half(0.0, turn.axis.x(), turn.axis.y(), turn.axis.z());
  const HalfTurn way{quaternion(outer * inner), quaternion(outer * half * inner)};
  const double largest = 0.5 * largest_deg * kDegree;
  std::vector<CellOnWay> met;
  const auto visit = [&](const auto& self, const RotationCell& cell, std::uint32_t node,
                         double sign) -> void {
    const HalfAngles angles = within(cell, way, sign, largest);
    if (angles.empty()) return;
    if (nodes_[node].first == 0) {
      const CellOnWay at{angles, leaf(cell, node)};
      met.push_back(at);
      at.add_parts(way, sign, met);
    }
    for (std::uint32_t k = 0; k < 8 && nodes_[node].first != 0; ++k)
      self(self, child(cell, k), nodes_[node].first + k, sign);
  };
  for (std::uint32_t cube = 0; cube < 4; ++cube) {
    for (const double sign : {1.0, -1.0}) visit(visit, {0, cube}, cube, sign);
  }
  std::ranges::stable_sort(met, {}, [](const CellOnWay& at) { return at.angles.low; });
  VolumeLimit found;
  double free = 0.0;
  for (const CellOnWay& at : met) {
    if (at.cell.state == CellState::free && at.angles.low <= free + kJoined)
      free = std::max(free, at.angles.high);
    if (at.cell.state == CellState::blocked && !found.high_deg)
      found.high_deg =
          at.angles.low > 0.0 ? std::min(2.0 * (at.angles.low + 2.0 * kJoined) / kDegree, largest_deg) : 0.0;
  }
  found.low_deg = free < largest ? 2.0 * std::max(0.0, free - 2.0 * kJoined) / kDegree : largest_deg;
  // The finest cell there, but for one that the way leaves there by a part that is free.
  const Quaternion4 q = std::cos(free) * way.from + std::sin(free) * way.across;
  const auto rank = [&](const VolumeCell& cell) {
    return std::pair(cell.part == nullptr || !cell.part->is_free(CellFrame(cell.cell).place(q)),
                     cell.cell.level);
  };
  for (const CellOnWay& at : met) {
    const bool here = at.angles.low <= free + 2.0 * kJoined && at.angles.high >= free - 2.0 * kJoined;
    if (free < largest && here && at.cell.state != CellState::free &&
        (!found.stops || rank(*found.stops) < rank(at.cell)))
      found.stops = at.cell;
  }
  return found;
}

}  // namespace impinge
