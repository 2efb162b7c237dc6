// SPDX-License-Identifier: GPL-3.0-or-later
// What all numbered drivers share: options, checks before the work, and one clear line on failure.
//
//   NAME [--out DIR] [--profile quick|full] [--seed N] [--bones DIR]
//
// The exit code is 0 on success, 1 when the work fails, 2 for a wrong option. An error is one line on stderr:
// "NAME: error: what is wrong: what to do".
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "harness/provenance.hpp"

namespace impinge::lab {

// Reports how far a run is and how long it will still take, in one line every few seconds.

// Text such as "2 min 05 s" for a duration in seconds.
std::string duration_text(double seconds);

class Progress {
 public:
  // Prints to the stream, or nothing for a null stream. The stream must outlive this object.
  Progress(std::string name, std::ostream* out) : name_(std::move(name)), out_(out) {}

  // Prints a line at once.
  void say(std::string_view text);

  // Begins work that is expected to take so many seconds.
  void begin(double expected_s);

  // Reports that a part of it, expected to take so many seconds, is done.
  void advance(double expected_s, std::string_view what);

  // Seconds left: the remaining work, at the pace of the work done so far.
  double seconds_left() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::string name_;
  std::ostream* out_;
  double expected_ = 0.0;  // seconds, for all of it
  double done_ = 0.0;      // seconds, for the part that is done
  Clock::time_point start_ = Clock::now();
  Clock::time_point printed_ = Clock::now();
};

// A driver's texts and options.
struct DriverInfo {
  std::string name;          // of the program
  std::string purpose;       // one sentence for --help
  bool takes_bones = false;  // does it have the option --bones?
};

// What run_driver() passes to the body of a driver.
struct DriverRun {
  RunRecord record;                            // for the sidecars of the results
  std::optional<std::filesystem::path> bones;  // folder with one folder per subject
  Progress progress;                           // for progress reports

  bool quick() const { return record.profile == "quick"; }  // is it the quick profile?
  // Writes the result and says where.
  void write(const Result& result);
};

// Parses the options, checks that the output folder can be written, and runs the body. Returns the exit code.
int run_driver(int argc, const char* const* argv, const DriverInfo& info,
               const std::function<void(DriverRun&)>& body);

}  // namespace impinge::lab
