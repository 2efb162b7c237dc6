// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cap_search.hpp"

#include <algorithm>
#include <cmath>

namespace impinge {
namespace {

constexpr double kChordOfQuarter = 1.1108;  // an angle up to a quarter turn over its chord

std::vector<CapItem> items_of(const TriangleMesh& mesh) {
  std::vector<CapItem> items;
  items.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    if (const auto item = cap_item(mesh, face)) items.push_back(*item);
  }
  return items;
}

}  // namespace

CapSearch::CapSearch(const TriangleMesh& mesh, Layer layer)
    : items_(items_of(mesh)), tree_(items_), nearest_(layer == Layer::nearest) {}

float CapSearch::limit(const DirectionCap& cap, double resolution) {
  cap_ = cap;
  resolution_ = resolution;
  limit_ = nearest_ ? HUGE_VALF : -HUGE_VALF;
  if (tree_.blocks().empty()) return limit_;
  const CapNode last = decisive_;
  if (last.block != 0)
    look_at(last);  // what decided the cap before may be in this one: the rest is soon left out
  visit(0);
  return limit_;
}

void CapSearch::visit(std::uint32_t at) {
  const CapBlock& block = tree_.blocks()[at];
  for (std::uint32_t k = 0; k < block.nodes; ++k) {
    if (look_at({at, k})) visit(block.first[k]);
  }
}

// Has it to be opened?
bool CapSearch::look_at(const CapNode& node) {
  const CapBlock& block = tree_.blocks()[node.block];
  const std::size_t k = node.lane;
  if (nearest_ ? block.low[k] >= limit_ : block.high[k] <= limit_) return false;
  const Vec3 axis(block.x[k], block.y[k], block.z[k]);
  const double chord = (axis - cap_.axis).norm();
  const double angle = block.angle[k];
  if (chord > cap_.radius + angle) return false;  // an angle is no less than its chord
  const bool inside = chord < 1.4 && kChordOfQuarter * chord + angle <= cap_.radius;
  if (inside || angle <= resolution_) {
    limit_ = nearest_ ? block.low[k] : block.high[k];
    decisive_ = node;
    return false;
  }
  if (!block.leaf(k)) return true;
  for (std::uint32_t i = 0; i < block.items[k]; ++i) include(items_[tree_.order()[block.first[k] + i]]);
  return false;
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
