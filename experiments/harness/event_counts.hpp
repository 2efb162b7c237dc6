// SPDX-License-Identifier: GPL-3.0-or-later
// Instructions and misses of a simulated cache, counted by valgrind's callgrind. Instructions are the same in
// every run, where times are not; misses depend a little on where memory lies. Callgrind knows no AVX-512,
// and a program that asks for instruction sets is told so.
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
  double instructions = 0.0;   // that were run
  double first_misses = 0.0;   // data that were not in a first cache of 32 KiB, 8 ways, lines of 64 bytes
  double second_misses = 0.0;  // of these, not in one of 1 MiB either, 16 ways: more than a table of a kernel
};

// In the program that is counted: counts the third of three runs, which finds warm caches. Without valgrind
// it runs as often and counts nothing.
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

// What the program `words` does in the first thread of its calls of count_run(), in their order. Callgrind's
// files are in a folder of their own in `folder`, gone at the end. std::runtime_error where valgrind is not
// installed, or the program fails under it.
std::vector<EventCounts> count_events(const std::vector<std::string>& words,
                                      const std::filesystem::path& folder);

// One file of callgrind's; std::runtime_error for a text that is none.
EventCounts parse_event_counts(std::string_view dump);

}  // namespace impinge::lab
