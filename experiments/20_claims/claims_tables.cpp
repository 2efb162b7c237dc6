// SPDX-License-Identifier: GPL-3.0-or-later
#include "20_claims/claims_study.hpp"

namespace impinge::lab {

std::vector<Column> claims_keys() {
  return {{"claim", "", "of the thesis, Chapter 6"},
          {"setting", "", "of the experiment"},
          {"quantity", "", "what was measured"}};
}

ClaimsTables claims_tables(const ClaimsStudy& study, Progress& progress) {
  ClaimsTables tables;
  tables.timing = run_interleaved(study.cases, {}, progress);
  tables.table.columns = claims_keys();
  tables.table.columns.push_back({"value", "", "in the unit beside it; identical: 1"});
  tables.table.columns.push_back({"unit", "", "of the value"});
  for (const Claim& row : study.rows)
    tables.table.add_row({row.claim, row.setting, row.quantity, row.value, row.unit});
  for (const Timing& timing : tables.timing.timings) {
    std::vector<Cell> row = timing.key;
    row.emplace_back(1e3 * timing.summary.median);
    row.emplace_back("us");
    tables.table.add_row(std::move(row));
  }
  return tables;
}

}  // namespace impinge::lab
