# SPDX-License-Identifier: GPL-3.0-or-later
# @name      cohort-comparison
# @question  Does the published spread of shape give the published spread of internal rotation?
# @data      cohort
# @seconds   2 2
"""Published populations of hips compared with a cohort of ours: degrees, and shares in percent. "given" numbers went into the
study, "found" numbers came out of it.
"""

import pandas as pd

import common
from common import cohort


def main(options) -> common.Table:
    table = cohort.comparison(common.load(options.results, "cohort"))
    return table, latex(table)


def latex(table: pd.DataFrame) -> str:
    lines = []
    for row in table.itertuples():
        published = "" if pd.isna(row.published) else f"{row.published:g}"
        lines.append([common.tex(row.statistic), published, row.role, f"{row.ours:.1f}", f"{row.low:.1f} to {row.high:.1f}"])
    return common.tabular("lrlrr", [["", "published", "", "here", "95\\,\\%"]], lines)


common.run(main)
