// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that is counted is that which was allocated, and that which was read or written of it.
#include "12_scene_needs/used_memory.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

TEST(UsedMemory, PeakAndTouched) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers have memory of their own";
#endif
  auto input = std::make_shared<std::vector<char>>();
  const auto prepare = [&] { input->assign(64 * kMiB, 1); };
  const auto work = [&]() -> Kept {
    { const std::vector<char> freed(32 * kMiB, 2); }
    auto made = std::make_shared<std::vector<char>>(16 * kMiB, 3);
    for (std::size_t k = 0; k < input->size() / 8; k += 64) made->front() ^= (*input)[k];
    return made;
  };
  const UsedMemory used = used_memory(prepare, work);
  if (std::isnan(used.peak_bytes)) GTEST_SKIP() << "the kernel does not count";
  const auto mib = static_cast<double>(kMiB);
  EXPECT_NEAR(used.peak_bytes, 32.0 * mib, 2.0 * mib);             // the rest follows where it was
  EXPECT_NEAR(used.touched_bytes, (32.0 + 8.0) * mib, 2.0 * mib);  // an eighth of the input
}

TEST(UsedMemory, AFailureIsSaid) {
  EXPECT_THROW(used_memory([] {}, []() -> Kept { throw std::bad_alloc(); }), std::runtime_error);
}

}  // namespace
}  // namespace impinge::lab
