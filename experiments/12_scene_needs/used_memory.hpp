// SPDX-License-Identifier: GPL-3.0-or-later
// What memory a piece of work takes and touches, whatever library does it: the kernel counts.
#pragma once

#include <functional>
#include <memory>

namespace impinge::lab {

/// Everything that a piece of work made, so that none of it is freed before it is counted.
using Kept = std::shared_ptr<const void>;

struct UsedMemory {
  double peak_bytes = 0.0;     // most of the resident set beyond what was there before
  double touched_bytes = 0.0;  // pages of 4 KiB that were read or written, the input's included; code is not
};

/// Of work() after prepare(), in a process of its own, at the second time: what is set up once in a process
/// does not count. NaN where the kernel does not count (Linux's /proc/self/clear_refs). No other thread may
/// run.
UsedMemory used_memory(const std::function<void()>& prepare, const std::function<Kept()>& work);

}  // namespace impinge::lab
