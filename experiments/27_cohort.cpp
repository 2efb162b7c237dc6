// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Does the published spread of shape give the published spread of internal rotation?
// @writes    cohort
// @timing    no
// @seconds   14 60
// @reads     27_cohort/study.json
// @links     cohort
//
// Works out 200 hips of 27_cohort/study.json as the program `impinge cohort` does: the limit of every motion,
// the shape as measured from the meshes, and the zones of small gaps at the limits. A cohort of 10,000 is a
// run of that program (experiments/README.md); results/reference/cohort/ keeps one.

#include "cohort/answers.hpp"
#include "cohort/shard.hpp"
#include "harness/build_info.hpp"
#include "harness/driver.hpp"

namespace {

using namespace impinge::lab;

constexpr std::size_t kBetweenLines = 20;        // hips
constexpr std::size_t kFacesInQuick = 1000;      // faces of a surface
constexpr std::size_t kFineFacesInQuick = 3000;  // faces where a hip is looked at twice

void body(DriverRun& run) {
  const std::filesystem::path source = build_info().source_folder;
  Study study = read_study(source / "experiments/27_cohort/study.json", std::nullopt);
  if (run.quick()) {
    study.faces = kFacesInQuick;
    study.check_faces = kFineFacesInQuick;
  }
  const Members members(study);
  Result result{"cohort", "What are shape and limits of hips whose parameters spread as published?"};
  result.parameters = {{"study", study.text},
                       {"study_sha256", study.digest},
                       {"faces", study.faces},
                       {"check_faces", study.check_faces}};
  result.table.columns = cohort_columns(study);
  for (std::size_t j = 0; j < members.size(); ++j) {
    result.table.rows.push_back(cohort_row(study, members, j));
    if ((j + 1) % kBetweenLines == 0) run.progress.say(std::to_string(j + 1) + " hips");
  }
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return run_driver(argc, argv, {"27_cohort", "A cohort of hips whose parameters spread as published."},
                    body);
}
