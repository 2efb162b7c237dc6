// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csv.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(Csv, WritesHeaderAndRowsWithLineFeeds) {
  Table table{{{"method", "", "m"}, {"ms", "ms", "t"}, {"extrapolated", "", "e"}, {"rounds", "1", "r"}}, {}};
  table.add_row({"rsid", 0.1, false, 15});
  table.add_row({"pairwise", 1e22, true, std::size_t{0}});
  EXPECT_EQ(to_csv(table), "method,ms,extrapolated,rounds\nrsid,0.1,no,15\npairwise,1e+22,yes,0\n");
}

TEST(Csv, LeavesNoSurfaceAndAbsentValuesEmpty) {
  Table table{{{"a", "", ""}, {"b", "", ""}, {"c", "", ""}}, {}};
  table.add_row({Cell(), std::numeric_limits<double>::quiet_NaN(), 1});
  EXPECT_EQ(to_csv(table), "a,b,c\n,,1\n");
}

TEST(Csv, QuotesAsRfc4180Says) {
  EXPECT_EQ(Cell("plain text").text(), "plain text");
  EXPECT_EQ(Cell("a,b").text(), "\"a,b\"");
  EXPECT_EQ(Cell("say \"no\"").text(), "\"say \"\"no\"\"\"");
  EXPECT_EQ(Cell("two\nlines").text(), "\"two\nlines\"");
}

TEST(Csv, NumbersReadBackAsTheSameDouble) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 10000; ++i) {
    const double number = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 2000) - 1060);
    EXPECT_EQ(std::strtod(Cell(number).text().c_str(), nullptr), number);
  }
  EXPECT_EQ(Cell(0.1).text(), "0.1");
  EXPECT_EQ(Cell(std::numeric_limits<std::int64_t>::min()).text(), "-9223372036854775808");
  EXPECT_EQ(std::strtod(Cell(std::numeric_limits<double>::denorm_min()).text().c_str(), nullptr),
            std::numeric_limits<double>::denorm_min());
}

TEST(Csv, RefusesARowOfAnotherLength) {
  Table table{{{"a", "", ""}}, {}};
  EXPECT_THROW(table.add_row({1, 2}), std::invalid_argument);
  EXPECT_TRUE(table.rows.empty());
}

}  // namespace
}  // namespace impinge
