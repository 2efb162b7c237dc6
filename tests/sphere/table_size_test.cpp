// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of more than 2^37 entries are refused with their bytes, before memory is asked for.
#include "sphere/table_size.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "sphere/radial_table.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

TEST(TableSize, UpToTheMostIsTaken) {
  EXPECT_EQ(require_table_size("rsid", 0), 0U);
  EXPECT_EQ(require_table_size("rsid", kMostTableEntries), kMostTableEntries);
  EXPECT_THROW(require_table_size("rsid", kMostTableEntries + 1), std::invalid_argument);
}

TEST(TableSize, TheRefusalSaysWhatTheTableWouldTake) {
  const Rsid scheme = Rsid::with_precision(1e-6);  // 1.8e8 + 1 rows of 3.6e8: 6.5e16 entries
  const std::string text = test::thrown<std::invalid_argument>([&] { RadialTable<Rsid>{scheme}; });
  EXPECT_NE(text.find("64800000360000000 entries"), std::string::npos) << text;
  EXPECT_NE(text.find("5.18e+17 bytes"), std::string::npos) << text;
  EXPECT_NE(text.find("rsid"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

// The scheme itself has directions and stencils all the same, and its numbers pass 2^31 and 2^32.
TEST(TableSize, AWindowOfSuchATableCanBeRead) {
  const Rsid scheme = Rsid::with_precision(1e-6);
  const std::size_t entry = (std::size_t{3} << 40U) + 12345;
  const Stencil stencil = scheme.stencil(scheme.direction(entry));
  Vec3 seen = Vec3::Zero();
  for (std::size_t k = 0; k < stencil.taps; ++k)
    seen += stencil.weight[k] * scheme.direction(stencil.entry[k]);
  EXPECT_LT((seen - scheme.direction(entry)).norm(), 48.0 * 0x1p-53);
}

}  // namespace
}  // namespace impinge
