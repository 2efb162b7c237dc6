// SPDX-License-Identifier: GPL-3.0-or-later
// Lets the kernel count how much memory a piece of work takes and touches, whatever library does it.
#pragma once

#include <functional>
#include <memory>

namespace impinge::lab {

/// Everything that a piece of work made; it must not be freed before it is counted.
using Kept = std::shared_ptr<const void>;

struct UsedMemory {
  double peak_bytes = 0.0;     // largest resident set beyond what was there before
  double touched_bytes = 0.0;  // pages of 4 KiB that were read or written, input included, code not
};

/// Memory of the second run of work() after prepare(), in a separate process. What is set up once in a
/// process thus does not count. NaN where the kernel does not count (/proc/self/clear_refs of Linux). No
/// other thread may run.
UsedMemory used_memory(const std::function<void()>& prepare, const std::function<Kept()>& work);

}  // namespace impinge::lab
