// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/sinusoid.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace impinge {
namespace {

constexpr double kTurn = 2.0 * kPi;
// Radians, above 16 * 2^-53 * 2 pi: the phase, the arc cosine, their sum and its reduction to one turn are
// each right to an ulp or two of at most 4 pi. sinusoid.gappa. A rounded argument of the arc cosine counts as
// a bound that differs by the same share, for which the caller allows.
constexpr double kAngleRounding = 1.2e-14;

// Adds the span, which may begin anywhere, reduced to [0, 2 pi].
void add(AngleSpans& spans, double from, double to) {
  const double width = to - from + 2.0 * kAngleRounding;
  double start = std::fmod(from - kAngleRounding, kTurn);
  if (start < 0.0) start += kTurn;
  spans.span[spans.count++] = {start, std::min(start + width, kTurn)};
  if (start + width > kTurn) spans.span[spans.count++] = {0.0, std::min(start + width - kTurn, kTurn)};
}

}  // namespace

Vec3 turned(const Vec3& x, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * x.x() - s * x.y(), s * x.x() + c * x.y(), x.z()};
}

Eigen::Matrix3d rotation_to_z(const Vec3& axis) {
  Eigen::Matrix3d rotation;
  rotation.row(2) = axis;
  rotation.row(0) = axis.unitOrthogonal();
  rotation.row(1) = axis.cross(Vec3(rotation.row(0)));
  return rotation;
}

AngleSpans near_zero(const Sinusoid& f, double bound) {
  AngleSpans spans;
  const double height = std::hypot(f.cosine, f.sine);
  if (std::abs(f.constant) > height + bound) return spans;
  // cos(t - phase) is between `low` and `high`.
  const double high = height > 0.0 ? std::min(1.0, (bound - f.constant) / height) : 1.0;
  const double low = height > 0.0 ? std::max(-1.0, (-bound - f.constant) / height) : -1.0;
  const double phase = std::atan2(f.sine, f.cosine);
  const double from = std::acos(high);
  const double to = std::acos(low);
  add(spans, phase + from, phase + to);
  add(spans, phase - to, phase - from);
  return spans;
}

}  // namespace impinge
