// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the wall-clock time of a stretch of work. Repeating it is up to the caller (harness/timing.hpp).
#pragma once

#include <chrono>

namespace impinge {

/// A stopwatch that starts when it is constructed.
class Stopwatch {
 public:
  /// Milliseconds since the start or the last lap; begins the next lap.
  double lap_ms() {
    const auto now = std::chrono::steady_clock::now();
    const double elapsed = std::chrono::duration<double, std::milli>(now - start_).count();
    start_ = now;
    return elapsed;
  }
  double lap_s() { return 1e-3 * lap_ms(); }  // as lap_ms(), in seconds

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace impinge
