// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Where are the entries of each scheme, and what area does each stand for?
// @writes    scheme_points
// @timing    no
// @seconds   1 1
// @links     harness scheme_metrics
//
// The tables are so small that their entries can be seen in a picture.

#include "harness/driver.hpp"
#include "scheme_metrics/scheme_metrics.hpp"
#include "scheme_metrics/scheme_search.hpp"
#include "sphere/scheme_list.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kEntries = 1600;

struct AddRows {
  Table& table;

  template <SamplingScheme S>
  void operator()() const {
    const S scheme = scheme_of_size<S>(kEntries);
    const std::vector<double> areas = entry_areas(sphere_delaunay_of(scheme));
    for (std::size_t i = 0; i < scheme.size(); ++i) {
      const Vec3 u = scheme.direction(i);
      table.add_row({S::name, i, u.x(), u.y(), u.z(), areas[i]});
    }
  }
};

void body(DriverRun& run) {
  Result result{"scheme_points",
                "Where are the entries of each scheme, and what area does each stand for?",
                {{{"scheme", "", "name of the sampling scheme"},
                  {"entry", "1", "number of the entry"},
                  {"x", "1", "of its direction"},
                  {"y", "1", "of its direction"},
                  {"z", "1", "of its direction"},
                  {"area_sr", "sr", "of its Voronoi cell; repeated entries share one"}}}};
  result.parameters["entries"] = "nearest to " + std::to_string(kEntries);
  for_each_scheme(AddRows{result.table});
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv, {"08_scheme_points", "Entries and areas of every scheme."},
                                  body);
}
