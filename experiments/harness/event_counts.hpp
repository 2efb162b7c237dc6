// SPDX-License-Identifier: GPL-3.0-or-later
// Instructions and misses of a simulated cache, counted by valgrind's callgrind. Unlike times, instructions
// are the same in every run; misses depend a little on where memory lies. Callgrind has no AVX-512, and
// reports so to a program that asks for instruction sets.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <valgrind/callgrind.h>

namespace impinge::lab {

// What a stretch of a program did.
struct EventCounts {
  std::string label;           // as given to count_run()
  double instructions = 0.0;   // executed
  double first_misses = 0.0;   // data accesses that miss a cache of 32 KiB, 8 ways, lines of 64 bytes
  double second_misses = 0.0;  // of these, that miss one of 1 MiB, 16 ways, too
};

// Called in the program that is counted: runs three times and counts the third run, which finds warm caches.
// Without valgrind it runs as often and counts nothing.
template <class Run>
void count_run(const std::string& label, Run&& run) {
  run();
  CALLGRIND_START_INSTRUMENTATION;
  run();
  CALLGRIND_ZERO_STATS;
  run();
  CALLGRIND_DUMP_STATS_AT(label.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
}

// Runs the command line `words` under callgrind and returns the counts of its calls of count_run() in its
// first thread, in their order. Callgrind's files are kept in a temporary folder in `folder`.
// std::runtime_error if valgrind is not installed or the program fails under it.
std::vector<EventCounts> count_events(const std::vector<std::string>& words,
                                      const std::filesystem::path& folder);

// Reads the text of one callgrind file; std::runtime_error if it is none.
EventCounts parse_event_counts(std::string_view dump);

}  // namespace impinge::lab
