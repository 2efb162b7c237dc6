// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/patch_error.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/infinity.hpp"

namespace impinge {
namespace {

// See the roundings in the header.
constexpr double kRadiiInBound = 4.0;  // each off by the doubt of a plane
constexpr double kOwnRounding = 1.0 + 500.0 * 0x1p-53;

// The corners at both ends of the sides of a rectangle in one direction.
std::array<std::array<std::size_t, 2>, 2> sides(std::size_t k) {
  if (k == 0) return {{{0, 1}, {2, 3}}};
  return {{{0, 2}, {1, 3}}};
}

double square(double x) { return x * x; }

struct Interval {
  double low = kInfinity;
  double high = -kInfinity;
  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

Interval values(const PatchView& view) {
  Interval all;
  for (const CornerSample& corner : view.corner) {
    if (!std::isnan(corner.value)) all.include(corner.value);
  }
  const double bend = (view.motion.bend[0] + view.motion.bend[1]) * (view.largest_tap - view.least_tap) / 8.0;
  all.low -= bend;
  all.high += bend;
  return all;
}

Interval lengths(const PatchView& view) {
  Interval all;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& x : view.point) {
    all.include(x.norm());
    middle += 0.25 * x;
  }
  // The point of the flat patch nearest to the centre may lie between the corners.
  double spread = 0.0;
  for (const Vec3& x : view.point) spread = std::max(spread, (x - middle).norm());
  all.low = std::min(all.low, std::max(middle.norm() - spread, 0.0));
  return all;
}

// |v . x'| over the rectangle along one coordinate; x' is the derivative times the width.
class Rate {
 public:
  Rate(const PatchView& view, std::size_t k) : inset_(view.inset[k]) {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [from, to] = sides(k)[i];
      chord_[i] = view.point[to] - view.point[from];
    }
    if (view.flat) {
      most_ = std::max(chord_[0].norm(), chord_[1].norm());
      return;
    }
    const PatchMotion& m = view.motion;
    most_ = m.way[k];
    change_ = m.turn[k] + square(m.way[k]) + m.kink[0] + m.kink[1];
    aside_ = 0.5 * (m.turn[k] + square(m.way[k])) + 0.25 * (m.turn[1 - k] + square(m.way[1 - k])) +
             m.kink[0] + m.kink[1];
  }
  // Its largest value.
  double along(const Vec3& v) const {
    const double length = v.norm();
    const double chord = std::max(std::abs(v.dot(chord_[0])), std::abs(v.dot(chord_[1])));
    return std::min(chord + length * aside_, length * most_) * (1.0 + 2.0 * inset_);
  }
  // Upper bound on its sum over all places of one line where v . x changes its sign, by Theorem 2 (table).
  double crossings(const Vec3& v) const { return std::max(along(v), v.norm() * change_); }

 private:
  std::array<Vec3, 2> chord_;
  double most_;
  double change_ = 0.0;  // of x' along a line
  double aside_ = 0.0;
  double inset_;
};

}  // namespace

PatchError::LayerRange PatchError::find_layer(const PatchView& view, const std::array<double, 4>& radius) {
  surface_.faces_near(view.cap, faces_);
  ranges_.clear();
  for (const std::uint32_t f : faces_) ranges_.push_back(range_within(surface_.plane(f), view.cap));
  const double way = view.motion.way[0] + view.motion.way[1];
  LayerRange layer{};
  for (int pass = 0; pass < 2; ++pass) {
    layer = {0.0, kInfinity, 0.0, kPlaneRoundings};
    for (const PlaneRange& range : ranges_) layer.slope = std::max(layer.slope, range.slope);
    for (const std::uint32_t f : faces_) layer.doubt = std::max(layer.doubt, surface_.plane(f).doubt);
    const double most = std::exp(std::min(layer.slope * way, 700.0)) * (1.0 + layer.doubt + kDirectionSlack);
    for (const double r : radius) {
      if (std::isnan(r)) continue;
      layer.low = std::max(layer.low, r / most);
      layer.high = std::min(layer.high, r * most);
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      if (ranges_[k].least > layer.high || ranges_[k].largest < layer.low) continue;
      faces_[kept] = faces_[k];
      ranges_[kept++] = ranges_[k];
    }
    faces_.resize(kept);
    ranges_.resize(kept);
  }
  double largest = 0.0;
  double least = kInfinity;
  layer.doubt = kPlaneRoundings;
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    largest = std::max(largest, ranges_[k].largest);
    least = std::min(least, ranges_[k].least);
    layer.doubt = std::max(layer.doubt, surface_.plane(faces_[k]).doubt);
  }
  layer.low = std::max(layer.low, least);
  layer.high = std::min(layer.high, largest);
  return layer;
}

bool PatchError::has_overlap() const {
  return std::ranges::any_of(faces_, [this](std::uint32_t f) {
    return std::ranges::any_of(surface_.overlaps_of(f), [this](std::uint32_t other) {
      return std::ranges::find(faces_, other) != faces_.end();
    });
  });
}

std::array<double, 2> PatchError::remainders(const PatchView& view, const LayerRange& layer) const {
  const PatchMotion& motion = view.motion;
  std::array<double, 2> sum{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Rate rate(view, k);
    double bend = 0.0;
    double jumps = view.flat ? 0.0 : layer.high * layer.slope * motion.kink[k];
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const SurfacePlane& plane = surface_.plane(faces_[f]);
      if (!view.flat) {
        const double r = std::min(ranges_[f].largest, layer.high);
        bend = std::max(bend, 2.0 * r * square(r * rate.along(plane.inverse)) + r * square(motion.way[k]) +
                                  r * ranges_[f].slope * motion.turn[k]);
      }
      for (const std::uint32_t number : surface_.kinks_of(faces_[f])) {
        const SurfaceKink& kink = surface_.kink(number);
        if (kink.least_radius > layer.high || kink.largest_radius < layer.low || !meets(kink, view.cap))
          continue;
        const double r = view.flat ? 1.0 : std::min(kink.largest_radius, layer.high);
        jumps += r * r * rate.crossings(kink.jump);
      }
    }
    sum[k] = bend / 8.0 + jumps / 4.0 + motion.bend[k] * (view.largest_tap - view.least_tap) / 8.0;
  }
  return sum;
}

double PatchError::first_order(const PatchView& view, const LayerRange& layer) const {
  Interval value = values(view);
  if (view.flat) {
    const Interval length = lengths(view);
    value = {length.low / value.high, length.high / value.low};
  }
  return std::max(value.high - layer.low, layer.high - value.low);
}

// The value changes along a line by no more than it does between corners.
double PatchError::rounding(const PatchView& view, const LayerRange& layer) const {
  double sum = layer.high * (kRadiiInBound * layer.doubt + layer.slope * doubt_);
  for (std::size_t k = 0; k < 2; ++k) {
    double change = view.motion.bend[k] * (view.largest_tap - view.least_tap);
    for (const auto& [from, to] : sides(k)) {
      const double here = std::abs(view.corner[to].value - view.corner[from].value);
      if (!std::isnan(here)) change = std::max(change, here);
    }
    const double scale = view.flat ? square(layer.high) / lengths(view).low : 1.0;
    sum += 4.0 * view.inset[k] * (scale * change + layer.high * layer.slope * view.motion.way[k]);
  }
  return sum;
}

PatchBound PatchError::operator()(const PatchView& view) {
  std::array<double, 4> radius{};
  double at_corners = 0.0;
  bool known = true;
  for (std::size_t k = 0; k < 4; ++k) {
    const CornerSample& corner = view.corner[k];
    radius[k] = std::nan("");
    if (std::isnan(corner.value)) continue;
    radius[k] = view.flat ? view.point[k].norm() / corner.truth : corner.truth;
    known = known && !std::isnan(corner.truth);
    at_corners = std::max(at_corners, std::abs(corner.value - corner.truth));
  }
  const LayerRange layer = find_layer(view, radius);
  const double first = first_order(view, layer);
  const double doubt = rounding(view, layer);
  PatchBound result{(first + doubt) * kOwnRounding, view.motion.way[0] >= view.motion.way[1] ? 0U : 1U,
                    !known};
  if (!known || !view.motion.smooth || !std::isfinite(layer.slope) || has_overlap()) return result;
  const std::array<double, 2> rest = remainders(view, layer);
  double scale = 1.0;
  if (view.flat) {
    const Interval length = lengths(view);
    scale = layer.high * (length.high / values(view).low) / length.low;
  }
  const double second = scale * (at_corners + rest[0] + rest[1]);
  if (second < first)
    result = {(second + doubt) * kOwnRounding, rest[0] >= rest[1] ? 0U : 1U, second <= doubt};
  return result;
}

}  // namespace impinge
