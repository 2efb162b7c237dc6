// SPDX-License-Identifier: GPL-3.0-or-later
// What the rows of a cohort say together.
#pragma once

#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cohort/study.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// title, study, digest, seed, hips, columns, counts (of each word of M_state, of each hour of M_clock), and
// quantities: for each column of numbers
//   n, mean, sd
//   mesh   of the hips that were looked at twice: checked, and the 95th percentile and the largest of what
//   the
//          finer mesh changes
//   quantiles  p, value (type 7 of Hyndman and Fan), and two intervals; null for an end that is not known:
//     sampling        of the population's quantile, at least 95 %, whatever the distribution: order
//     statistics
//                     whose ranks follow from the binomial distribution (David and Nagaraja, Order
//                     Statistics)
//     mesh_and_centre of these hips' quantile: the quantiles of M_low_deg and M_high_deg, proven for every
//                     centre within half a millimetre, widened by the 95th percentile of `mesh`, which is
//                     measured
// csv: the rows, without a head. The same bytes for the same rows.
nlohmann::json summary_of(const Study& study, const std::vector<Column>& columns, std::string_view csv);

// Ranks, from 1, of the order statistics of n draws that hold the quantile p of their distribution between
// them with at least 95 %; 0 and n + 1 where no draw bounds it.
struct RankInterval {
  std::size_t low = 0;
  std::size_t high = 0;
};
RankInterval rank_interval(std::size_t n, double p);

}  // namespace impinge::lab
