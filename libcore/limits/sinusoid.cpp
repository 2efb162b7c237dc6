// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/sinusoid.hpp"

#include <algorithm>
#include <cmath>

namespace impinge {
namespace {

constexpr double kTurn = 2.0 * kPi;
constexpr double kAngleRounding = 1e-14;  // of an angle that is taken round the circle, radians

// The span, which may begin anywhere, cut where a turn begins and ends.
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

AngleSpans near_zero(const Sinusoid& f, double bound) {
  AngleSpans spans;
  const double height = std::hypot(f.cosine, f.sine);
  if (std::abs(f.constant) > height + bound) return spans;
  // cos(t - phase) is between these
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
