// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How wrong is a table's radius, compared with the thesis' formula? (Table 5, Eq. 7-8)
// @writes    sampling_error sampling_error_proven sampling_error_sphere sampling_error_bounds
// @timing    no
// @seconds   11 320
// @links     harness table reference
//
// Eq. 7 is a distance along the surface; what matters is the error of the radius. It is measured on the
// generated head of 44 mm, against CGAL's exact arithmetic.

#include <array>
#include <concepts>

#include "04_sampling_error/sampling_study.hpp"
#include "harness/driver.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array kPrecisions{1.0, 0.5, 0.1, 0.05};  // degrees
constexpr double kFinestInQuick = 0.1;        // finest that is measured; the formula is given for all
constexpr double kFinestProvenInQuick = 0.5;  // for RSID, the scheme of Table 5

struct MeasureScheme {
  DriverRun& run;
  SamplingStudy& study;

  template <SamplingScheme S>
  void operator()() const {
    for (const double precision : kPrecisions) {
      const auto scheme = scheme_of_precision<S>(precision);
      if (!scheme) continue;
      if (run.quick() && precision < kFinestInQuick) {
        add_formula(study, *scheme, precision);
      } else {
        study.prove = std::same_as<S, Rsid> && (!run.quick() || precision >= kFinestProvenInQuick);
        add_scheme(study, *scheme, precision);
      }
    }
    run.progress.say("measured " + std::string(S::name));
  }
};

void body(DriverRun& run) {
  StudyOptions options;
  options.uniform = run.quick() ? 10000 : 200000;
  options.precisions.assign(kPrecisions.begin(), kPrecisions.end());
  options.seed = run.record.seed;
  SamplingStudy study = make_sampling_study(options);
  for_each_scheme(MeasureScheme{run, study});
  const nlohmann::json parameters = {{"head_diameter_mm", 2.0 * study.radius},
                                     {"faces", options.faces},
                                     {"directions", options.uniform},
                                     {"further_directions", study.directions.size() - options.uniform}};
  run.write({"sampling_error", "How wrong is the radius that a table of the head gives, beside Eq. 7 and 8?",
             std::move(study.errors), parameters});
  run.write({"sampling_error_proven", "How near does the measured error come to its proven bound?",
             std::move(study.proven), parameters});
  run.write({"sampling_error_sphere",
             "How far from an entry is a point of a sphere, and how wrong is its radius?",
             std::move(study.sphere), parameters});
  run.write({"sampling_error_bounds", "Does the usual bound on the error of a look-up within a plane hold?",
             std::move(study.bounds), parameters});
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"04_sampling_error", "Errors of the radii of a table (Table 5)."}, body);
}
