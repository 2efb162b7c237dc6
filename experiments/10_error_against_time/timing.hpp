// SPDX-License-Identifier: GPL-3.0-or-later
// The three costs of a method, apart: building it, asking it cold, asking it warm.
//
// In each round every method is, in an order drawn anew, built (timed), asked once for the ball's vertices
// after a block of memory larger than the cores' own caches was written (cold), asked once untimed, and asked
// as often as a round must take (warm). The method is let go before the next one comes, so that all are
// measured on the same heap; one that is slow to build is built in the first round alone and kept. Wall
// clock, one thread.
//
// A/A control: the even and the odd rounds are two measurements of the same method under the same
// interleaving. The ratio of their medians shows what differences of this run mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "harness/progress.hpp"
#include "methods/points.hpp"

namespace impinge::lab {

// How often and how long everything is timed.
struct BenchmarkTimingOptions {
  int rounds = 7;                      // 2 or more
  double warm_ms = 5.0;                // a warm measurement takes so long at least
  double batch_ms = 50.0;              // one batch of questions takes about so long at most
  double slow_build_ms = 300.0;        // a method slower to build is built once
  std::size_t flush_bytes = 64 << 20;  // written before a cold batch
  std::uint64_t seed = 0;              // of the order
};

// Samples in the order of the rounds; ns are those of one point (of one vertex of the ball for
// Measure::pose).
struct BenchmarkCosts {
  std::vector<double> build_ms;  // of building
  std::vector<double> cold_ns;   // of asking cold
  std::vector<double> warm_ns;   // of asking warm
  double bytes = 0.0;            // of what was built
  std::size_t batch = 0;         // points of one batch
};

// In the order of the methods. std::invalid_argument for fewer than two rounds.
std::vector<BenchmarkCosts> time_methods(std::span<const PointCase> methods, const BenchmarkScene& scene,
                                         const BenchmarkTimingOptions& options, Progress& progress);

// Median of the odd rounds over that of the even ones.
double control_ratio(std::span<const double> samples);

// Is `a` faster or slower than `b`, by more than both of them differ from themselves? "faster", "slower" or
// "inconclusive".
const char* compare_times(std::span<const double> a, std::span<const double> b);

}  // namespace impinge::lab
