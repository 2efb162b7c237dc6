// SPDX-License-Identifier: GPL-3.0-or-later
// A family of stiff or extreme cases, and the result of one case. To add a family, add one file to
// stress/families/: NAME.cpp defines StabilityFamily NAME_family() in namespace impinge::lab, and the build
// finds it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/csv.hpp"
#include "harness/driver.hpp"

namespace impinge::lab {

// The value of a column that has none.
inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

// The arithmetic or storage whose rounding the method cannot avoid.
enum class Scalar { float32, float64 };
std::string_view name_of(Scalar scalar);  // "float", "double"
double unit_roundoff(Scalar scalar);      // 2^-24, 2^-53

// An input has a condition number: the relative change of the answer, in units of the largest relative change
// of the data, that no algorithm in that arithmetic can avoid. With unit roundoff u, an algorithm is as
// stable as possible if its relative error is a small number times condition * u. The threshold is how large
// that number may be; it is worked out from the operations of the algorithm before anything is measured. It
// covers the worst of all inputs, so it is far above what is measured; `seen` limits that more tightly.
//
// A case is stiff if its condition number is above 1000: 1 + tan psi of a radius, psi between ray and normal
// (dr / d angle = r tan psi); R / (|d distance / d angle| angle) of a first contact; R / distance of bones
// that pass one another. A case is extreme if its condition is smaller but its parameter is within 1e-6 of a
// place where the answer jumps or is not defined, or beyond it.
inline constexpr double kStiff = 1000.0;  // a condition number above it
inline constexpr double kExtreme = 1e-6;  // distance of the parameter from such a place, relative or in mm

// One method at one magnitude, a row of the results. What was not measured is NaN or 0.
struct StabilityCase {
  double magnitude = 0.0;           // of the parameter, in the unit of the family
  std::string method;               // as in the benchmark: SCHEME, SCHEME_mesh_exact, or by library and mode
  std::string kind;                 // ours, library, brute, thesis, steps, or mutated: wrong on purpose
  double precision_deg = 0.0;       // of a table, or of the steps of a motion; 0: neither, exact
  Scalar scalar = Scalar::float64;  // its rounding counts

  std::size_t questions = 0;                     // directions, entries or poses
  double condition = kNotMeasured;               // largest over the questions
  double relative_error = kNotMeasured;          // largest |answer - truth| / truth
  double error_over_condition_u = kNotMeasured;  // largest, each error over its own condition
  double backward_error_over_u = kNotMeasured;   // largest |error| / (r tan psi u), where tan psi >= 1
  double stiffness = kNotMeasured;               // largest tan psi of the scene over its median
  double threshold = kNotMeasured;               // on error_over_condition_u

  std::size_t nan = 0;  // answers that are no length: infinite, not positive, or NaN where NaN has no meaning
  std::size_t false_hits = 0;   // an answer where there is no surface
  std::size_t missed_hits = 0;  // no answer where there is a surface, unless `withheld`
  std::size_t wrong = 0;        // error_over_condition_u above the threshold, or bits that should be the same
  std::size_t withheld = 0;   // no answer in a cell that a rim crosses, or unknown: documented, so no failure
  std::size_t unbounded = 0;  // answers of look-ups without a proven bound
  std::string refused;        // message of a refusal: nothing was answered, so nothing failed

  // For the look-up between entries that is nearest to its bound, or beyond it.
  double bound_um = kNotMeasured;  // proven, on its error
  double error_um = kNotMeasured;

  // Answers that are wrong in any way.
  std::size_t failures() const { return nan + false_hits + missed_hits + wrong; }
  // None if nothing is proven: without a bound, with an infinite bound, and if no look-up answers.
  std::optional<bool> bound_holds() const;
};

// Joins the cases of two scenes of one magnitude, method by method: counts are added, the worse error is
// kept. Both lists must have the same methods.
std::vector<StabilityCase> worse_of(std::vector<StabilityCase> a, const std::vector<StabilityCase>& b);

// What all families share in a run.
struct StabilityRun {
  bool quick = true;       // fewer magnitudes, smaller scenes
  std::uint64_t seed = 0;  // for all random numbers
};

// One family: its parameter, the expected behaviour, and how it is run.
struct StabilityFamily {
  std::string name;       // of its file, and in the results
  std::string parameter;  // what grows stiff or extreme, in words
  std::string unit;       // of the magnitudes
  std::string expected;   // expected behaviour of ours, written down before it is run
  // For our methods in double; a case may have its own, such as for a table stored in float.
  double threshold = 0.0;
  std::string derivation;  // the operations that the threshold counts
  // Largest error_over_condition_u of ours in quick and full runs, rounded down, in double and in float. The
  // run fails above twice this, since an error far below its threshold may still have grown.
  std::array<double, 2> seen{};
  // What is wrong with the method of kind `mutated`, a sign or a tolerance. It must fail in some case.
  std::string mutation;
  // Runs every method at every magnitude, 5 magnitudes or more. Deterministic.
  std::function<std::vector<StabilityCase>(const StabilityRun&)> run;
};

// All families, in alphabetical order of their names.
std::vector<StabilityFamily> stability_families();

// A quick run asks less, so it may see this share of the worst of a full run, `seen`.
inline constexpr double kQuickShareOfSeen = 0.5;

// Reasons for the run to fail, one line each: a failure of ours, a bound that does not hold, an error of more
// than twice what was seen, a mutation that does not fail, or `seen` so far above the worst of this run that
// the worst is less than that share of it.
std::vector<std::string> broken(const StabilityFamily& family, const std::vector<StabilityCase>& cases,
                                double least_share_of_seen = kQuickShareOfSeen);

// The results of the families as tables.

// The three tables of the results, row by row.
struct StabilityTables {
  Table main;      // stability.csv
  Table detail;    // stability_detail.csv
  Table families;  // stability_families.csv
  // One line for each failure of ours that is not a refusal.
  std::vector<std::string> broken;
};
StabilityTables make_stability_tables();  // The tables with columns and no rows.

// Runs the family and adds its rows. Throws std::logic_error for fewer than 5 magnitudes.
void run_family(const StabilityFamily& family, const StabilityRun& run, StabilityTables& tables);

// Runs all families, one after the other.
StabilityTables run_stability(const StabilityRun& run, Progress& progress);

// For cases whose answers are other numbers than radii: adds one question.

// `error` is relative to the truth, and not finite if the answer was no number. The threshold must be set.
inline void include_error(StabilityCase& result, double error, double condition) {
  ++result.questions;
  if (!std::isfinite(error)) {
    ++result.nan;
    return;
  }
  const double share = error / (condition * unit_roundoff(result.scalar));
  result.condition = std::fmax(result.condition, condition);  // fmax ignores a NaN
  result.relative_error = std::fmax(result.relative_error, error);
  result.error_over_condition_u = std::fmax(result.error_over_condition_u, share);
  if (share > result.threshold) ++result.wrong;
}

}  // namespace impinge::lab
