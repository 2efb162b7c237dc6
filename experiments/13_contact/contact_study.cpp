// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_contact/contact_study.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "13_contact/contact_methods.hpp"
#include "13_contact/contact_motions.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

// What is timed and said of one way in poses of one gap.
struct ContactCase {
  TimedCase timed;
  std::size_t poses = 0;
  std::size_t touching = 0;      // of these, by this way
  double least_gap_mm = 0.0;     // median over the poses
  double error_mm = kNoSurface;  // largest of a gap of a table in the poses compared; NaN for other ways
};

double median_gap(const CulledJoint& joint, const std::vector<Pose>& poses) {
  std::vector<double> gaps;
  gaps.reserve(poses.size());
  for (const Pose& pose : poses) gaps.push_back(joint.least_gap(pose)->gap_mm);
  return summarise(gaps).median;
}

void add_cases(ContactStage& stage, const GapCase& gap, const ContactOptionsTimed& options,
               std::vector<ContactCase>& cases) {
  const std::vector<Pose> poses = contact_motions(stage.culled, gap, options.seed);
  const std::map<std::string, double> errors = compare(stage, poses);
  for (const AskedContact& asked : contact_methods(stage, poses)) {
    ContactCase added;
    added.poses = asked.poses.size();
    added.touching = static_cast<std::size_t>(std::ranges::count_if(asked.poses, asked.touches));
    added.least_gap_mm = median_gap(stage.culled, asked.poses);
    if (errors.contains(asked.method)) added.error_mm = errors.at(asked.method);
    added.timed.key = {asked.method, gap.name, stage.pair.ball.faces.size()};
    added.timed.units = static_cast<double>(asked.poses.size());
    added.timed.rounds = options.rounds;
    added.timed.run = [asked] { asked.run(asked.poses); };
    cases.push_back(std::move(added));
  }
}

// Median of a method in the same case, ms a pose.
double median_of(const TimingRun& run, const std::string& method, const Timing& like) {
  return find(run, {method, like.key[1], like.key[2]}).summary.median;
}

Table contact_table(const std::vector<ContactCase>& cases, const TimingRun& run) {
  constexpr double kMicroseconds = 1e3;  // in a millisecond
  constexpr double kMicrons = 1e3;       // in a millimetre
  Table table{contact_keys(), {}};
  for (const Column& column : std::vector<Column>{
           {"us_pose", "us", "median time of a pose"},
           {"iqr_us", "us", "interquartile range of it over the rounds"},
           {"rounds", "1", "rounds measured"},
           {"poses", "1", "poses of a round: motions of 16, half a degree from one to the next"},
           {"touching", "1", "of these, by this method"},
           {"least_gap_mm", "mm", "median of the smallest gap of a pose"},
           {"error_um", "um",
            "largest error of a gap at a vertex, in those of the poses that were compared; of tables alone"},
           {"times_fcl_collide", "1", "median of fcl_collide over this one"},
           {"times_fcl_distance", "1", "median of fcl_distance over this one"}}) {
    table.columns.push_back(column);
  }
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Timing& timing = run.timings[k];
    const double median = timing.summary.median;
    std::vector<Cell> row = timing.key;
    row.insert(row.end(), {kMicroseconds * median, kMicroseconds * timing.summary.iqr, timing.summary.count,
                           cases[k].poses, cases[k].touching, cases[k].least_gap_mm,
                           kMicrons * cases[k].error_mm, median_of(run, "fcl_collide", timing) / median,
                           median_of(run, "fcl_distance", timing) / median});
    table.add_row(std::move(row));
  }
  return table;
}

}  // namespace

std::vector<Column> contact_keys() {
  return {contact_method_column(),
          {"gap_case", "", "smallest gap in the poses"},
          {"triangles", "1", "of each of the two models"}};
}

ContactTables contact_tables(const ContactOptionsTimed& options, Progress& progress) {
  std::vector<std::unique_ptr<ContactStage>> stages;
  std::vector<ContactCase> cases;
  for (const std::size_t triangles : options.triangles) {
    stages.push_back(std::make_unique<ContactStage>(triangles));
    for (const GapCase& gap : kGapCases) add_cases(*stages.back(), gap, options, cases);
    progress.say("made the poses of " + std::to_string(triangles) + " triangles");
  }
  std::vector<TimedCase> timed;
  timed.reserve(cases.size());
  for (const ContactCase& one : cases) timed.push_back(one.timed);
  ContactTables tables;
  tables.timing = run_interleaved(timed, options.timing, progress);
  tables.table = contact_table(cases, tables.timing);
  return tables;
}

}  // namespace impinge::lab
