// SPDX-License-Identifier: GPL-3.0-or-later
// How far a run is and how long it will still take: one line every few seconds.
#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <string_view>

namespace impinge::lab {

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

}  // namespace impinge::lab
