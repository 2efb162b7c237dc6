// SPDX-License-Identifier: GPL-3.0-or-later
// Curves r = a + b cos(phi) with b ever nearer to a, up to the cusp and beyond.
#include "curves/conchoid.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "sphere/direction.hpp"
#include "stress/family.hpp"
#include "stress/precise_conchoid.hpp"

namespace impinge::lab {
namespace {

// Thresholds on relative errors in units of u. a, b and phi count as exact, so each condition is 1: a formula
// must not lose digits where a and b are alike. The counted roundings are
// radius: (a - b) + 2 b c^2 with c = cos(phi / 2), two positive terms; c is within 2 u, so 4 + 1 + 1, and 1
// for the sum.
// speed: hypot(a - b, 2 sqrt(a b) c), 1.5 + 2 + 1, and 2 for hypot.
// length: R_F and R_D take about 40 steps of 10 roundings, each counted a quarter of the one before, hence 14
// each; 6 for the modulus, half of which counts, and 10 for the sums and products of positive terms.
// area: the speed to the 5th power, 35; 12 more for the polynomials, all of positive terms.
constexpr double kConchoidRadius = 7.0;
constexpr double kSpeed = 6.5;
constexpr double kLength = 41.0;
constexpr double kArea = 47.0;
// A root is within 4 eps = 8 u of a sign change of the computed function. This is off by the function's error
// times the condition of the inverse.
constexpr double kRoot = 8.0;

constexpr double kB = 17.843;  // mm, Menschik's
constexpr std::array kAway{1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15};

constexpr const char* kConchoidMutation = "the radius as Eq. 11 has it, where a and b cancel (a sign)";

struct Method {
  std::string name;
  std::string kind;
  double threshold;
  std::function<double(const ConchoidShape&, double phi)> answer;
  std::function<Precise(const PreciseConchoid&, double phi)> truth;
};

// Eq. 11 and 12 as printed, which lose digits at phi = pi.
double plain_radius(const ConchoidShape& shape, double phi) { return shape.a + shape.b * std::cos(phi); }
double plain_speed(const ConchoidShape& shape, double phi) {
  const auto [a, b] = shape;
  return std::sqrt(a * a + b * b + 2.0 * a * b * std::cos(phi));
}

std::vector<Method> forward_methods() {
  using Curve = PreciseConchoid;
  const auto radius = [](const Curve& curve, double phi) { return curve.radius(phi); };
  const auto speed = [](const Curve& curve, double phi) { return curve.speed(phi); };
  return {
      {"conchoid_radius", "ours", kConchoidRadius, conchoid_radius, radius},
      {"conchoid_speed", "ours", kSpeed, conchoid_speed, speed},
      {"meridian_length", "ours", kLength, meridian_length,
       [](const Curve& curve, double phi) { return curve.length(phi); }},
      {"cap_area", "ours", kArea, cap_area, [](const Curve& curve, double phi) { return curve.area(phi); }},
      {"mutated", "mutated", kConchoidRadius, plain_radius, radius},
      {"radius_as_eq_11", "thesis", kConchoidRadius, plain_radius, radius},
      {"speed_as_eq_12", "thesis", kSpeed, plain_speed, speed}};
}

// Evenly spaced, and ever nearer to the cusp. The last is the double nearest to pi, which is a little less.
std::vector<double> polar_angles(std::size_t even) {
  std::vector<double> phi;
  for (std::size_t k = 1; k < even; ++k)
    phi.push_back(kPi * static_cast<double>(k) / static_cast<double>(even));
  for (double away = 1e-1; away > 1e-15; away *= 0.1) phi.push_back(kPi - away);
  phi.push_back(kPi);
  return phi;
}

StabilityCase start(double away, const std::string& name, const std::string& kind, double threshold) {
  StabilityCase row;
  row.magnitude = away;
  row.method = name;
  row.kind = kind;
  row.threshold = threshold;
  return row;
}

StabilityCase forward(const Method& method, const ConchoidShape& shape, double away, bool quick) {
  StabilityCase row = start(away, method.name, method.kind, method.threshold);
  const PreciseConchoid curve(shape);
  for (const double phi : polar_angles(quick ? 24 : 180)) {
    const Precise answer = method.answer(shape, phi);
    const Precise truth = method.truth(curve, phi);
    include_error(row, Precise(abs(answer - truth) / truth).convert_to<double>(), 1.0);
  }
  return row;
}

// An inverse. If the true function at the answer is off by e from the wanted value, the answer is off by e
// over the slope, to first order. Its condition is value / (phi slope).
struct Inverse {
  std::string name;
  double function_error;
  std::function<double(const ConchoidShape&, double)> value;
  std::function<double(const ConchoidShape&, double)> inverse;
  std::function<Precise(const PreciseConchoid&, double)> truth;
  std::function<Precise(const PreciseConchoid&, double)> slope;
};

StabilityCase backward(const Inverse& method, const ConchoidShape& shape, double away, bool quick) {
  StabilityCase row = start(away, method.name, "ours", kRoot + method.function_error);
  const PreciseConchoid curve(shape);
  for (const double phi : polar_angles(quick ? 12 : 60)) {
    if (phi > kPi - 1e-4) continue;  // where the slope vanishes, first order does not suffice
    const double asked = method.value(shape, phi);
    const double answer = method.inverse(shape, asked);
    const Precise moment = method.slope(curve, answer) * answer;
    const Precise error = abs(method.truth(curve, answer) - asked) / moment;
    const double condition = Precise(asked / moment).convert_to<double>();
    include_error(row, error.convert_to<double>(), 1.0 + condition);
  }
  return row;
}

std::vector<Inverse> inverses() {
  return {{"polar_angle_at_meridian_length", kLength, meridian_length, polar_angle_at_meridian_length,
           [](const PreciseConchoid& curve, double phi) { return curve.length(phi); },
           [](const PreciseConchoid& curve, double phi) { return curve.speed(phi); }},
          {"polar_angle_at_cap_area", kArea, cap_area, polar_angle_at_cap_area,
           [](const PreciseConchoid& curve, double phi) { return curve.area(phi); },
           [](const PreciseConchoid& curve, double phi) { return curve.area_rate(phi); }}};
}

void add_all(std::vector<StabilityCase>& rows, const ConchoidShape& shape, double away, bool quick) {
  for (const Method& method : forward_methods()) rows.push_back(forward(method, shape, away, quick));
  for (const Inverse& method : inverses()) rows.push_back(backward(method, shape, away, quick));
}

// a < b: a loop through the origin, which must be refused.
StabilityCase refused(double away) {
  StabilityCase row = start(-away, "conchoid_radius", "ours", kConchoidRadius);
  row.questions = 1;
  try {
    static_cast<void>(conchoid_radius({kB * (1.0 - away), kB}, 1.0));
    row.wrong = 1;
  } catch (const std::invalid_argument& error) {
    row.refused = error.what();
  }
  return row;
}

std::vector<StabilityCase> run_conchoid(const StabilityRun& options) {
  std::vector<StabilityCase> rows;
  rows.reserve(kAway.size());
  for (const double away : kAway) rows.push_back(refused(away));
  add_all(rows, {kB, kB}, 0.0, options.quick);
  for (const double away : kAway) add_all(rows, {kB * (1.0 + away), kB}, away, options.quick);
  return rows;
}

}  // namespace

StabilityFamily conchoid_family() {
  StabilityFamily family;
  family.name = "conchoid";
  family.parameter = "a / b - 1 of the conchoid r = a + b cos(phi), whose cusp is where a = b";
  family.unit = "1";
  family.expected =
      "radius, speed, length and area keep full relative accuracy up to the cusp and at it, whatever cancels "
      "in Eq. "
      "11 and 12; inverses lose what their condition says; a < b, a loop, is refused";
  family.threshold = kArea + kRoot;
  family.derivation =
      "roundings of each formula, all of them sums of positive terms (7 to 47), and 8 for the end of a root "
      "search";
  family.mutation = kConchoidMutation;
  family.seen = {7.7, 0.0};
  family.run = run_conchoid;
  return family;
}

}  // namespace impinge::lab
