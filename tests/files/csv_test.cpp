// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csv.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "files/formatted.hpp"
#include "files/stopwatch.hpp"

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

// Ends of what is proven are shown outward.

TEST(Formatted, RoundsEndsOutward) {
  EXPECT_EQ(rounded_down(53.56, 1), "53.5");
  EXPECT_EQ(rounded_up(53.54, 1), "53.6");
  EXPECT_EQ(rounded_down(53.6, 1), "53.6");  // reads back as itself
  EXPECT_EQ(rounded_up(53.6, 1), "53.6");
  EXPECT_EQ(rounded_down(-0.04, 1), "-0.1");
  EXPECT_EQ(rounded_up(-0.04, 1), "0.0");
  EXPECT_EQ(rounded_down(0.05, 1), "0.0");
  EXPECT_EQ(rounded_up(99.999, 2), "100.00");
  EXPECT_EQ(rounded_down(180.0, 1), "180.0");
}

TEST(Formatted, IsWithinAUnitOfTheLastPlace) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> values(-200.0, 200.0);
  for (int k = 0; k < 10'000; ++k) {
    const double value = values(random);
    const int places = k % 5;
    const double low = std::stod(rounded_down(value, places));
    const double high = std::stod(rounded_up(value, places));
    ASSERT_LE(low, value);
    ASSERT_GE(high, value);
    ASSERT_NEAR(low, high, 1.000001 * std::pow(10.0, -places)) << value;
  }
}

// A lap takes no less than what was done in it, and begins where the last one ended.

TEST(Stopwatch, LapsAreWhatTheyLast) {
  using std::chrono::milliseconds;
  const auto before = std::chrono::steady_clock::now();
  Stopwatch watch;
  std::this_thread::sleep_for(milliseconds(4));
  const double first_ms = watch.lap_ms();
  std::this_thread::sleep_for(milliseconds(2));
  const double second_s = watch.lap_s();
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - before;
  EXPECT_GE(first_ms, 4.0);
  EXPECT_GE(second_s, 0.002);
  EXPECT_LE(1e-3 * first_ms + second_s, whole.count() + 1e-9);
}

}  // namespace
}  // namespace impinge
