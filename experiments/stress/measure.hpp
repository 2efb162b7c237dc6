// SPDX-License-Identifier: GPL-3.0-or-later
// All methods on one scene, compared with the exact reference. Two errors are kept apart. For rounding, a ray
// method is asked along every direction and a table at every entry; the answer is compared with the exact
// radius along that very double direction, and its relative error over condition * u must stay below the
// threshold. For interpolation, a table is looked up along every direction; the error must not be above its
// proven bound, rounding included.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "stress/family.hpp"
#include "stress/methods.hpp"
#include "stress/mutated_rays.hpp"

namespace impinge::lab {

// How many of its digits a radius may lose. In the plane n . x = p the radius is r = p / (n . u), and d ln r
// / d angle = tan psi, psi the angle from u to the normal. Rounding the direction therefore costs 1 + tan
// psi, which is the condition; at an edge or vertex it is the largest of the faces that meet there. Thinness
// of a face does not count: its plane is as certain as its corners (sphere/face_plane.hpp).

// How steep the surface is along one direction.
struct RayCondition {
  double slope = 0.0;                               // tan psi of the nearest face
  double condition() const { return 1.0 + slope; }  // relative error of the radius for one of the direction
};

// For the nearest face along each direction; 0 where there is none. `mesh` is in the centre frame. Worked out
// in extended precision, without the library's own planes.
std::vector<RayCondition> conditions_along(const TriangleMesh& mesh, std::span<const Vec3> directions);

// Largest tan psi divided by the median, each face seen along its centroid. At most 1 for a sphere about the
// centre; a scene above 1000 is stiff.
double stiffness(const TriangleMesh& mesh);

// For our methods in double, from the operations of TriangleCone::radius() = (n . v0) / (n . u). Let u =
// 2^-53, s = |b - a| |c - a| and |n| <= s. The 4 roundings of n = (b - a) x (c - a), each of at most
// sqrt(4/3) s, and the 3 of a scalar product move n . v0 by (4.62 s + 3 |n|) R u and n . u by (4.62 s + 3
// |n|) u. The condition is at least |n| r / (n . v0), and they are (4.62 s / |n| + 3) (1 + R / r) u of it.
// Where s R / (|n| r) is above kMostTilt = 4 (sphere/face_plane.hpp) they are an exact plane's, (1 + 1 + 3)
// u, elsewhere at most (2 x 4.62 x 4 + 3 + 3 x 4) u. The division, a direction whose length is 1 to within 3
// u, and the 4 roundings that normalise a direction or read a mesh_exact table add 8: 60 in all. If a plane
// holds the centre but for 20 roundings of its size, the answer is a corner's. It is off by less than half of
// the radius if no corner is twice as far as another: 20 x 4 / 2 at most.
inline constexpr double kRadiusThreshold = 60.0;
// The derivation in words, for the results.
inline constexpr const char* kRadiusDerivation =
    "4 roundings of n, of 1.16 |b - a| |c - a|, at most 4 times as large in n.v0 or n.u, or 1 of an exact "
    "plane; 3 each of n.v0 and n.u; 8 of quotient, length and normalised direction or inverse depth";

// For tables stored in float: one rounding to float, and the others in double.
inline constexpr double kStoredThreshold = 1.0 + 2.0 * kRadiusThreshold * 0x1p-29;

// The same for all magnitudes of a family.
struct MeasureOptions {
  double threshold = kRadiusThreshold;  // for everything that we do not store in float
  BoundOptions search;                  // of the tables' bounds
  std::optional<Flaw> flaw;             // of the rays that are wrong on purpose, if any
};
// How hard a quick or a full run searches for bounds.
MeasureOptions measure_options(const StabilityRun& run);

// The truth along some directions.
struct RadiusQuestions {
  std::span<const Vec3> directions;     // of any length above zero
  std::vector<double> truth;            // mm, NaN where there is no surface
  std::vector<RayCondition> condition;  // of each direction
};
// Works out truth and conditions.
RadiusQuestions ask(const TriangleMesh& mesh, std::span<const Vec3> directions);

// Adds the answers to the case: hits, errors, conditions, wrong ones.
void judge(StabilityCase& result, const RadiusQuestions& questions, std::span<const double> answers);

// Tests every method on the scene; tables have its own precision and those of working_tables.hpp.
std::vector<StabilityCase> measure(const StabilityScene& scene, double magnitude,
                                   const MeasureOptions& options);

// Tests only these methods.
std::vector<StabilityCase> measure(const StabilityScene& scene, double magnitude,
                                   const MeasureOptions& options, std::span<const StabilityMethod> methods);

// The scenes of one magnitude.
using ScenesAt = std::function<std::vector<StabilityScene>(double magnitude)>;

// Tests every method, and rays that are wrong on purpose, at every magnitude, on the worse of its scenes.
std::vector<StabilityCase> sweep(std::span<const double> magnitudes, const ScenesAt& scenes_at,
                                 const StabilityRun& run, std::optional<Flaw> flaw = std::nullopt);

}  // namespace impinge::lab
