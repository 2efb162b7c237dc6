// SPDX-License-Identifier: GPL-3.0-or-later
// How many random cases of a kind a test tries against something that is called proven.
#pragma once

#include <cstddef>
#include <cstdlib>

namespace impinge {

// 1,000, or what IMPINGE_CASES says: tests/run asks the optimised build for 10,000 in the gate and 100,000 at
// night.
inline std::size_t random_cases() {
  const char* asked = std::getenv("IMPINGE_CASES");  // NOLINT(concurrency-mt-unsafe)
  return asked == nullptr ? 1000 : std::strtoull(asked, nullptr, 10);
}

}  // namespace impinge
