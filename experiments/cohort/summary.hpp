// SPDX-License-Identifier: GPL-3.0-or-later
// Summarises the rows of a cohort.
#pragma once

#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cohort/study.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// Has title, study, digest, seed, hips, columns, counts (of each word of M_state, of each hour of M_clock),
// and quantities: for each column of numbers
//   n, mean, sd
//   without_limit  of M_deg alone: the other hips by their M_state. An angle, or a zone at its end, is
//              summarised where M is limited
//   mesh       for the hips that got a second look: their number, and the 95th percentile and the largest
//              change by the finer mesh
//   quantiles  p, value (type 7 of Hyndman and Fan), and two intervals; null for an unknown end:
//     sampling        holds the population's quantile with at least 95 %, whatever the distribution: order
//                     statistics with ranks from the binomial distribution (David and Nagaraja, Order
//                     Statistics)
//     mesh_and_centre holds the quantile of these hips: from M_low_deg and M_high_deg, which are proven for
//                     every centre within half a millimetre, widened by the 95th percentile of `mesh`, which
//                     is measured; unknown above where it rests on a hip without M_high_deg
// `csv` has the rows without a head. The same rows give the same bytes.
nlohmann::json summary_of(const Study& study, const std::vector<Column>& columns, std::string_view csv);

// Ranks, from 1, of two order statistics of n draws that hold the quantile p of their distribution between
// them with at least 95 %; 0 or n + 1 where no draw bounds it.
struct RankInterval {
  std::size_t low = 0;
  std::size_t high = 0;
};
RankInterval rank_interval(std::size_t n, double p);

}  // namespace impinge::lab
