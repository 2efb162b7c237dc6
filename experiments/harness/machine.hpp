// SPDX-License-Identifier: GPL-3.0-or-later
// The machine that a result was measured on, as the operating system reports it. Only reads.
#pragma once

#include <cstdint>
#include <string>

namespace impinge::lab {

struct Machine {
  std::string cpu = "unknown";       // model name
  unsigned cores = 0;                // logical processors
  std::uint64_t memory_mib = 0;      // physical memory, MiB
  std::string governor = "unknown";  // frequency governor of the first core
  double load = 0.0;                 // average of runnable processes over the last minute
  std::string system = "unknown";    // name and release of the operating system, processor family
};

Machine this_machine();  // as it is now

}  // namespace impinge::lab
