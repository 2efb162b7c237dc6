// SPDX-License-Identifier: GPL-3.0-or-later
// Wall-clock time of a stretch of work. Repetition and order are up to the caller (harness/timing.hpp).
#pragma once

#include <chrono>

namespace impinge {

/// Starts when it is made.
class Stopwatch {
 public:
  /// Milliseconds since the start or the last lap; begins the next lap.
  double lap_ms() {
    const auto now = std::chrono::steady_clock::now();
    const double elapsed = std::chrono::duration<double, std::milli>(now - start_).count();
    start_ = now;
    return elapsed;
  }
  double lap_s() { return 1e-3 * lap_ms(); }  // the same, seconds

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace impinge
