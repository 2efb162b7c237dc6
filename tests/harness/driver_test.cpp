// SPDX-License-Identifier: GPL-3.0-or-later
// Exit codes and the one line of an error.
#include "harness/driver.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "harness/driver.hpp"
#include "support/temporary_folder.hpp"

namespace impinge::lab {
namespace {

using test::TemporaryFolder;

// What a driver with these arguments returns and prints.
struct Outcome {
  int code = 0;
  std::string errors;
  bool ran = false;
};

Outcome call(std::vector<const char*> arguments, const std::function<void(DriverRun&)>& body = {},
             bool takes_bones = true) {
  arguments.insert(arguments.begin(), "/some/folder/99_test");
  Outcome outcome;
  testing::internal::CaptureStderr();
  outcome.code = run_driver(static_cast<int>(arguments.size()), arguments.data(),
                            {"99_test", "A test.", takes_bones}, [&](DriverRun& run) {
                              outcome.ran = true;
                              if (body) body(run);
                            });
  outcome.errors = testing::internal::GetCapturedStderr();
  return outcome;
}

TEST(Driver, HandsTheOptionsToTheBody) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "data").string();
  const std::string bones = folder.path().string();
  const Outcome outcome = call(
      {"--out", out.c_str(), "--profile", "quick", "--seed", "9", "--bones", bones.c_str()},
      [&](DriverRun& run) {
        EXPECT_TRUE(run.quick());
        EXPECT_EQ(run.record.seed, 9U);
        EXPECT_EQ(run.record.folder, out);
        EXPECT_EQ(run.bones, bones);
        EXPECT_EQ(run.record.command, "99_test --out " + out + " --profile quick --seed 9 --bones BONES");
      });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(outcome.ran);
}

TEST(Driver, IsFullByDefault) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  call({"--out", out.c_str()}, [](DriverRun& run) { EXPECT_FALSE(run.quick()); });
}

TEST(Driver, WrongOptionsAreOneLineAndCodeTwo) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  std::ofstream(folder.path() / "plain") << "a file";
  const std::string no_folder = (folder.path() / "plain").string();
  const std::vector<std::vector<const char*>> wrong{{"--frobnicate"},
                                                    {"--profile", "medium"},
                                                    {"--seed", "-1"},
                                                    {"--seed", "x"},
                                                    {"--out"},
                                                    {"--bones", "/no/such/folder"},
                                                    {"--out", no_folder.c_str()}};
  for (const auto& arguments : wrong) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments.front();
    EXPECT_FALSE(outcome.ran) << arguments.front();
    EXPECT_EQ(outcome.errors.rfind("99_test: error: ", 0), 0U) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  }
}

TEST(Driver, WithoutRealJointsThereIsNoSuchOption) {
  EXPECT_EQ(call({"--bones", "/"}, {}, /*takes_bones=*/false).code, 2);
}

TEST(Driver, AFailureOfTheWorkIsOneLineAndCodeOne) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const Outcome outcome =
      call({"--out", out.c_str()}, [](DriverRun&) { throw std::runtime_error("femur.ply: cut short"); });
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.errors, "99_test: error: femur.ply: cut short\n");
}

TEST(Progress, DurationsReadWell) {
  EXPECT_EQ(duration_text(-1.0), "0 s");
  EXPECT_EQ(duration_text(0.2), "1 s");
  EXPECT_EQ(duration_text(59.0), "59 s");
  EXPECT_EQ(duration_text(65.0), "1 min 05 s");
  EXPECT_EQ(duration_text(3600.0), "60 min 00 s");
}

TEST(Progress, EachMessageIsALineThatBeginsWithTheName) {
  std::ostringstream out;
  Progress progress("02_sampling_time", &out);
  progress.say("verifying");
  EXPECT_EQ(out.str(), "02_sampling_time: verifying\n");
}

TEST(Progress, TimeLeftIsTheExpectationUntilWorkIsDoneAndZeroAtTheEnd) {
  Progress progress("test", nullptr);
  progress.begin(100.0);
  EXPECT_DOUBLE_EQ(progress.seconds_left(), 100.0);
  progress.advance(60.0, "a");
  progress.advance(60.0, "b");  // more than expected
  EXPECT_DOUBLE_EQ(progress.seconds_left(), 0.0);
}

}  // namespace
}  // namespace impinge::lab
