// SPDX-License-Identifier: GPL-3.0-or-later
#include "17_limit_time/limit_times.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"
#include "hip/named_motion.hpp"
#include "limits/told_limit.hpp"
#include "methods/cgal.hpp"
#include "methods/contact.hpp"

namespace impinge::lab {
namespace {

constexpr double kResolution = 0.01;         // degrees, to which steps are halved
constexpr double kMissed = 2 * kResolution;  // a contact later than the truth by more was missed
constexpr double kClosedForm = 1e-6;         // degrees, accuracy of a known limit
constexpr int kBuildings = 3;                // times that building is timed
constexpr const char* kOurs = "turn_limit";
constexpr const char* kRanges = "turn_limit_ranges";

// A motion that begins clear, with the angle of its first contact, or the largest angle if it has none.
struct TrueLimit : TurnedMotion {
  double deg;
};

double cpu_now_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Makes something, and gives the median time of making it.
template <class Make>
auto built(const Make& make, double& building_ms) {
  std::vector<double> times;
  auto made = make();  // warm
  for (int k = 0; k < kBuildings; ++k) {
    const double before = cpu_now_ms();
    made = make();
    times.push_back(cpu_now_ms() - before);
  }
  building_ms = summarise(times).median;
  return made;
}

Pose pose_at(const JointTurn& turn, double angle_deg) {
  Pose pose;
  pose.rotation =
      turn.outer * Eigen::AngleAxisd(angle_deg * kDegree, turn.axis).toRotationMatrix() * turn.inner;
  return pose;
}

// Steps until a pose touches, then halves the last step.
double march(const Touch& touches, const TrueLimit& motion, double step_deg) {
  double free = 0.0;
  double touching = std::min(step_deg, motion.largest_deg);
  while (!touches(pose_at(motion.turn, touching))) {
    if (touching >= motion.largest_deg) return motion.largest_deg;
    free = touching;
    touching = std::min(touching + step_deg, motion.largest_deg);
  }
  while (touching - free > kResolution) {
    const double middle = 0.5 * (free + touching);
    (touches(pose_at(motion.turn, middle)) ? touching : free) = middle;
  }
  return touching;
}

// Number of poses that march() tests, with a method that errs little.
double poses_of(const TrueLimit& motion, double step_deg) {
  return std::ceil(motion.deg / step_deg) + std::ceil(std::log2(std::max(1.0, step_deg / kResolution)));
}

using FindLimit = std::function<double(const TrueLimit&)>;  // degrees

// One method in one setting, with its answers.
struct AskedLimits {
  std::string method;
  Cell step_deg;
  double building_ms = 0.0;
  std::size_t motions = 0;  // it answers this many of the joint's motions, the first ones
  FindLimit limit;
  int rounds = 1;
  std::vector<double> found_deg;                                                          // of these motions
  double seconds = 0.0;                                                                   // time to find them
  std::shared_ptr<std::vector<double>> cpu_ms = std::make_shared<std::vector<double>>();  // one per run
};

std::vector<TurnedMotion> asked_of(const TurnedJoint& joint) {
  std::vector<TurnedMotion> asked = joint.motions;
  if (!asked.empty()) return asked;
  for (const NamedMotion& motion : named_motions()) {
    const MotionName& growing = motion_name(motion.growing);
    asked.push_back({std::string(motion.name), joint_turn(motion.start, growing, joint.side),
                     largest_growth(motion.start, growing), std::nullopt});
  }
  return asked;
}

std::vector<TrueLimit> motions_of(const TurnedJoint& joint, const TurnLimits& limits) {
  std::vector<TrueLimit> motions;
  for (const TurnedMotion& one : asked_of(joint)) {
    if (limits.first_contact(one.turn, one.largest_deg).state != LimitState::blocked)
      motions.push_back({one, 0.0});
  }
  return motions;
}

double angle_of(const TurnLimit& limit, double largest_deg) {
  return limit.state == LimitState::limited ? limit.high_deg : largest_deg;
}

FindLimit ours(const TurnedJoint& joint, bool ranges) {
  const CentreQuestion question{CentreDoubt::common, kErrorOfInput, 0.0};
  return [limits = std::make_shared<const TurnLimits>(joint.limits()), question,
          ranges](const TrueLimit& motion) {
    const TurnLimit found = limits->first_contact(motion.turn, motion.largest_deg);
    if (ranges)
      benchmark::DoNotOptimize(limits->centre_interval(motion.turn, found, motion.largest_deg, question));
    return angle_of(found, motion.largest_deg);
  };
}

AskedLimits of_ours(const TurnedJoint& joint, const std::vector<TrueLimit>& motions, bool ranges,
                    int rounds) {
  AskedLimits asked;
  asked.method = ranges ? kRanges : kOurs;
  asked.motions = motions.size();
  asked.rounds = rounds;
  const auto make = [&] {
    FindLimit limit = ours(joint, ranges);
    if (ranges) limit(motions.front());  // the first motion includes what all ranges share
    return limit;
  };
  asked.limit = built(make, asked.building_ms);
  return asked;
}

std::vector<AskedLimits> of_steps(const TurnedJoint& joint, const std::vector<TrueLimit>& motions,
                                  const LimitPlan& plan, LimitTimes& found) {
  std::vector<AskedLimits> all;
  const std::vector<ContactCase> cases = cases_of(steps_methods(), &Method::steps, joint.bones);
  add_labels(found.labels, cases);
  for (const ContactCase& one : cases) {
    double building_ms = 0.0;
    const Touch touches = built([&one] { return one.make().touches; }, building_ms);
    for (const double step : one.few ? plan.few_steps_deg : plan.steps_deg) {
      AskedLimits asked;
      asked.method = one.name;
      asked.step_deg = step;
      asked.building_ms = building_ms;
      asked.motions = std::min(one.few ? plan.few_motions : plan.motions, motions.size());
      asked.limit = [touches, step](const TrueLimit& motion) { return march(touches, motion, step); };
      asked.rounds = one.few ? plan.few_rounds : plan.rounds;
      all.push_back(std::move(asked));
    }
  }
  return all;
}

void find(AskedLimits& asked, const std::vector<TrueLimit>& motions) {
  Stopwatch watch;
  for (std::size_t k = 0; k < asked.motions; ++k) asked.found_deg.push_back(asked.limit(motions[k]));
  asked.seconds = watch.lap_s();
}

// Finds the truth from the answers of all methods.
void settle(const TurnedJoint& joint, const std::vector<AskedLimits>& all, const TurnLimits& limits,
            const Touch& exact, std::vector<TrueLimit>& motions) {
  for (std::size_t k = 0; k < motions.size(); ++k) {
    TrueLimit& motion = motions[k];
    const TurnLimit ours = limits.first_contact(motion.turn, motion.largest_deg);
    const auto contradicted = [&](double angle_deg) {
      return std::runtime_error(joint.name + ", " + motion.name +
                                ": the exact test contradicts the limit, at " + Cell(angle_deg).text());
    };
    motion.deg = motion.largest_deg;
    if (ours.state == LimitState::limited) {
      if (!exact(pose_at(motion.turn, ours.high_deg))) throw contradicted(ours.high_deg);
      motion.deg = ours.high_deg;
    }
    if (motion.known_deg && !(std::abs(motion.deg - *motion.known_deg) < kClosedForm))
      throw std::runtime_error(joint.name + ", " + motion.name + ": the limit, " + Cell(motion.deg).text() +
                               ", is not that of its closed form, " + Cell(*motion.known_deg).text());
    for (const AskedLimits& asked : all) {
      if (k >= asked.motions || asked.found_deg[k] >= motion.deg) continue;
      if (!exact(pose_at(motion.turn, asked.found_deg[k]))) continue;  // no: the surfaces are apart
      motion.deg = asked.found_deg[k];
      if (motion.deg < ours.low_deg) throw contradicted(motion.deg);
    }
  }
}

void run_all(const AskedLimits& asked, const std::vector<TrueLimit>& motions) {
  const double before = cpu_now_ms();
  for (std::size_t k = 0; k < asked.motions; ++k) benchmark::DoNotOptimize(asked.limit(motions[k]));
  asked.cpu_ms->push_back(cpu_now_ms() - before);
}

std::vector<double> errors_of(const AskedLimits& asked, const std::vector<TrueLimit>& motions) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < asked.motions; ++k)
    errors.push_back(std::abs(asked.found_deg[k] - motions[k].deg));
  return errors;
}

std::size_t missed_by(const AskedLimits& asked, const std::vector<TrueLimit>& motions) {
  std::size_t missed = 0;
  for (std::size_t k = 0; k < asked.motions; ++k)
    missed += asked.found_deg[k] > motions[k].deg + kMissed ? 1U : 0U;
  return missed;
}

// Poses of all motions divided by the poses of those that the method answers.
double share_of(const AskedLimits& asked, const std::vector<TrueLimit>& motions) {
  if (asked.motions == motions.size()) return 1.0;
  const double step = std::stod(asked.step_deg.text());
  double some = 0.0;
  double all = 0.0;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    all += poses_of(motions[k], step);
    if (k < asked.motions) some += poses_of(motions[k], step);
  }
  return all / some;
}

void add_rows(const std::vector<AskedLimits>& all, const std::vector<TrueLimit>& motions,
              const TimingRun& run, Table& table) {
  const double ours_ms = all.front().building_ms + summarise(*all.front().cpu_ms).median;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const AskedLimits& asked = all[k];
    const Timing& timing = run.timings[k];
    const std::vector<double> errors = errors_of(asked, motions);
    const double scale = share_of(asked, motions);
    const double cpu_ms = scale * summarise(*asked.cpu_ms).median;
    std::vector<Cell> row = timing.key;
    row.insert(row.end(),
               {motions.size(), asked.motions, missed_by(asked, motions), std::ranges::max(errors),
                summarise(errors).median, asked.building_ms, cpu_ms, (asked.building_ms + cpu_ms) / ours_ms,
                scale * timing.summary.median, scale * timing.summary.iqr, timing.summary.count,
                asked.motions < motions.size(), timing.inconclusive});
    table.add_row(std::move(row));
  }
}

}  // namespace

LimitPlan limit_plan(bool quick) {
  LimitPlan plan;
  plan.steps_deg = {5.0, 1.0, 0.5, 0.1};
  plan.few_steps_deg = quick ? std::vector{5.0, 1.0} : std::vector{5.0, 1.0, 0.1};
  if (quick) plan.few_motions = 3;
  plan.rounds = quick ? 3 : 7;
  plan.few_rounds = quick ? 2 : 3;
  if (!quick) return plan;
  plan.timing.slow_ms = 200.0;
  plan.timing.repeat_share = 0.05;
  plan.timing.least_repeat_s = 1.0;
  return plan;
}

std::vector<Column> limit_time_keys() {
  return {
      {"joint", "", "a generated hip, a replaced one, or the folder of a real joint whose bones are whole"},
      {"faces", "1", "of ball and socket together"},
      {"method", "",
       "turn_limit: limits/turn_limit.hpp; with _ranges: also the limits of every centre within 0.5 mm; "
       "others: steps until a pose touches, then halvings to 0.01 degrees"},
      {"step_deg", "deg", "of the steps; empty where there are none"}};
}

LimitTimes empty_limit_times() {
  LimitTimes found;
  found.labels = {{kOurs, "ours"}, {kRanges, "ours, with ranges"}};
  found.table.columns = limit_time_keys();
  found.table.columns.insert(
      found.table.columns.end(),
      {{"motions", "1", "named motions that begin clear"},
       {"asked", "1", "of these, the first so many were asked for, and errors are of these"},
       {"missed", "1",
        "of these, in which the surfaces met more than 0.02 degrees before the angle it found, or it found "
        "none: proven by exact signs"},
       {"largest_error_deg", "deg", "from the smallest angle at which the surfaces were proven to meet"},
       {"median_error_deg", "deg", "median of the same"},
       {"building_ms", "ms",
        "processor time of what is made once for a joint, median; of ranges with the first"},
       {"cpu_ms", "ms", "processor time of all motions after building, median"},
       {"times_ours", "1", "building and all motions, over those of turn_limit"},
       {"median_ms", "ms", "of all motions after building, median over the rounds, wall clock"},
       {"iqr_ms", "ms", "interquartile range of it"},
       {"rounds", "1", "rounds measured"},
       {"extrapolated", "", "yes: the times are scaled by poses from those that were asked for to all"},
       {"inconclusive", "", "yes: the spread or that of the control of its run is too large"}});
  return found;
}

void add_limit_times(const TurnedJoint& joint, const LimitPlan& plan, LimitTimes& found, Progress& progress) {
  const TurnLimits limits = joint.limits();
  const Touch exact = make_cgal_tree(joint.bones.ball, joint.bones.socket);
  std::vector<TrueLimit> motions = motions_of(joint, limits);
  progress.say(joint.name + ": " + std::to_string(motions.size()) + " motions");
  if (motions.empty()) return;
  std::vector<AskedLimits> all{of_ours(joint, motions, false, plan.rounds),
                               of_ours(joint, motions, true, plan.rounds)};
  std::ranges::move(of_steps(joint, motions, plan, found), std::back_inserter(all));
  for (AskedLimits& asked : all) find(asked, motions);
  settle(joint, all, limits, exact, motions);
  std::vector<TimedCase> cases;
  for (const AskedLimits& asked : all) {
    TimedCase timed;
    timed.key = {joint.name, joint.faces(), asked.method, asked.step_deg};
    timed.run = [&asked, &motions] { run_all(asked, motions); };
    timed.rounds = asked.rounds;
    if (1e3 * asked.seconds > plan.timing.slow_ms) {
      timed.expected_s = asked.seconds;
      timed.rounds = std::min(2, asked.rounds);
    }
    cases.push_back(std::move(timed));
  }
  TimingRun run = run_interleaved(cases, plan.timing, progress);
  add_rows(all, motions, run, found.table);
  append(found.timing, std::move(run));
}

}  // namespace impinge::lab
