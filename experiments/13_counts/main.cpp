// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How many instructions does a gap take, and does a table fit the caches?
// @writes    counts
// @seconds   12 12
// @links     harness benchmark_scene gaps_methods contact_methods instruction_set
//
// Counted by valgrind, not timed: instructions are the same in every run. The program starts itself under it,
// with an option of its own. Each way is counted in its third run, with warm caches; on instruction sets up
// to AVX2, which is what valgrind knows.

#include <cstring>
#include <filesystem>

#include "13_counts/count_study.hpp"
#include "harness/driver.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr const char* kCounted = "--counted";

void body(DriverRun& run) {
  const CountOptions options;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  Result result{"counts", "Instructions and misses of a cache of a vertex, or of a pose, of every way?"};
  result.parameters = {
      {"triangles", options.triangles}, {"poses", options.poses}, {"counted_by", "callgrind"}};
  result.table = count_table(count_events({self, kCounted}, run.record.folder));
  result.labels = counted_labels();
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], kCounted) == 0) {
    impinge::lab::run_counted({});
    return 0;
  }
  return impinge::lab::run_driver(argc, argv, {"13_counts", "Instructions and misses of a cache of a gap."},
                                  body);
}
