// SPDX-License-Identifier: GPL-3.0-or-later
// A motion that brings a vertex of the ball through the socket's surface at a grazing angle, as a neck slides
// along a rim: at which angle do they touch?
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/bodies.hpp"
#include "stress/family.hpp"
#include "stress/known_turn.hpp"
#include "stress/methods.hpp"
#include "stress/working_tables.hpp"

namespace impinge::lab {
namespace {

constexpr double kStiffMotionRadius = 26.0;                                       // mm, of an octahedron
constexpr std::array kStiffMotionAngles{1e1, 1e0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5};  // degrees
constexpr double kStart = -30.0 * kDegree;
constexpr std::size_t kAxes = 3;

// At the angle that a method finds, the true gap may be as large as the errors of the method's radius and of
// the vertex. In units of u r these are 52 for a radius (8 for its plane at this distance, 28 for the taps
// and 16 for an inverse depth), 24 for the turned vertex and its length, and in float 1 more for the entries.
// To first order this is the error of the angle divided by its condition, r / |d gap / d angle| / angle; it
// still holds where the gap hardly crosses zero.
constexpr double kStiffMotionThreshold = 76.0;
constexpr double kStoredMotionThreshold = 1.0 + kStiffMotionThreshold * 0x1p-29;

StabilityCase blank(const StabilityMethod& method, double magnitude) {
  StabilityCase row;
  row.magnitude = magnitude;
  row.method = method.maker.name;
  row.kind = method.maker.kind;
  row.scalar = method.scalar;
  row.refused = method.refused;
  if (method.maker.precision_deg > 0.0) row.precision_deg = method.maker.precision_deg;
  row.threshold =
      row.kind == "ours" && row.scalar == Scalar::float32 ? kStoredMotionThreshold : kStiffMotionThreshold;
  return row;
}

// For a table of radii, which interpolates between entries, its bound decides; elsewhere rounding does.
void judge_contact(const StabilityMethod& method, const PointQuery& answering, const Slide& slide,
                   StabilityCase& row) {
  const PreciseSlide truth(slide, kStiffMotionRadius);
  const Precise contact = truth.contact();
  const double rate = ((truth.gap(contact + 1e-20) - truth.gap(contact)) / 1e-20).convert_to<double>();
  const double radius = slide.vertex(0.0).norm();
  const std::optional<double> found = touching_angle(answering, slide, kStart);
  // "No contact" is as right as the gap at the deepest point is small.
  const Precise gap = truth.gap(found ? Precise(*found) : Precise(0));
  const double error = abs(gap).convert_to<double>();
  ++row.questions;
  row.condition = std::fmax(row.condition, radius / std::abs(rate) / abs(contact).convert_to<double>());
  if (found)
    row.relative_error =
        std::fmax(row.relative_error, abs((*found - contact) / contact).convert_to<double>());
  row.error_um = std::fmax(row.error_um, 1e3 * error);
  if (method.maker.interpolant == "smooth") {
    row.bound_um =
        1e3 * (method.maker.bound(answering).bound_mm + row.threshold * unit_roundoff(row.scalar) * radius);
    // Where the overlap is less than the bound, "no gap" is as good an answer as any.
    if (!found) ++(1e3 * error > row.bound_um ? row.missed_hits : row.withheld);
    return;
  }
  const double share = error / (radius * unit_roundoff(row.scalar));
  row.error_over_condition_u = std::fmax(row.error_over_condition_u, share);
  if (share > row.threshold) ++(found ? row.wrong : row.missed_hits);
}

// The exact radius, with gaps up to a tolerance counted as contact.
StabilityMethod tolerant_octahedron() {
  StabilityMethod method;
  method.maker.name = "mutated_gaps";
  method.maker.kind = "mutated";
  method.maker.make = [] {
    return one_by_one(
        [](const Vec3& x) { return octahedron_mesh_radius(x.normalized(), kStiffMotionRadius) - 1e-6; }, 0.0);
  };
  return method;
}

std::vector<StabilityMethod> all_methods(const StabilityScene& scene, bool quick) {
  std::vector<StabilityMethod> methods = stability_methods(scene, {1.05, quick ? 200U : 2000U});
  for (StabilityMethod& working : working_octahedra(kStiffMotionRadius))
    methods.push_back(std::move(working));
  methods.push_back(tolerant_octahedron());
  return methods;
}

std::vector<StabilityCase> run_stiff_motion(const StabilityRun& options) {
  StabilityScene scene;
  scene.mesh = octahedron(kStiffMotionRadius);
  scene.precision_deg = options.quick ? 6.0 : 2.0;
  std::vector<StabilityCase> rows;
  for (const StabilityMethod& method : all_methods(scene, options.quick)) {
    std::optional<PointQuery> answering;
    if (method.refused.empty()) answering = method.maker.make();
    for (const double angle : kStiffMotionAngles) {
      rows.push_back(blank(method, angle));
      for (std::size_t k = 0; answering && k < kAxes; ++k)
        judge_contact(method, *answering, known_slide(k, angle * kDegree, kStiffMotionRadius), rows.back());
    }
  }
  const std::vector<StabilityCase> turns = over_turns(
      kStiffMotionAngles, options,
      [](std::size_t k, double degrees) { return sliding_tip(k, degrees * kDegree, kStiffMotionRadius); });
  rows.insert(rows.end(), turns.begin(), turns.end());
  return rows;
}

}  // namespace

StabilityFamily stiff_motion_family() {
  StabilityFamily family;
  family.name = "stiff_motion";
  family.parameter =
      "angle between the first contact of a vertex and the deepest point of its way, along a face";
  family.unit = "degree";
  family.expected =
      "the angle of contact loses the digits that its condition says, 1 / angle^2, and the gap at the angle "
      "that is found is that of rounding; tables of radii keep the gap below their bound, and say nothing of "
      "an "
      "overlap that is smaller; only the first contact in closed form finds all";
  family.threshold = kStiffMotionThreshold;
  family.derivation =
      "52 roundings of a radius between exact entries (its plane, the taps, an inverse depth) and 24 of the "
      "turned "
      "vertex and its length, as a gap in units of u r";
  family.mutation = "gaps up to 1e-6 mm are contact (a tolerance)";
  family.seen = {3.4, 0.49};
  family.run = run_stiff_motion;
  return family;
}

}  // namespace impinge::lab
