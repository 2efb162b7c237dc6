// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cap_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "sphere/vector_clones.hpp"

namespace impinge {
namespace {

// For angles up to a quarter turn (chord / angle)^2 is no less than this.
constexpr float kInverseOfQuarter = 1.0F / (1.1108F * 1.1108F);
constexpr float kLongestChord = 1.4F * 1.4F;

std::vector<CapItem> items_of(const TriangleMesh& mesh) {
  std::vector<CapItem> items;
  items.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    if (const auto item = cap_item(mesh, face)) items.push_back(*item);
  }
  return items;
}

[[gnu::flatten]] IMPINGE_VECTOR_CLONES void find_nodes(const CapBlock& block, const CapLanes& limits,
                                                       const ComparedCap& cap, FoundNodes& __restrict found) {
  std::array<std::int32_t, CapBlock::kLanes> whole;
  std::array<std::int32_t, CapBlock::kLanes> part;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    const float dx = block.x[k] - cap.x;
    const float dy = block.y[k] - cap.y;
    const float dz = block.z[k] - cap.z;
    const float square = dx * dx + dy * dy + dz * dz;  // of the chord: an angle is no less
    const float angle = block.angle[k];
    const float farthest = cap.radius + angle;
    const float room = cap.radius - angle;
    const float inside = room > 0.0F ? room * room * kInverseOfQuarter : -1.0F;
    const float convex = inside < kLongestChord ? inside : kLongestChord;
    const float narrow = angle <= cap.resolution ? HUGE_VALF : convex;
    const float reach = cap.sign * limits[k] > cap.known ? farthest * farthest : -1.0F;
    part[k] = square <= reach ? 1 << k : 0;
    whole[k] = square <= (reach < narrow ? reach : narrow) ? 1 << k : 0;
  }
  std::int32_t all = 0;
  std::int32_t some = 0;
  for (std::size_t k = 0; k < CapBlock::kLanes; ++k) {
    all |= whole[k];
    some |= part[k];
  }
  found.whole = static_cast<std::uint32_t>(all) & ((1U << block.nodes) - 1U);
  found.part = static_cast<std::uint32_t>(some & ~all) & ((1U << block.nodes) - 1U);
}

}  // namespace

CapSearch::CapSearch(const TriangleMesh& mesh, Layer layer)
    : items_(items_of(mesh)), tree_(items_), nearest_(layer == Layer::nearest) {}

float CapSearch::limit(const DirectionCap& cap, double resolution, float known) {
  cap_ = cap;
  compared_ = {static_cast<float>(cap.axis.x()),
               static_cast<float>(cap.axis.y()),
               static_cast<float>(cap.axis.z()),
               static_cast<float>(cap.radius),
               static_cast<float>(resolution),
               nearest_ ? -1.0F : 1.0F,
               known};
  limit_ = known;
  if (tree_.blocks().empty()) return limit_;
  // The node that decided the cap before may be in this one too; then the rest is soon left out.
  if (decisive_.block != 0 && (look_at(decisive_.block).whole >> decisive_.lane & 1U) != 0) take(decisive_);
  visit(0);
  return limit_;
}

FoundNodes CapSearch::look_at(std::uint32_t at) {
  const CapBlock& block = tree_.blocks()[at];
  compared_.known = compared_.sign * limit_;
  FoundNodes found;
  find_nodes(block, limits_of(block), compared_, found);
  return found;
}

void CapSearch::take(const CapNode& node) {
  const float limit = limits_of(tree_.blocks()[node.block])[node.lane];
  if (decided(limit)) return;
  limit_ = limit;
  decisive_ = node;
}

// Takes whole nodes first, since they may decide the rest.
void CapSearch::visit(std::uint32_t at) {
  const CapBlock& block = tree_.blocks()[at];
  const FoundNodes found = look_at(at);
  for (std::uint32_t left = found.whole; left != 0; left &= left - 1)
    take({at, static_cast<std::uint32_t>(std::countr_zero(left))});
  for (std::uint32_t left = found.part; left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    if (decided(limits_of(block)[k])) continue;
    if (!block.leaf(k)) {
      visit(block.first[k]);
      continue;
    }
    for (std::uint32_t i = 0; i < block.items[k]; ++i) include(items_[tree_.order()[block.first[k] + i]]);
  }
}

void CapSearch::include(const CapItem& item) {
  if ((item.cap.axis - cap_.axis).norm() > cap_.radius + item.cap.radius) return;
  if (nearest_) {
    limit_ = std::min(limit_, std::nextafter(static_cast<float>(item.range.low), 0.0F));
  } else {
    limit_ = std::max(limit_, std::nextafter(static_cast<float>(item.range.high), HUGE_VALF));
  }
}

}  // namespace impinge
