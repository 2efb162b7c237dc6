// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How well does each scheme cover the sphere, and how well does it interpolate?
// @writes    schemes scheme_covering scheme_errors
// @timing    no
// @seconds   5 20
// @links     harness scheme_metrics
//
// Every scheme of the list, with about as many entries as RSID has at 1 degree. Everything is measured on the
// directions and stencils of the scheme; only declared_radius_deg is what the scheme says of itself.

#include "harness/driver.hpp"
#include "scheme_metrics/interpolation_error.hpp"
#include "scheme_metrics/scheme_metrics.hpp"
#include "scheme_metrics/scheme_search.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/uniform_directions.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kProbes = 400000;  // directions in which tables are compared with the function
constexpr std::size_t kProbesInQuick = 100000;
constexpr std::size_t kPolarProbes = 20000;  // additional directions within 1 degree of the poles
constexpr BandLimitedChoice kFunction;

const Column kScheme{"scheme", "", "name of the sampling scheme"};
const Column kEntries{"entries", "1", "sampled directions; repeated ones count"};

struct Results {
  Result schemes{
      "schemes",
      "How well does each scheme cover the sphere?",
      {{kScheme,
        {"label", "", "name for readers"},
        {"citation", "", "source"},
        kEntries,
        {"covering_radius_deg", "deg", "largest angle from any direction to its nearest entry"},
        {"covering_constant", "1", "entries times covering radius (radians) squared"},
        {"max_area_ratio", "1", "largest over smallest area of an entry; repeated entries share one area"},
        {"equator_points", "1", "entries on the equator"}}}};
  Result covering{
      "scheme_covering",
      "Where is the widest gap of each scheme, and how wide are the others?",
      {{kScheme,
        kEntries,
        {"directions", "1", "entries that differ in direction"},
        {"constant", "1", "entries times covering radius squared"},
        {"constant_away", "1", "the same of the widest gap whose middle has |z| at most 0.98"},
        {"widest_gap_z", "1", "height of the middle of the widest gap"},
        {"declared_radius_deg", "deg", "covering radius that the scheme declares"},
        {"direction_area_ratio", "1", "largest over smallest area of a direction, however often repeated"}}}};
  Result errors{"scheme_errors",
                "How far are tables of each scheme from smooth functions?",
                {{kScheme,
                  kEntries,
                  {"max", "1", "largest error, in standard deviations of the functions"},
                  {"p9999", "1", "error that 1 in 10,000 directions exceeds"},
                  {"rms", "1", "root mean square error"},
                  {"rms_poles", "1", "the same within 1 degree of the poles"},
                  {"entries_max", "1", "entries times max"},
                  {"entries_p9999", "1", "entries times p9999: memory for a given error"},
                  {"entries_rms", "1", "entries times rms"},
                  {"entries_rms_poles", "1", "entries times rms_poles"}}}};
};

struct AddRows {
  const ErrorProbe& probe;
  const ErrorProbe& poles;
  std::size_t entries;
  Results& results;

  template <SamplingScheme S>
  void operator()() const {
    const S scheme = scheme_of_size<S>(entries);
    const SchemeMetrics metrics = measure_scheme(scheme);
    results.schemes.table.add_row({S::name, S::label, S::citation, metrics.entries,
                                   metrics.widest.radius / kDegree, metrics.covering_constant(),
                                   metrics.entry_area_ratio, scheme.equator_points()});
    results.covering.table.add_row({S::name, metrics.entries, metrics.directions, metrics.covering_constant(),
                                    metrics.covering_constant_away(), metrics.widest.centre.z(),
                                    scheme.covering_radius() / kDegree, metrics.direction_area_ratio});
    const InterpolationError error = interpolation_error(scheme, probe);
    const double polar = interpolation_error(scheme, poles).rms;
    const auto n = static_cast<double>(metrics.entries);
    results.errors.table.add_row({S::name, metrics.entries, error.max, error.p9999, error.rms, polar,
                                  n * error.max, n * error.p9999, n * error.rms, n * polar});
  }
};

void body(DriverRun& run) {
  const std::size_t probes = run.quick() ? kProbesInQuick : kProbes;
  const ErrorProbe probe(BandLimited(kFunction), uniform_directions(probes, run.record.seed));
  const ErrorProbe poles(BandLimited(kFunction), polar_directions(kPolarProbes, kDegree, run.record.seed));
  const std::size_t entries = Rsid::with_precision(1.0).size();
  Results results;
  for_each_scheme(AddRows{probe, poles, entries, results});
  const nlohmann::json size = {
      {"entries", "nearest to the " + std::to_string(entries) + " of RSID at 1 degree"}};
  results.schemes.parameters = results.covering.parameters = results.errors.parameters = size;
  results.covering.parameters["away_from_poles"] = kAwayFromPoles;
  results.errors.parameters.update({{"wavenumber", kFunction.wavenumber},
                                    {"waves", kFunction.waves},
                                    {"functions", kFunction.functions},
                                    {"function_seed", kFunction.seed},
                                    {"directions", probes},
                                    {"polar_directions", kPolarProbes}});
  for (const Result* result : {&results.schemes, &results.covering, &results.errors}) {
    run.write(*result);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"08_schemes", "Covering and interpolation of every sampling scheme."}, body);
}
