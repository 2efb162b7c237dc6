// SPDX-License-Identifier: GPL-3.0-or-later
// A set of entries, against std::set: same entries, slots in ascending order.
#include "sphere/entry_set.hpp"

#include <random>
#include <set>

#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(EntrySet, HoldsWhatWasInsertedAndNumbersIt) {
  constexpr std::size_t kSize = 100'000;
  std::mt19937 random(3);
  std::set<std::size_t> oracle{0, 63, 64, 4095, 4096, kSize - 1};
  for (int k = 0; k < 500; ++k) oracle.insert(20'000 + random() % 9000);  // whole chunks stay empty
  EntrySet set(kSize);
  for (const std::size_t entry : oracle) set.insert(entry);
  set.insert(64);  // again
  set.number();
  EXPECT_EQ(set.count(), oracle.size());
  std::size_t slot = 0;
  for (const std::size_t entry : oracle) EXPECT_EQ(set.slot(entry), slot++);
  for (std::size_t entry = 0; entry < kSize; ++entry) {
    EXPECT_EQ(set.contains(entry), oracle.contains(entry)) << entry;
    EXPECT_EQ(set.slot(entry).has_value(), oracle.contains(entry)) << entry;
  }
  std::vector<std::size_t> visited;
  set.for_each([&](std::size_t entry) { visited.push_back(entry); });
  EXPECT_EQ(visited, std::vector<std::size_t>(oracle.begin(), oracle.end()));
}

TEST(EntrySet, TakesLittleMemoryForWhatItDoesNotHold) {
  EntrySet set(6'480'000);  // RSID at 0.1 degrees
  set.number();
  EXPECT_EQ(set.count(), 0U);
  EXPECT_LT(set.bytes(), 7000U);
  EntrySet one(6'480'000);
  one.insert(6'479'999);
  one.number();
  EXPECT_EQ(one.slot(6'479'999), 0U);
  EXPECT_LT(one.bytes(), set.bytes() + 1000U);
}

}  // namespace
}  // namespace impinge
