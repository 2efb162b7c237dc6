// SPDX-License-Identifier: GPL-3.0-or-later
// Work that is shared by a few threads for a moment.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace impinge {

/// Calls work(0) ... work(threads - 1) at the same time and waits; throws what the first of them threw.
inline void on_threads(std::size_t threads, const std::function<void(std::size_t)>& work) {
  std::vector<std::exception_ptr> failures(threads);
  const auto guarded = [&](std::size_t thread) {
    try {
      work(thread);
    } catch (...) {
      failures[thread] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t thread = 1; thread < threads; ++thread) others.emplace_back(guarded, thread);
    guarded(0);
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

/// Part `part` of `parts` of 0 ... size - 1, as even as can be.
struct Share {
  std::size_t first;  // of the part
  std::size_t end;    // behind its last one
};
/// That part; parts above 0.
inline Share share_of(std::size_t size, std::size_t part, std::size_t parts) {
  return {size * part / parts, size * (part + 1) / parts};
}

}  // namespace impinge
