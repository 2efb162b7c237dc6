// SPDX-License-Identifier: GPL-3.0-or-later
// The rule by which timings are repeated, on made-up timings and a made-up clock.
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "harness/timing.hpp"

namespace impinge::lab {
namespace {

// A machine whose clock stands still but for what it times. A repeat is steady from the given one on.
struct FakeMachine {
  std::map<std::string, int> steady_from;  // by case; never where it is not named
  std::map<std::string, int> timed;        // how often each case was
  std::map<std::string, int> rounds;       // that it was asked for, last
  std::vector<std::string> order;
  double now_s = 0.0;
  double repeat_s = 1.0;

  RepeatMeans means(double budget_s) {
    return {budget_s, [this](const TimedCase& work) { return time(work); }, [this] { return now_s; }};
  }
  TimingRun time(const TimedCase& work) {
    const std::string name = key_text(work.key);
    now_s += repeat_s;
    order.push_back(name);
    rounds[name] = work.rounds;
    TimingRun run;
    run.timings.emplace_back();
    run.timings[0].key = work.key;
    run.timings[0].summary = {100.0 + ++timed[name], 0.0, static_cast<std::size_t>(work.rounds)};
    run.timings[0].inconclusive = !steady_from.contains(name) || timed[name] < steady_from[name];
    return run;
  }
};

TimedCase case_of(const std::string& name, int rounds = 5) {
  TimedCase work;
  work.key = {name};
  work.rounds = rounds;
  return work;
}

// A first pass: each case took `median_ms`, and is inconclusive or not.
struct FirstPass {
  std::vector<TimedCase> cases;
  TimingRun run;
  Progress progress{"test", nullptr};

  void add(const TimedCase& work, double median_ms, bool inconclusive) {
    cases.push_back(work);
    run.timings.emplace_back();
    run.timings.back().key = work.key;
    run.timings.back().summary = {median_ms, 0.0, static_cast<std::size_t>(work.rounds)};
    run.timings.back().inconclusive = inconclusive;
  }
  void repeat(FakeMachine& machine, double budget_s) {
    repeat_inconclusive(run, cases, machine.means(budget_s), progress);
  }
};

TEST(TimingRepeats, LeavesAloneWhatIsConclusive) {
  FirstPass pass;
  pass.add(case_of("a"), 1.0, false);
  FakeMachine machine;
  pass.repeat(machine, 1e3);
  EXPECT_TRUE(machine.order.empty());
  EXPECT_EQ(pass.run.timings[0].repeats, 0);
  EXPECT_EQ(pass.run.timings[0].summary.median, 1.0);
}

void expect_repeats_of_one(int steady_from, int repeats, bool inconclusive) {
  FirstPass pass;
  pass.add(case_of("a"), 1.0, true);
  FakeMachine machine;
  machine.steady_from["a"] = steady_from;
  pass.repeat(machine, 1e3);
  EXPECT_EQ(machine.timed["a"], repeats);
  EXPECT_EQ(pass.run.timings[0].repeats, repeats);
  EXPECT_EQ(pass.run.timings[0].inconclusive, inconclusive);
  EXPECT_EQ(pass.run.timings[0].summary.median, 100.0 + repeats);
}

TEST(TimingRepeats, StopsAtTheFirstConclusiveRepeatAndKeepsIt) { expect_repeats_of_one(2, 2, false); }

TEST(TimingRepeats, AfterThreeRepeatsItIsPublishedAsInconclusive) { expect_repeats_of_one(4, 3, true); }

TEST(TimingRepeats, GivesACaseOfOneRoundASpread) {
  FirstPass pass;
  pass.add(case_of("a", 1), 1.0, true);
  FakeMachine machine;
  machine.steady_from["a"] = 1;
  pass.repeat(machine, 1e3);
  EXPECT_EQ(machine.rounds["a"], 3);
  EXPECT_EQ(pass.run.timings[0].summary.count, 3U);
}

TEST(TimingRepeats, TakesTheCheapestFirstAndKeepsToTheBudget) {
  FirstPass pass;
  pass.add(case_of("slow", 10), 1000.0, true);  // 10 rounds and 10 of the control: 20 s
  pass.add(case_of("fast", 10), 10.0, true);    // 0.2 s
  pass.add(case_of("middle", 10), 90.0, true);  // 1.8 s
  FakeMachine machine;
  machine.steady_from = {{"slow", 1}, {"fast", 1}, {"middle", 9}};
  machine.repeat_s = 4.0;
  pass.repeat(machine, 9.5);  // fast until 4 s, middle until 8 s; 1.8 s more would end at 9.8 s
  EXPECT_EQ(machine.order, (std::vector<std::string>{"fast", "middle"}));
  EXPECT_TRUE(pass.run.timings[0].inconclusive);
  EXPECT_EQ(pass.run.timings[0].repeats, 0);
  EXPECT_EQ(pass.run.timings[0].summary.median, 1000.0);
  EXPECT_FALSE(pass.run.timings[1].inconclusive);
  EXPECT_TRUE(pass.run.timings[2].inconclusive);
  EXPECT_EQ(pass.run.timings[2].repeats, 1);
}

TEST(TimingRepeats, ARunMayAskForNone) {
  FirstPass pass;
  pass.run.options.most_repeats = 0;
  pass.add(case_of("a"), 1.0, true);
  FakeMachine machine;
  pass.repeat(machine, 1e3);
  EXPECT_TRUE(machine.order.empty());
}

}  // namespace
}  // namespace impinge::lab
