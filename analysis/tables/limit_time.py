# SPDX-License-Identifier: GPL-3.0-or-later
# @name      limit-time-by-method
# @question  What do the limits of all motions cost by each method, and which contacts do its steps miss?
# @data      limit_time
"""Error and processor time of the limits of all motions: our method compared with others' tests of touch in steps."""

import pandas as pd

import common
from common import limit_time


def main(options) -> common.Table:
    table = limit_time.load(options.results)
    columns = ["joint", "faces", "line", "step_deg", "motions", "asked", "missed", "extrapolated", "largest_error_deg",
               "median_error_deg", "building_ms", "cpu_ms", "times_ours"]
    rows = table[columns]
    return rows.rename(columns={"line": "method"}), latex(table)


def latex(table: pd.DataFrame) -> str:
    """A line per method and step, joint by joint; a star where times are extrapolated."""
    lines = []
    for row in table.itertuples():
        lines.append(
            [
                common.tex(limit_time.title(table[table.joint == row.joint])),
                common.tex(row.line),
                "" if pd.isna(row.step_deg) else rf"{row.step_deg:g}\degrees{{}}",
                f"{row.missed} of {row.asked}",
                "---" if row.method in limit_time.OURS else common.digits(row.largest_error_deg, 2),
                common.digits(row.building_ms, 2),
                common.digits(row.cpu_ms, 2) + ("*" if row.extrapolated else ""),
                common.digits(row.times_ours, 2),
            ]
        )
    head = [
        r" & & & & largest & building, & all motions, & times \\",
        r"joint & method & step & missed & error, \degrees{} & ms & ms & ours \\",
    ]
    return common.tabular("@{}lllrrrrr@{}", head, common.ruled(lines))


common.run(main)
