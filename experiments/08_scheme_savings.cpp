// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How many entries does each scheme need to be as good as RSID? (Section 4.4: 20 % less memory)
// @writes    scheme_savings
// @timing    no
// @seconds   12 120
// @links     harness scheme_metrics
//
// "As good" has four meanings (scheme_metrics/scheme_metrics.hpp). For each a table is made and measured.

#include <array>

#include "harness/driver.hpp"
#include "scheme_metrics/scheme_metrics.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/uniform_directions.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array kPrecisions{1.0, 0.5};  // degrees, precisions of RSID
constexpr double kFinestInQuick = 1.0;       // finer ones are only counted at equal spacing
constexpr std::size_t kProbes = 400000;      // directions in which tables are compared with the function
constexpr std::size_t kProbesInQuick = 100000;
constexpr BandLimitedChoice kFunction;

// What a table must equal.
struct Target {
  Rsid rsid;
  double covering_radius = 0.0;
  InterpolationError error;
};

struct AddRows {
  DriverRun& run;
  const ErrorProbe& probe;
  const Target& target;
  bool quality;  // measure more than equal spacing?
  Table& table;

  template <SamplingScheme S>
  void operator()() const {
    add<S>(saving_at_equal_spacing<S>(target.rsid.precision_deg()));
    if (!quality) return;
    const S near = scheme_of_size<S>(target.rsid.size());
    add<S>(saving_at_equal_gap(near, target.covering_radius));
    for (const Saving& saving : savings_at_equal_error(near, target.error, probe)) add<S>(saving);
  }

  template <SamplingScheme S>
  void add(const std::optional<Saving>& saving) const {
    if (!saving) return run.progress.say("left out: " + std::string(S::name) + " has no table as good");
    const std::size_t entries = target.rsid.size();
    table.add_row({S::name, saving->meaning, target.rsid.precision_deg(), saving->entries, entries,
                   saved_percent(saving->entries, entries), saving->entries * sizeof(double),
                   saving->measured_ratio});
  }
};

void body(DriverRun& run) {
  const std::size_t probes = run.quick() ? kProbesInQuick : kProbes;
  const ErrorProbe probe(BandLimited(kFunction), uniform_directions(probes, run.record.seed));
  Result result{
      "scheme_savings",
      "How many entries does each scheme need to be as good as RSID?",
      {{{"scheme", "", "name of the sampling scheme"},
        {"meaning", "", "what is equal: equator_spacing, covering_radius, interpolation_p9999 or _rms"},
        {"precision_deg", "deg", "precision of the RSID table"},
        {"entries", "1", "of the table that is as good"},
        {"rsid_entries", "1", "of the RSID table"},
        {"saved_percent", "%", "entries saved; negative where more are needed"},
        {"bytes", "byte", "of the radii of the table"},
        {"measured_ratio", "1",
         "what is equal, as measured on the table, over that of RSID; empty where not made"}}}};
  result.parameters = {
      {"precisions_deg", kPrecisions},
      {"covering_radius", "smallest table found, in steps of at most 0.5 % of the entries"},
      {"most_entries_made", kMostMeasured},
      {"interpolation", "size scaled from the error at the size of RSID, measured, scaled again"},
      {"wavenumber", kFunction.wavenumber},
      {"waves", kFunction.waves},
      {"functions", kFunction.functions},
      {"function_seed", kFunction.seed},
      {"directions", probes}};
  for (const double precision : kPrecisions) {
    const Rsid rsid = Rsid::with_precision(precision);
    const bool quality = !run.quick() || precision >= kFinestInQuick;
    Target target{rsid, 0.0, {}};
    if (quality) target = {rsid, measured_covering_radius(rsid), interpolation_error(rsid, probe)};
    for_each_scheme(AddRows{run, probe, target, quality, result.table});
  }
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"08_scheme_savings", "Entries that each scheme needs to equal RSID."}, body);
}
