// SPDX-License-Identifier: GPL-3.0-or-later
// What all numbered drivers share: options, checks before the work, one clear line on failure.
//
//   NAME [--out DIR] [--profile quick|full] [--seed N] [--bones DIR]
//
// Exit code 0 on success, 1 when the work fails, 2 for a wrong option. An error is one line on stderr,
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

// How far a run is and how long it will still take: one line every few seconds.

// Text such as "2 min 05 s" for a duration in seconds.
std::string duration_text(double seconds);

class Progress {
 public:
  // Prints to the stream, or nothing at all for a null stream. The stream must outlive this object.
  Progress(std::string name, std::ostream* out) : name_(std::move(name)), out_(out) {}

  // Prints a line at once.
  void say(std::string_view text);

  // Begins a stretch of work that is expected to take so many seconds.
  void begin(double expected_s);

  // A piece of work that was expected to take so many seconds has been done.
  void advance(double expected_s, std::string_view what);

  // Seconds left: the work not done yet, at the pace of the work done so far.
  double seconds_left() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::string name_;
  std::ostream* out_;
  double expected_ = 0.0;  // seconds, whole stretch
  double done_ = 0.0;      // seconds of that, as expected
  Clock::time_point start_ = Clock::now();
  Clock::time_point printed_ = Clock::now();
};

// What a driver is, for its options and messages.
struct DriverInfo {
  std::string name;          // of the program
  std::string purpose;       // one sentence for --help
  bool takes_bones = false;  // has it the option --bones?
};

// What run_driver() passes to the body of a driver.
struct DriverRun {
  RunRecord record;                            // for the sidecars of the results
  std::optional<std::filesystem::path> bones;  // folder with one folder a subject
  Progress progress;                           // reports how far the work is

  bool quick() const { return record.profile == "quick"; }  // is it the quick profile?
  // Writes the result and says where.
  void write(const Result& result);
};

// Parses, checks that the output folder can be written, runs the body. The returned value is the exit code.
int run_driver(int argc, const char* const* argv, const DriverInfo& info,
               const std::function<void(DriverRun&)>& body);

}  // namespace impinge::lab
