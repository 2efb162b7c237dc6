// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a piece of work on several threads and waits for them.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace impinge {

/// Calls work(0) ... work(threads - 1) at the same time and waits for all. If some of them throw, the
/// exception of the lowest number is rethrown. Where no more threads can be started, as in WebAssembly, the
/// calling thread does the rest.
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
    struct Joined {  // as std::jthread, which the library of WebAssembly lacks
      explicit Joined(std::thread begun) : thread(std::move(begun)) {}
      ~Joined() { thread.join(); }
      std::thread thread;
    };
    std::vector<std::unique_ptr<Joined>> others;
    others.reserve(threads);  // so that the list cannot run out of memory after a thread was started
    std::size_t begun = 1;
    try {
      for (; begun < threads; ++begun)
        others.emplace_back(new Joined{std::thread(guarded, begun)});  // clang 14 has no make_unique of it
    } catch (const std::system_error&) {
    }
    guarded(0);
    for (; begun < threads; ++begun) guarded(begun);
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace impinge
