// SPDX-License-Identifier: GPL-3.0-or-later
// What a stretch of work takes on the wall clock. How often it is repeated, and in which order, is not
// decided here (harness/timing.hpp).
#pragma once

#include <chrono>

namespace impinge {

/// Runs from its making.
class Stopwatch {
 public:
  /// Since its making or the last lap, milliseconds; begins the next lap.
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
